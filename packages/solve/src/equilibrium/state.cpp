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
  for (size_t b = 0; b < problem.models.size(); ++b)
    for (const int node : problem.mesh->blocks[b].connectivity)
      shell[node] = shell[node] || problem.models[b].is_shell();
  return shell;
}

std::vector<std::vector<Vec3>> symmetry_planes(const Problem& problem) {
  constexpr double same = 1e-6;
  std::vector<std::vector<Vec3>> planes(problem.mesh->nodes());
  for (const Support& support : problem.supports) {
    if (support.director != DirectorSupport::symmetry) continue;
    for (size_t k = 0; k < support.nodes.size(); ++k)
      for (Eigen::Index i = 0; i < 3; ++i) {
        if (!support.held[static_cast<size_t>(i)]) continue;
        std::vector<Vec3>& normals = planes[support.nodes[k]];
        Vec3 normal = support.axis(k, i);
        for (const Vec3& other : normals) normal -= normal.dot(other) * other;
        if (normal.norm() > same) normals.push_back(normal.normalized());
      }
  }
  return planes;
}

Vec3 diaphragm_normal(const Support& support, size_t node, const Vec3& director) {
  Vec3 sliding = Vec3::Zero();
  for (Eigen::Index i = 0; i < 3; ++i)
    if (!support.held[static_cast<size_t>(i)]) sliding += support.axis(node, i);
  return sliding.cross(director);
}

namespace {

/// [node] directors at the start: normals of the placed panel, in the planes of symmetry.
std::vector<Vec3> start_directors(const Problem& problem, const std::vector<std::vector<Vec3>>& planes) {
  std::vector<Vec3> directors = problem.mesh->normal;
  for (size_t n = 0; n < planes.size(); ++n) {
    for (const Vec3& normal : planes[n]) directors[n] -= directors[n].dot(normal) * normal;
    directors[n].normalize();
  }
  return directors;
}

/// The frame of a director with t_1 as close to `wanted` as can be.
Frame frame_of(const Vec3& director, const Vec3& wanted) {
  const Vec3 t1 = (wanted - wanted.dot(director) * director).normalized();
  Frame frame;
  frame << t1.transpose(), director.cross(t1).transpose(), director.transpose();
  return frame;
}

/// [node] what the first tangent is to be: the normal of the plane that a support keeps the director in, if there is
/// one.
std::vector<Vec3> wanted_tangents(const Problem& problem, const std::vector<std::vector<Vec3>>& planes,
                                  const std::vector<Vec3>& directors) {
  std::vector<Vec3> wanted(directors.size());
  for (size_t n = 0; n < directors.size(); ++n) {
    Eigen::Index smallest = 0;
    directors[n].cwiseAbs().minCoeff(&smallest);
    wanted[n] = Vec3::Unit(smallest);
  }
  for (const Support& support : problem.supports) {
    if (support.director != DirectorSupport::diaphragm) continue;
    for (size_t k = 0; k < support.nodes.size(); ++k)
      wanted[support.nodes[k]] = diaphragm_normal(support, k, directors[support.nodes[k]]);
  }
  for (size_t n = 0; n < directors.size(); ++n)
    if (!planes[n].empty()) wanted[n] = planes[n].front();
  return wanted;
}

}  // namespace

std::vector<Frame> start_frames(const Problem& problem) {
  const std::vector<bool> shell = shell_nodes(problem);
  std::vector<Frame> frames(shell.size(), Frame::Identity());
  if (std::find(shell.begin(), shell.end(), true) == shell.end()) return frames;
  const std::vector<std::vector<Vec3>> planes = symmetry_planes(problem);
  const std::vector<Vec3> directors = start_directors(problem, planes);
  const std::vector<Vec3> wanted = wanted_tangents(problem, planes, directors);
  for (size_t n = 0; n < shell.size(); ++n)
    if (shell[n]) frames[n] = frame_of(directors[n], wanted[n]);
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
