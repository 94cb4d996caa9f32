#include "equilibrium/limb_directions.hpp"

#include <Eigen/Geometry>
#include <sstream>

#include "input/read.hpp"

namespace toile::solve {

namespace {

[[noreturn]] void fail_at(const base::List& entry, const Vec3& x, const std::string& what) {
  std::ostringstream text;
  text << "at the node placed at (" << x[0] << ", " << x[1] << ", " << x[2] << ") mm " << what;
  entry.fail("hold", text.str());
}

}  // namespace

std::vector<Frame> limb_directions(const base::List& entry, const Problem& problem, const std::vector<int>& nodes) {
  constexpr double least = 0.1;  // of the limb's direction, in the tangent plane
  if (problem.surface == nullptr)
    entry.fail("hold",
               "\"along the limb\" is a direction on the body's surface, and the scene has no list \"Body\"; "
               "\"direction\" does not need one");
  const mesh::Mesh& mesh = *problem.mesh;
  const bool given = entry.given("direction");
  const Vec3 wanted = given ? read_vector(entry, "direction") : Vec3(Vec3::Zero());
  if (given && wanted.norm() == 0.0) entry.fail("direction", "must not be zero");
  std::vector<const std::vector<int>*> members(mesh.pattern.size());
  for (const std::vector<int>& cluster : problem.clusters)
    for (const int n : cluster) members[n] = &cluster;
  std::vector<Frame> axes;
  for (const int node : nodes) {
    Vec3 x = Vec3::Zero(), limb = wanted;
    for (const int n : *members[node]) {
      x += mesh.placed[n] / static_cast<double>(members[node]->size());
      if (!given && !mesh.axis.empty()) limb += mesh.axis[n];
    }
    if (limb.norm() == 0.0)
      fail_at(entry, x,
              "the limb's direction is not known, because its panel is not wrapped round an axis; give "
              "\"direction\"");
    const body::SurfacePoint point = problem.surface->closest(x);
    if (!point.found) fail_at(entry, x, "the body's surface is out of reach; place the panel nearer to the body");
    const Vec3 along = limb.normalized() - limb.normalized().dot(point.normal) * point.normal;
    if (along.norm() < least)
      fail_at(entry, x, "the limb's direction stands on the body's surface; give another \"direction\"");
    Frame frame;
    frame << along.normalized().transpose(), point.normal.cross(along.normalized()).transpose(),
        point.normal.transpose();
    axes.push_back(frame);
  }
  return axes;
}

}  // namespace toile::solve
