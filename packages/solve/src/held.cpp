#include "held.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::solve {

namespace {

std::vector<std::array<HeldComponent, 3>> held_positions(const Problem& problem,
                                                         const std::set<std::string>& released) {
  std::vector<int> cluster_of(problem.mesh->nodes());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  std::vector<std::array<HeldComponent, 3>> held(problem.clusters.size());
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    if (released.count(support.name)) continue;
    for (const int node : support.nodes)
      for (int i = 0; i < 3; ++i) {
        if (!support.held[i]) continue;
        HeldComponent& h = held[cluster_of[node]][i];
        const HeldComponent found =
            held_component(problem, s, i, problem.mesh->placed[problem.clusters[cluster_of[node]].front()]);
        if (h.held && !move_alike(problem, h, found))
          throw base::InputError("supports contradict each other: supports \"" + problem.supports[h.support].name +
                                 "\" and \"" + support.name + "\" move node " + std::to_string(node) +
                                 " differently in direction " + "xyz"[i]);
        h = found;
      }
  }
  return held;
}

/// Whether a support holds the rotation that moves a director along `tangent`, the first of which start_frames laid
/// along the normal of the plane that the director stays in. `start`: the director at the start.
bool holds(const Support& support, const Vec3& tangent, const Vec3& start) {
  constexpr double along = 0.9;
  switch (support.director) {
    case DirectorSupport::free:
      return false;
    case DirectorSupport::held:
      return true;
    case DirectorSupport::symmetry:
      for (Eigen::Index d = 0; d < 3; ++d)
        if (support.held[static_cast<size_t>(d)] && std::abs(tangent[d]) > along) return true;
      return false;
    case DirectorSupport::diaphragm:
      return std::abs(tangent.dot(diaphragm_normal(support, start).normalized())) > along;
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
    for (const int node : support.nodes)
      for (Eigen::Index k = 0; k < 2; ++k)
        if (holds(support, state.frame[node].row(k), start[node].row(2))) held[node][static_cast<size_t>(k)] = true;
  }
  return held;
}

}  // namespace

// 1 - cos as a square, so that a small turn keeps its digits.
double HeldComponent::position(double share) const {
  const double half = std::sin(0.5 * share * angle);
  return base + share * displacement - 2.0 * half * half * radial + std::sin(share * angle) * tangential;
}

bool move_alike(const Problem& problem, const HeldComponent& a, const HeldComponent& b) {
  constexpr double same = 1e-9;  // mm
  const auto differ = [](double x, double y) { return std::abs(x - y) > same; };
  if (differ(a.displacement, b.displacement)) return false;
  const auto turns = [&](const HeldComponent& h) {
    return h.angle != 0.0 && (differ(h.radial, 0.0) || differ(h.tangential, 0.0));
  };
  const bool turn = turns(a) || turns(b);
  if (turn && (a.angle != b.angle || differ(a.radial, b.radial) || differ(a.tangential, b.tangential))) return false;
  const auto path = [&](const HeldComponent& h) { return problem.supports[static_cast<size_t>(h.support)].path; };
  return (!turn && !differ(a.displacement, 0.0)) || path(a) == path(b);
}

HeldComponent held_component(const Problem& problem, size_t index, int direction, const Vec3& placed) {
  const Support& support = problem.supports[index];
  HeldComponent h;
  h.held = true;
  h.support = static_cast<int>(index);
  h.base = placed[direction];
  h.displacement = support.displacement[direction];
  if (!support.turn) return h;
  const Vec3 from_point = placed - support.turn->point, tangential = support.turn->axis.cross(from_point);
  h.angle = support.turn->angle;
  h.radial = (from_point - support.turn->axis.dot(from_point) * support.turn->axis)[direction];
  h.tangential = tangential[direction];
  return h;
}

Held find_held(const Problem& problem, const State& state, const std::set<std::string>& released) {
  Held held{held_positions(problem, released), {}, {}};
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
