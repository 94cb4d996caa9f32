#include "toile/material/read_laws.hpp"

#include "toile/material/formula.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::material {

Laws read_laws(const std::string& file, const std::string& root, bool allow_plugins) {
  Laws laws;
  if (const auto plugins = base::read_part(file, root, plugins_spec())) add_plugins(*plugins, allow_plugins, laws);
  if (const auto formulas = base::read_part(file, root, formulas_spec())) add_formulas(*formulas, laws);
  return laws;
}

}  // namespace toile::material
