#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "toile/solve/problem.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::solve {

Vec3 node_position(const Problem& problem, const State& state, int cluster, int node) {
  const int master = problem.clusters[cluster].front();
  const Vec3 separation = problem.mesh->placed[node] - problem.mesh->placed[master];
  return state.position[cluster] + (1.0 - state.seam) * separation;
}

State placed_state(const Problem& problem) {
  State state;
  for (const std::vector<int>& members : problem.clusters)
    state.position.push_back(problem.mesh->placed[members.front()]);
  state.contact_force.assign(problem.clusters.size(), 0.0);
  state.offset.assign(problem.clusters.size(), 0.0);
  const std::vector<bool> shell = shell_nodes(problem);
  if (std::find(shell.begin(), shell.end(), true) == shell.end()) return state;
  state.rotation.assign(shell.size(), {0.0, 0.0});
  state.frame = start_frames(problem);
  return state;
}

std::vector<bool> shell_nodes(const Problem& problem) {
  std::vector<bool> shell(problem.mesh->nodes(), false);
  for (size_t b = 0; b < problem.laws.size(); ++b)
    for (const int node : problem.mesh->blocks[b].connectivity) shell[node] = shell[node] || problem.laws[b].is_shell();
  return shell;
}

std::vector<std::array<bool, 3>> symmetry_planes(const Problem& problem) {
  std::vector<std::array<bool, 3>> planes(problem.mesh->nodes(), {false, false, false});
  for (const Support& support : problem.supports) {
    if (support.director != DirectorSupport::symmetry) continue;
    for (const int node : support.nodes)
      for (size_t i = 0; i < 3; ++i) planes[node][i] = planes[node][i] || support.held[i];
  }
  return planes;
}

namespace {

Frame start_frame(const Vec3& normal, const std::array<bool, 3>& planes) {
  Vec3 d = normal;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (planes[static_cast<size_t>(i)]) d[i] = 0.0;
  d.normalize();
  Eigen::Index along = 0;
  d.cwiseAbs().minCoeff(&along);
  const auto* plane = std::find(planes.begin(), planes.end(), true);
  if (plane != planes.end()) along = plane - planes.begin();
  const Vec3 wanted = Vec3::Unit(along);
  const Vec3 t1 = (wanted - wanted.dot(d) * d).normalized();
  Frame frame;
  frame << t1.transpose(), d.cross(t1).transpose(), d.transpose();
  return frame;
}

}  // namespace

std::vector<Frame> start_frames(const Problem& problem) {
  const std::vector<bool> shell = shell_nodes(problem);
  const std::vector<std::array<bool, 3>> planes = symmetry_planes(problem);
  std::vector<Frame> frames(shell.size(), Frame::Identity());
  for (size_t n = 0; n < shell.size(); ++n)
    if (shell[n]) frames[n] = start_frame(problem.mesh->normal[n], planes[n]);
  return frames;
}

Frame rotated(const Frame& frame, double w1, double w2) {
  const double angle = std::hypot(w1, w2);
  if (angle == 0.0) return frame;
  const Vec3 axis = (w1 * frame.row(1) - w2 * frame.row(0)).transpose() / angle;
  return frame * Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix().transpose();
}

Vec3 ForceBalance::sum() const {
  Vec3 total = contact + load + damping;
  for (const Vec3& reaction : support) total += reaction;
  return total;
}

}  // namespace toile::solve
