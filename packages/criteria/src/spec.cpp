#include <algorithm>

#include "toile/criteria/check.hpp"
#include "toile/material/formula.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::criteria {
namespace {

constexpr const char* list_text =
    "States F = [[wale stretch, shear], [0, course stretch]] at which `toile material check` tries the fabric, and "
    "what "
    "must hold.";

/// States of a map that fit into a small machine's memory (about 300 bytes each).
constexpr double largest_map = 4e6;

/// A scene's material under the fixed name of this file.
base::Spec material_list(const material::Laws& laws) {
  const base::Spec scene = material::material_spec(laws);
  base::Spec spec("Material", "The fabric, as in a scene's list Materials.");
  for (const base::Parameter& parameter : scene.parameters()) {
    const auto& all = scene.variants();
    const auto selected =
        std::find_if(all.begin(), all.end(), [&](const auto& v) { return v.first == parameter.name; });
    if (selected == all.end())
      spec.add(parameter);
    else
      spec.variant(parameter.name, parameter.text, selected->second, parameter.fallback);
  }
  return spec;
}

std::array<double, 2> range_of(const base::List& list, const std::string& name, bool may_be_one_value) {
  const base::Reals& values = list.reals(name);
  if (values.size() != 2)
    list.fail(name, std::to_string(values.size()) + " values, expected two: the least and the greatest");
  if (values[0] > values[1])
    list.fail(name, "the range is reversed: " + figure(values[0]) + " to " + figure(values[1]) +
                        "; the least value goes first");
  if (values[0] == values[1] && !may_be_one_value)
    list.fail(name, "the box is empty: the range holds the single stretch " + figure(values[0]) +
                        "; the greatest value must be above the least");
  return {values[0], values[1]};
}

}  // namespace

base::Spec check_spec() {
  const Request fallback;
  const auto both = [](const std::array<double, 2>& range) { return base::Reals{range[0], range[1]}; };
  base::Spec spec("Check", list_text);
  spec.reals("wale stretch", "", "Least and greatest stretch along the wale.", both(fallback.wale),
             base::Range::positive())
      .reals("course stretch", "", "Least and greatest stretch along the course.", both(fallback.course),
             base::Range::positive())
      .reals("shear", "",
             "Least and greatest shear F12: shift along the wale over length along the course. Twice the same value is "
             "that one shear.",
             both(fallback.shear))
      .integer("points", "States along each stretch.", fallback.points, base::Range::between(2, 1000))
      .integer("shear points", "States along the shear.", fallback.shear_points, base::Range::between(2, 200))
      .choice("symmetry", "Material symmetry that the law must have; none: it is only told.",
              {"none", "orthotropic", "isotropic"}, std::string("orthotropic"));
  std::string names;
  for (const std::string& name : Request::all()) names += (names.empty() ? "" : ", ") + name;
  spec.words("criteria",
             "What must hold for exit status 0; the others are told all the same. Known: " + names +
                 ". In tension: at states both of whose principal stresses are tensile.",
             fallback.required);
  return spec;
}

base::Spec file_spec(const material::Laws& laws) {
  base::Spec spec("fabric", "One fabric and how it is checked.");
  return spec.add(base::include_parameter())
      .list(material::plugins_spec())
      .list(material::formulas_spec())
      .list(material_list(laws), true)
      .list(check_spec());
}

Request read_request(const base::List& list) {
  Request request;
  request.wale = range_of(list, "wale stretch", false);
  request.course = range_of(list, "course stretch", false);
  request.shear = range_of(list, "shear", true);
  request.points = list.integer("points");
  request.shear_points = list.integer("shear points");
  const double states = 1.0 * request.points * request.points * request.shear_points;
  if (states > largest_map)
    list.fail("points", "a map of " + figure(states, 3) + " states is too large; allowed are " +
                            figure(largest_map, 3) + " (points^2 times \"shear points\")");
  const std::string& symmetry = list.word("symmetry");
  request.symmetry = symmetry == "none"          ? Symmetry::none
                     : symmetry == "orthotropic" ? Symmetry::orthotropic
                                                 : Symmetry::isotropic;
  request.required = list.words("criteria");
  const base::Texts known = Request::all();
  for (const std::string& name : request.required)
    if (std::find(known.begin(), known.end(), name) == known.end())
      list.fail("criteria", "unknown criterion \"" + name + "\"" + base::hint(name, known));
  return request;
}

}  // namespace toile::criteria
