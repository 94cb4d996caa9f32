#include "file_kind.hpp"
#include "toile/body/mannequin.hpp"

namespace toile::body {
namespace {

using base::Range;
using base::Spec;

Spec mannequin_spec() {
  Spec spec(
      "mannequin",
      "A dress form made to measurements, as by \"toile body make\": without head, hands and feet, its floor at z "
      "= 0. What is not given follows what is: girths of the upper body the bust, those of the legs the hip.");
  for (const Measurement& m : complete_measurements({})) {
    const std::string what = m.name == "height"           ? "Height of the body with its head and feet."
                             : m.name == "shoulder width" ? "Distance of the shoulder points."
                                                          : "Tape girth at the " + m.name + ".";
    spec.real(m.name, "mm", what, m.value, Range::positive());
  }
  spec.real("arms", "degrees", "Angle of the upper arms below the level; if it is not given, as the body holds them.",
            47.7, Range::between(-90.0, 90.0));
  spec.real("edge", "mm", "Edge length of its facets.", 10.0, Range::between(4.0, 25.0));
  spec.word(
      "from",
      "Path, from the folder of the scene, of the body that is changed: OBJ, STL, PLY or OFF, standing, with head, "
      "hands and feet, in mm. Empty: the body that Toile comes with.",
      std::string());
  return add_fit(spec);
}

}  // namespace

Kind mannequin_kind() {
  return {mannequin_spec(), make_from_measurements};
}

}  // namespace toile::body
