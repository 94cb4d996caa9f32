#include "toile/material/read_laws.hpp"

#include "toile/material/formula.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::material {

namespace {

/// Of a file by its name, or of its content.
template <class Source>
Laws laws_of(const Source& source, const std::string& root, bool allow_plugins) {
  Laws laws;
  if (const auto plugins = base::read_part(source, root, plugins_spec())) add_plugins(*plugins, allow_plugins, laws);
  if (const auto formulas = base::read_part(source, root, formulas_spec())) add_formulas(*formulas, laws);
  return laws;
}

}  // namespace

Laws read_laws(const std::string& file, const std::string& root, bool allow_plugins) {
  return laws_of(file, root, allow_plugins);
}

Laws read_laws(const base::Content& content, const std::string& root, bool allow_plugins) {
  return laws_of(content, root, allow_plugins);
}

}  // namespace toile::material
