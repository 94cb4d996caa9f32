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
  for (int n = 0; n < problem.mesh->nodes(); ++n)
    state.frame.push_back(shell[n] ? start_frame(problem, n) : Frame::Identity());
  return state;
}

std::vector<bool> shell_nodes(const Problem& problem) {
  std::vector<bool> shell(problem.mesh->nodes(), false);
  for (size_t b = 0; b < problem.laws.size(); ++b)
    for (const int node : problem.mesh->blocks[b].connectivity) shell[node] = shell[node] || problem.laws[b].is_shell();
  return shell;
}

std::vector<Vec3> symmetry_normals(const Problem& problem, int node) {
  std::vector<Vec3> normals;
  for (const Support& support : problem.supports)
    if (support.director == DirectorSupport::symmetry &&
        std::find(support.nodes.begin(), support.nodes.end(), node) != support.nodes.end())
      for (int i = 0; i < 3; ++i)
        if (support.held[i]) normals.push_back(Vec3::Unit(i));
  return normals;
}

namespace {

/// Director at the start.
Vec3 placed_director(const Problem& problem, int node) {
  Vec3 d = problem.mesh->normal[node];
  for (const Vec3& n : symmetry_normals(problem, node)) d -= n.dot(d) * n;
  return d.normalized();
}

}  // namespace

Vec3 diaphragm_normal(const Problem& problem, const Support& support, int node) {
  const Vec3 sliding(support.held[0] ? 0.0 : 1.0, support.held[1] ? 0.0 : 1.0, support.held[2] ? 0.0 : 1.0);
  return sliding.cross(placed_director(problem, node));
}

Frame start_frame(const Problem& problem, int node) {
  const Vec3 d = placed_director(problem, node);
  std::vector<Vec3> planes = symmetry_normals(problem, node);
  for (const Support& support : problem.supports)
    if (support.director == DirectorSupport::diaphragm &&
        std::find(support.nodes.begin(), support.nodes.end(), node) != support.nodes.end())
      planes.push_back(diaphragm_normal(problem, support, node));
  Eigen::Index smallest = 0;
  d.cwiseAbs().minCoeff(&smallest);
  const Vec3 wanted = planes.empty() ? Vec3::Unit(smallest).eval() : planes.front();
  const Vec3 t1 = (wanted - wanted.dot(d) * d).normalized();
  Frame frame;
  frame << t1.transpose(), d.cross(t1).transpose(), d.transpose();
  return frame;
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
