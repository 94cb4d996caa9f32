#include "kinds.hpp"
#include "span.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

SurfacePtr make_cylinder(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  return revolution(linear_profile(list.real("radius"), 0.0), read_span(list), "cylinder");
}

}  // namespace

Kind cylinder_kind() {
  Spec spec("cylinder", "Circular cylinder about z.");
  spec.real("radius", "mm", "Radius.", base::required, Range::positive());
  add_span(spec, 0.0, 200.0);
  return {spec, make_cylinder};
}

}  // namespace toile::body
