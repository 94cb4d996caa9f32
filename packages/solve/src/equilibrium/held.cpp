#include "equilibrium/held.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::solve {

namespace {

/// Whether a support holds the rotation that moves a director along `tangent`, the first of which start_frames laid
/// along the normal of the plane that the director of the support's node number `node` stays in. `start`: the director
/// at the start.
bool holds(const Support& support, size_t node, const Vec3& tangent, const Vec3& start) {
  constexpr double along = 0.9;
  switch (support.director) {
    case DirectorSupport::free:
      return false;
    case DirectorSupport::held:
      return true;
    case DirectorSupport::symmetry:
      for (Eigen::Index d = 0; d < 3; ++d)
        if (support.held[static_cast<size_t>(d)] && std::abs(tangent.dot(support.axis(node, d))) > along) return true;
      return false;
    case DirectorSupport::diaphragm:
      return std::abs(tangent.dot(diaphragm_normal(support, node, start).normalized())) > along;
  }
  return false;
}

/// Which rotations the supports hold: all of a clamp, and those out of a plane of symmetry or of a diaphragm.
std::vector<std::array<bool, 2>> held_rotations(const Problem& problem, const State& state,
                                                const std::set<std::string>& released) {
  std::vector<std::array<bool, 2>> held;
  for (const bool is_shell : shell_nodes(problem)) held.push_back({!is_shell, !is_shell});
  const std::vector<Frame> start = start_frames(problem);
  for (const Support& support : problem.supports) {
    if (released.count(support.name)) continue;
    for (size_t i = 0; i < support.nodes.size(); ++i)
      for (Eigen::Index k = 0; k < 2; ++k) {
        const int node = support.nodes[i];
        if (holds(support, i, state.frame[node].row(k), start[node].row(2))) held[node][static_cast<size_t>(k)] = true;
      }
  }
  return held;
}

}  // namespace

// 1 - cos as a square, so that a small turn keeps its digits.
double HeldComponent::position(double share) const {
  const double half = std::sin(0.5 * share * angle);
  return base + share * displacement - 2.0 * half * half * radial + std::sin(share * angle) * tangential;
}

Held find_held(const Problem& problem, const State& state, const std::set<std::string>& released) {
  Held held;
  if (const auto found = hold_positions(problem, released, held))
    throw base::InputError("supports contradict each other: supports \"" + problem.supports[found->first].name +
                           "\" and \"" + problem.supports[found->second].name + "\" hold node " +
                           std::to_string(found->node) + " differently");
  if (state.frame.empty()) return held;
  held.rotation = held_rotations(problem, state, released);
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    if (!support.turn || support.director != DirectorSupport::held || released.count(support.name)) continue;
    held.turned_by.resize(held.rotation.size(), -1);
    for (const int node : support.nodes) held.turned_by[node] = static_cast<int>(s);
  }
  return held;
}

std::array<double, 2> rotation_to(const Frame& frame, const Vec3& director) {
  const Vec3 along = frame * director;
  const double across = std::hypot(along[0], along[1]), angle = std::atan2(across, along[2]);
  if (across == 0.0) return {angle, 0.0};
  return {angle * along[0] / across, angle * along[1] / across};
}

}  // namespace toile::solve
