#include <algorithm>
#include <array>
#include <cmath>

#include "kinds.hpp"
#include "span.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

Spec leg_spec() {
  Spec spec("leg", "Leg with circular sections about z, through four girths; its slope is zero at the ankle.");
  struct Level {
    const char* name;
    double girth, height;
  };
  for (const Level& level : {Level{"ankle", 205.0, 114.0}, Level{"calf", 340.0, 334.0}, Level{"knee", 310.0, 423.0},
                             Level{"thigh", 520.0, 728.0}}) {
    const std::string name = level.name;
    spec.real(name + " girth", "mm", "Girth at the level of the " + name + ".", level.girth, Range::positive());
    spec.real(name + " level", "mm", "Height z of that level; levels increase from ankle to thigh.", level.height);
  }
  return add_span(spec, 80.0, 760.0);
}

SurfacePtr make_leg(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  const std::array<std::string, 4> names{"ankle", "calf", "knee", "thigh"};
  std::vector<double> levels, radii;
  for (const std::string& name : names) {
    if (!levels.empty() && list.real(name + " level") <= levels.back()) {
      list.fail(name + " level", "must be above the level before it (ankle, calf, knee, thigh)");
    }
    levels.push_back(list.real(name + " level"));
    radii.push_back(list.real(name + " girth") / (2.0 * M_PI));
  }
  const std::string& narrowest = names[std::min_element(radii.begin(), radii.end()) - radii.begin()];
  return positive_revolution(list, narrowest + " girth", spline_profile(levels, radii, LowerEnd::mirrored),
                             {levels.front(), levels.back()}, read_span(list), "leg");
}

}  // namespace

Kind leg_kind() {
  return {leg_spec(), make_leg};
}

}  // namespace toile::body
