#include "kinds.hpp"
#include "span.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

SurfacePtr make_cone(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  const Span span = read_span(list);
  const double radius = list.real("radius");
  const double slope = list.real("slope");
  if (radius + slope * span.bottom <= 0.0 || radius + slope * span.top <= 0.0) {
    list.fail("slope", "the radius must stay positive between bottom and top");
  }
  return revolution(linear_profile(radius, slope), span, "cone");
}

}  // namespace

Kind cone_kind() {
  Spec spec("cone", "Cone about z, up to its tip: its radius is 'radius' + 'slope' z.");
  spec.real("radius", "mm", "Radius at z = 0.", base::required, Range::positive());
  spec.real("slope", "", "Increase of the radius per height.", base::required);
  add_span(spec, 0.0, 200.0);
  return {spec, make_cone};
}

}  // namespace toile::body
