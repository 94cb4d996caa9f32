#include "file_kind.hpp"
#include "toile/base/error.hpp"
#include "toile/body/border.hpp"
#include "toile/body/import.hpp"
#include "toile/body/landmarks.hpp"
#include "toile/body/mannequin.hpp"
#include "toile/body/section.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {
namespace {

[[noreturn]] void refuse() {
  throw base::InputError("this build of Toile has no bodies (configured with TOILE_ENABLE_BODY=OFF)");
}

}  // namespace

Import import_body(const std::string& /*file*/, const ImportOptions& /*options*/) {
  refuse();
}

struct Sections::Data {};
Sections::Sections(const TriangleMesh& /*mesh*/) {
  refuse();
}
Sections::~Sections() = default;
Sections::Sections(Sections&&) noexcept = default;
Sections& Sections::operator=(Sections&&) noexcept = default;
std::vector<SectionPiece> Sections::cut(const Vec3& /*point*/, const Vec3& /*normal*/) const {
  return {};
}
std::vector<Vec3> Sections::shortest_way(const Vec3& /*from*/, const Vec3& /*to*/) const {
  return {};
}
double Sections::length_on_surface(const Vec3& /*from*/, const Vec3& /*to*/) const {
  return 0.0;
}
double tape_girth(const std::vector<Vec3>& /*points*/, const Vec3& /*normal*/) {
  refuse();
}
Extent extent_of(const TriangleMesh& /*mesh*/) {
  refuse();
}
std::vector<char> border_vertices(const TriangleMesh& /*mesh*/) {
  refuse();
}
Mannequin make_mannequin(const TriangleMesh& /*body*/, const std::vector<Measurement>& /*measurements*/,
                         const MannequinOptions& /*options*/) {
  refuse();
}
Landmarks landmarks_of(const base::List& /*list*/) {
  refuse();
}
Landmarks find_landmarks(const TriangleMesh& /*mesh*/) {
  refuse();
}
Landmarks find_landmarks(const TriangleMesh& /*mesh*/, const std::string& /*file*/) {
  refuse();
}

SurfacePtr make_from_file(const base::List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  return make_surface(list, nullptr);
}
SurfacePtr make_from_measurements(const base::List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
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
