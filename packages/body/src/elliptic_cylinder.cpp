#include "kinds.hpp"
#include "span.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

SurfacePtr make_elliptic_cylinder(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  return elliptic_cylinder(list.real("a"), list.real("b"), read_span(list));
}

}  // namespace

Kind elliptic_cylinder_kind() {
  Spec spec("elliptic cylinder", "Elliptic cylinder about z.");
  spec.real("a", "mm", "Semi-axis along x.", base::required, Range::positive());
  spec.real("b", "mm", "Semi-axis along y.", base::required, Range::positive());
  add_span(spec, 0.0, 200.0);
  return {spec, make_elliptic_cylinder};
}

}  // namespace toile::body
