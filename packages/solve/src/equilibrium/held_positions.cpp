// What supports prescribe of the positions: one component a held direction, and the free ones across them.
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>

#include "equilibrium/held.hpp"

namespace toile::solve {

namespace {

/// That a support holds one direction of a cluster.
struct Condition {
  Vec3 direction;
  HeldComponent path;
};

/// Sine of the angle between directions: below the first they are the same, below the second too near to each other to
/// be told apart from a mistake.
constexpr double same_direction = 1e-9, nearly_same = 0.02;

Condition condition(const Problem& problem, size_t index, size_t node, Eigen::Index axis, const Vec3& placed) {
  const Support& support = problem.supports[index];
  const Vec3 direction = support.axis(node, axis);
  HeldComponent h;
  h.held = true;
  h.support = static_cast<int>(index);
  h.base = direction.dot(placed);
  h.displacement = support.displacement[axis];
  if (!support.turn) return {direction, h};
  const Turn& turn = *support.turn;
  const Vec3 from_point = placed - turn.point, tangential = turn.axis.cross(from_point);
  h.angle = turn.angle;
  h.radial = direction.dot(from_point - turn.axis.dot(from_point) * turn.axis);
  h.tangential = direction.dot(tangential);
  return {direction, h};
}

/// Whether two components take the same path, within 1e-9 mm, at the same loads.
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

/// The conditions of one cluster, independent of each other.
class Conditions {
 public:
  /// What contradicts the new condition among those that are there; -1: nothing does, and it was added if it was new.
  int add(const Problem& problem, const Condition& added, bool& nearly_parallel, double& other_moves) {
    const Eigen::Index count = static_cast<Eigen::Index>(all_.size());
    Eigen::Matrix<double, 3, Eigen::Dynamic> directions(3, count);
    for (Eigen::Index k = 0; k < count; ++k) directions.col(k) = all_[static_cast<size_t>(k)].direction;
    Eigen::VectorXd parts = Eigen::VectorXd::Zero(count);
    if (count > 0) parts = directions.colPivHouseholderQr().solve(added.direction);
    const double rest = (added.direction - directions * parts).norm();
    nearly_parallel = rest > same_direction && rest < nearly_same;
    int main = -1;
    for (Eigen::Index k = 0; k < count; ++k)
      if (std::abs(parts[k]) > same_direction && (main < 0 || std::abs(parts[k]) > std::abs(parts[main])))
        main = static_cast<int>(k);
    other_moves = 0.0;
    for (Eigen::Index k = 0; k < count; ++k) other_moves += parts[k] * moves(all_[static_cast<size_t>(k)].path);
    if (nearly_parallel) return main;
    if (rest >= nearly_same) {
      all_.push_back(added);
      return -1;
    }
    if (!agrees(problem, added.path, parts)) return main;
    if ((parts.array().abs() > same_direction).count() == 1)
      all_[static_cast<size_t>(main)] = added;  // the last counts
    return -1;
  }

  static double moves(const HeldComponent& path) { return path.position(1.0) - path.base; }
  const std::vector<Condition>& all() const { return all_; }

 private:
  /// Whether a path is the sum of `parts` of the paths that are there, at all loads: each of them must then have its
  /// loads and its turn, or stay.
  bool agrees(const Problem& problem, const HeldComponent& path, const Eigen::VectorXd& parts) const {
    HeldComponent sum = path;
    sum.displacement = sum.radial = sum.tangential = 0.0;
    for (size_t k = 0; k < all_.size(); ++k) {
      const double part = parts[static_cast<Eigen::Index>(k)];
      if (std::abs(part) <= same_direction) continue;
      HeldComponent one = all_[k].path;
      for (double* value : {&one.displacement, &one.radial, &one.tangential}) *value *= part;
      HeldComponent at_rest = one;
      at_rest.displacement = at_rest.radial = at_rest.tangential = at_rest.angle = 0.0;
      if (!move_alike(problem, one, at_rest)) {
        if (!(problem.supports[static_cast<size_t>(one.support)].path ==
              problem.supports[static_cast<size_t>(path.support)].path))
          return false;
        if (one.angle != 0.0 && sum.angle != 0.0 && one.angle != sum.angle) return false;
        if (one.angle != 0.0) sum.angle = one.angle;
      }
      sum.displacement += one.displacement;
      sum.radial += one.radial;
      sum.tangential += one.tangential;
    }
    return move_alike(problem, path, sum);
  }

  std::vector<Condition> all_;
};

bool along_space(const Vec3& direction) {
  return (direction.array().abs() >= 1.0).any();
}

/// Components of a cluster: x, y and z as far as possible.
void set_components(const std::vector<Condition>& conditions, std::array<HeldComponent, 3>& component, Basis& basis) {
  bool turned = false;
  for (const Condition& c : conditions) turned = turned || !along_space(c.direction);
  if (!turned) {
    for (const Condition& c : conditions) {
      Eigen::Index axis = 0;
      c.direction.cwiseAbs().maxCoeff(&axis);
      HeldComponent h = c.path;
      if (c.direction[axis] < 0.0)
        for (double* value : {&h.base, &h.displacement, &h.radial, &h.tangential}) *value = -*value;
      component[static_cast<size_t>(axis)] = h;
    }
    return;
  }
  basis.turned = true;
  const Eigen::Index count = static_cast<Eigen::Index>(conditions.size());
  Eigen::Matrix<double, 3, Eigen::Dynamic> directions(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    directions.col(k) = conditions[static_cast<size_t>(k)].direction;
    component[static_cast<size_t>(k)] = conditions[static_cast<size_t>(k)].path;
    basis.across.row(k) = directions.col(k).transpose();
  }
  const Eigen::Matrix3d q = Eigen::HouseholderQR<Eigen::MatrixXd>(directions).householderQ();
  for (Eigen::Index k = count; k < 3; ++k) basis.across.row(k) = q.col(k).transpose();
  basis.along = basis.across.inverse();
}

}  // namespace

Vec3 Held::direction(int cluster, Eigen::Index component) const {
  return basis.empty() ? Vec3(Vec3::Unit(component)) : Vec3(basis[static_cast<size_t>(cluster)].across.row(component));
}

std::optional<Contradiction> hold_positions(const Problem& problem, const std::set<std::string>& released, Held& held) {
  std::vector<int> cluster_of(problem.mesh->nodes());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  std::vector<Conditions> conditions(problem.clusters.size());
  std::optional<Contradiction> found;
  for (size_t s = 0; s < problem.supports.size() && !found; ++s) {
    const Support& support = problem.supports[s];
    if (released.count(support.name)) continue;
    for (size_t k = 0; k < support.nodes.size() && !found; ++k)
      for (Eigen::Index i = 0; i < 3 && !found; ++i) {
        if (!support.held[static_cast<size_t>(i)]) continue;
        const size_t c = static_cast<size_t>(cluster_of[support.nodes[k]]);
        const Condition added = condition(problem, s, k, i, problem.mesh->placed[problem.clusters[c].front()]);
        Contradiction other{};
        const int with = conditions[c].add(problem, added, other.nearly_parallel, other.first_moves);
        if (with < 0) continue;
        other.first = static_cast<size_t>(conditions[c].all()[static_cast<size_t>(with)].path.support);
        other.second = s;
        other.node = support.nodes[k];
        other.direction = added.direction;
        other.second_moves = Conditions::moves(added.path);
        found = other;
      }
  }
  held.position.assign(problem.clusters.size(), {});
  std::vector<Basis> basis(problem.clusters.size());
  bool turned = false;
  for (size_t c = 0; c < conditions.size(); ++c) {
    set_components(conditions[c].all(), held.position[c], basis[c]);
    turned = turned || basis[c].turned;
  }
  if (turned) held.basis = std::move(basis);
  return found;
}

}  // namespace toile::solve
