#include "kinds.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

SurfacePtr make_ellipsoid(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  return ellipsoid(list.real("radius"), list.real("half height"));
}

SurfacePtr make_sphere(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  return ellipsoid(list.real("radius"), list.real("radius"));
}

}  // namespace

Kind ellipsoid_kind() {
  Spec spec("ellipsoid", "Ellipsoid of revolution about z, with its centre in the origin.");
  spec.real("radius", "mm", "Semi-axis along x and y.", base::required, Range::positive());
  spec.real("half height", "mm", "Semi-axis along z.", base::required, Range::positive());
  return {spec, make_ellipsoid};
}

Kind sphere_kind() {
  Spec spec("sphere", "Sphere about the origin.");
  spec.real("radius", "mm", "Radius.", base::required, Range::positive());
  return {spec, make_sphere};
}

}  // namespace toile::body
