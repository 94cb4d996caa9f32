#include "file_kind.hpp"
#include "toile/base/error.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {

SurfacePtr make_from_file(const base::List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  return make_surface(list, nullptr);
}

SurfacePtr make_surface(const base::List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  list.fail("type", "this build of Toile has no bodies and no contact (configured with TOILE_ENABLE_BODY=OFF)");
}

struct TriangleTree::Data {};
TriangleTree::TriangleTree(const TriangleMesh&) {
  throw base::Error(base::ExitCode::internal_error, "a tree of triangles is asked of a build without bodies");
}
TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;
TriangleTree::Hit TriangleTree::closest(const Vec3&) const {
  return {};
}
std::vector<TriangleTree::Hit> TriangleTree::crossings(const Vec3&, const Vec3&) const {
  return {};
}

}  // namespace toile::body
