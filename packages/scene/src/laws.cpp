#include "toile/material/formula.hpp"
#include "toile/material/plugin_files.hpp"
#include "toile/scene/scene.hpp"

namespace toile::scene {

material::Laws read_laws(const std::string& file, bool allow_plugins) {
  material::Laws laws;
  const std::string root = scene_spec().name();
  if (const auto plugins = base::read_part(file, root, material::plugins_spec()))
    material::add_plugins(*plugins, allow_plugins, laws);
  if (const auto formulas = base::read_part(file, root, material::formulas_spec()))
    material::add_formulas(*formulas, laws);
  return laws;
}

}  // namespace toile::scene
