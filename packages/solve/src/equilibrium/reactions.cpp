#include "equilibrium/reactions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "equilibrium/unknowns.hpp"

namespace toile::solve {

namespace {

/// Rows of three: contact, load, damping, pins, one a support; then the torque of each support; last the sums of
/// magnitudes, of the pins and of all.
class Sums {
 public:
  static constexpr size_t contact = 0, load = 1, damping = 2, pins = 3;

  explicit Sums(size_t supports) : supports_(supports), values_(torques() + supports + 2, 0.0) {}
  static size_t row_of(int support) { return support < 0 ? pins : pins + 1 + static_cast<size_t>(support); }

  void add(size_t row, const Vec3& force) { Eigen::Map<Vec3>(&values_[3 * row]) += force; }
  double& torque(int support) { return values_[torques() + static_cast<size_t>(support)]; }
  double& pin_magnitude() { return values_[values_.size() - 2]; }
  double& magnitude() { return values_.back(); }

  ForceBalance over_ranks(const Comm& comm) {
    values_ = sum_over_ranks(comm, values_);
    const auto row = [&](size_t k) { return Vec3(values_[3 * k], values_[3 * k + 1], values_[3 * k + 2]); };
    ForceBalance b;
    b.contact = row(contact);
    b.load = row(load);
    b.damping = row(damping);
    b.pins = row(pins);
    for (size_t k = 0; k < supports_; ++k) b.support.push_back(row(row_of(static_cast<int>(k))));
    b.torque.assign(values_.begin() + static_cast<std::ptrdiff_t>(torques()), values_.end() - 2);
    b.pin_magnitude = pin_magnitude();
    b.magnitude = magnitude();
    return b;
  }

 private:
  size_t torques() const { return 3 * (pins + 1 + supports_); }

  size_t supports_;
  std::vector<double> values_;
};

/// Moment about the axis of the clamp that holds a director and turns: the moments along w times dw/dangle.
double torque_of_director(const Turn& turn, const Frame& start, const Frame& now, const double* moment) {
  constexpr double h = 1e-5;  // rad
  const Vec3 director = now.row(2);
  const auto rotation = [&](double angle) {
    return rotation_to(start, Eigen::AngleAxisd(angle, turn.axis) * director);
  };
  const std::array<double, 2> before = rotation(-h), after = rotation(h);
  double torque = 0.0;
  for (size_t k = 0; k < 2; ++k) torque += moment[k] * (after[k] - before[k]) / (2.0 * h);
  return torque;
}

Vec3 force_on(const Forces& forces, int cluster) {
  return Eigen::Map<const Vec3>(&forces.force[3 * static_cast<size_t>(cluster)]);
}

/// What the supports of an owned cluster carry.
void add_reactions(const Problem& problem, const Layout& layout, int c, const Vec3& position, const Vec3& rest,
                   Sums& sums) {
  const Vec3 reactions = layout.components_of_force(c, rest);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const HeldComponent& held = layout.held[c][static_cast<size_t>(k)];
    if (!held.held) continue;
    const Vec3 reaction = reactions[k] * layout.direction(c, k);
    sums.add(Sums::row_of(held.support), reaction);
    sums.magnitude() += std::abs(reactions[k]);
    if (held.support < 0)
      sums.pin_magnitude() += std::abs(reactions[k]);
    else if (const auto& turn = problem.supports[held.support].turn)
      sums.torque(held.support) += reaction.dot(turn->axis.cross(position - turn->point));
  }
}

}  // namespace

ForceBalance balance_of(const Problem& problem, const Layout& layout, const Kinematics& kinematics,
                        const Configuration& at, const TermForces& terms, double lever, double least) {
  Sums sums(problem.supports.size());
  for (int c = 0; c < layout.owned_clusters; ++c) {
    const Vec3 contact = -force_on(terms.contact, c), load = -force_on(terms.load, c);
    const Vec3 damping = -force_on(terms.damping, c);
    sums.add(Sums::contact, contact);
    sums.add(Sums::load, load);
    sums.add(Sums::damping, damping);
    sums.magnitude() += contact.lpNorm<1>() + load.lpNorm<1>() + damping.lpNorm<1>();
    add_reactions(problem, layout, c, at.position(static_cast<size_t>(c)),
                  force_on(terms.fabric, c) - damping - load - contact, sums);
  }
  double moments = std::abs(at.load) * terms.load_moments;
  for (size_t n = 0; n < layout.rotation.size(); ++n) {
    if (layout.node_cluster[n] >= layout.owned_clusters) continue;
    const double rest[2] = {terms.fabric.moment[2 * n] + terms.load.moment[2 * n],
                            terms.fabric.moment[2 * n + 1] + terms.load.moment[2 * n + 1]};
    for (size_t k = 0; k < 2; ++k)
      if (layout.rotation[n][k] < 0) moments += std::abs(rest[k]);
    const int clamp = layout.turned_by.empty() ? -1 : layout.turned_by[n];
    if (clamp >= 0)
      sums.torque(clamp) +=
          torque_of_director(*problem.supports[clamp].turn, kinematics.frames()[n], kinematics.frame(n, at), rest);
  }
  sums.magnitude() += moments / lever;
  ForceBalance balance = sums.over_ranks(*layout.comm);
  balance.magnitude = std::max(balance.magnitude, least);
  return balance;
}

}  // namespace toile::solve
