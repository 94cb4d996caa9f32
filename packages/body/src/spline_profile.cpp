#include <algorithm>
#include <functional>

#include "kinds.hpp"
#include "span.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

SurfacePtr make_profile(const List& list, const Region* /*region*/, BodyFindings* findings) {
  const auto& levels = list.reals("levels");
  if (levels.size() < 2 || std::adjacent_find(levels.begin(), levels.end(), std::greater_equal<>()) != levels.end()) {
    list.fail("levels", "needs two or more heights in increasing order");
  }
  if (list.reals("radii").size() != levels.size()) {
    list.fail("radii", "needs one radius for each of the " + std::to_string(levels.size()) + " levels");
  }
  const Span span{levels.front(), levels.back()};
  if (findings != nullptr) findings->known_heights = {levels.front(), levels.back()};
  return positive_revolution(list, "radii", spline_profile(levels, list.reals("radii")), span, span, "profile");
}

}  // namespace

Kind profile_kind() {
  Spec spec("profile", "Body of revolution about z through given radii, a cubic spline with continuous curvature.");
  spec.reals("levels", "mm", "Heights z, increasing, two or more.", base::required);
  spec.reals("radii", "mm", "Radius at each level.", base::required, Range::positive());
  return {spec, make_profile};
}

}  // namespace toile::body
