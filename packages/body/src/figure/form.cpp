#include "figure/form.hpp"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <sstream>

#include "figure/cgal_mesh.hpp"
#include "figure/cut_limb.hpp"
#include "figure/operators.hpp"
#include "toile/base/error.hpp"
#include "toile/body/section.hpp"

namespace toile::body {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

TriangleMesh remeshed(const TriangleMesh& mesh, double edge) {
  CgalMesh surface = cgal_mesh(mesh);
  pmp::isotropic_remeshing(faces(surface), edge, surface, CGAL::parameters::number_of_iterations(4));
  return triangles_of(surface);
}

}  // namespace

TriangleMesh dress_form(const TriangleMesh& body, const Landmarks& landmarks, double edge) {
  // Shares of the body's height by which limbs go on beyond their thinnest place, so that it stays the thinnest. Right
  // above that of the neck the chin begins.
  constexpr double beyond_neck = -0.003, beyond_wrist = 0.014, below_ankle = 0.016;
  constexpr double cap = 0.5, smoothing = 10.0;  // mm
  const double height = landmarks.at("crown").point.z() - extent_of(body).lower.z();
  TriangleMesh form = body;
  const auto cut = [&](const Landmark& at, const Vec3& outwards, double further) {
    form = cut_off(form, at.point + further * height * outwards, outwards, cap, edge);
  };
  cut(landmarks.at("neck"), Vec3::UnitZ(), beyond_neck);
  for (const std::string side : {"left ", "right "}) {
    const Landmark& wrist = landmarks.at(side + "wrist");
    cut(wrist, wrist.normal, beyond_wrist);
    cut(landmarks.at(side + "ankle"), -Vec3::UnitZ(), below_ankle);
  }
  return faired(remeshed(form, edge), smoothing);
}

void check_intersections(const TriangleMesh& mesh, const std::string& when) {
  const CgalMesh surface = cgal_mesh(mesh);
  std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> pairs;
  pmp::self_intersections(surface, std::back_inserter(pairs));
  if (pairs.empty()) {
    return;
  }
  const Vec3& place = mesh.vertices[mesh.triangles[pairs.front().first.idx()][0]];
  std::ostringstream text;
  text.precision(3);
  text << when << " the surface would pass through itself: " << pairs.size() << " pairs of facets intersect, one near ("
       << place.x() << ", " << place.y() << ", " << place.z() << ") mm";
  throw base::InputError(text.str());
}

}  // namespace toile::body
