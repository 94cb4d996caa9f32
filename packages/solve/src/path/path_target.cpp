#include "path/path_target.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "path/swept_volume.hpp"

namespace toile::solve {

namespace {

int cluster_of(const Problem& problem, int node) {
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    if (std::find(problem.clusters[c].begin(), problem.clusters[c].end(), node) != problem.clusters[c].end())
      return static_cast<int>(c);
  return -1;
}

}  // namespace

TargetSearch::TargetSearch(const Problem& problem, std::shared_ptr<Equilibrium> equilibrium, const PathTarget& target,
                           const NewtonOptions& options)
    : problem_(problem), equilibrium_(std::move(equilibrium)), target_(target), options_(options) {}

double TargetSearch::measure(const Vector& z, double s) {
  if (target_.support >= 0)
    return equilibrium_->balance(z, s).support[static_cast<size_t>(target_.support)][target_.direction];
  const State state = equilibrium_->state(z, s);
  if (target_.volume) return swept_volume(problem_, state);
  const Vec3 now = node_position(problem_, state, cluster_of(problem_, target_.node), target_.node);
  return (now - problem_.mesh->placed[target_.node])[target_.direction];
}

bool TargetSearch::passed(const Vector& z, double s) {
  before_ = after_;
  value_before_ = value_after_;
  after_ = {rcp(new Vector(z, Teuchos::Copy)), s};
  value_after_ = measure(z, s);
  if (before_.z.is_null()) return value_after_ == target_.value;
  return (value_before_ - target_.value) * (value_after_ - target_.value) <= 0.0;
}

TargetMemory TargetSearch::memory() const {
  const auto values = [&](const PathPoint& p) { return p.z.is_null() ? Unknowns() : equilibrium_->gather(*p.z); };
  return {values(before_), values(after_), before_.s, after_.s, value_before_, value_after_};
}

void TargetSearch::resume(const TargetMemory& memory) {
  before_ = {equilibrium_->scatter(memory.before), memory.s_before};
  after_ = {equilibrium_->scatter(memory.after), memory.s_after};
  value_before_ = memory.value_before;
  value_after_ = memory.value_after;
}

double TargetSearch::slope(const PathPoint& at, const Vector& dz, double ds) {
  constexpr double far = 1e-4;  // mm
  const double size = std::max(dz.normInf(), std::abs(ds));
  if (size == 0.0) return 0.0;
  const double h = far / size;
  Vector z(*at.z, Teuchos::Copy);
  z.update(h, dz, 1.0);
  const double ahead = measure(z, at.s + h * ds);
  z.update(-2.0 * h, dz, 1.0);
  return (ahead - measure(z, at.s - h * ds)) / (2.0 * h);
}

std::optional<PathPoint> TargetSearch::find() {
  if (before_.z.is_null()) return after_;
  const double share = (target_.value - value_before_) / (value_after_ - value_before_);
  const RCP<Vector> z = rcp(new Vector(*after_.z, Teuchos::Copy));
  z->update(1.0 - share, *before_.z, share);
  return find_near({z, before_.s + share * (after_.s - before_.s)});
}

// Residual = 0 and quantity = value: from K a = f and K b = df/ds the step is -a - ds b with the ds that brings the
// quantity to its value.
std::optional<PathPoint> TargetSearch::find_near(const PathPoint& start) {
  constexpr double tolerance = 1e-9;
  const double scale = std::max(std::abs(target_.value), std::abs(value_after_ - value_before_));
  PathPoint now{rcp(new Vector(*start.z, Teuchos::Copy)), start.s};
  Vector f(now.z->getMap()), rate(f.getMap()), a(f.getMap()), b(f.getMap());
  for (int k = 0; k < options_.max_iterations; ++k) {
    const Imbalance left = equilibrium_->residual(*now.z, now.s, f).imbalance;
    if (!std::isfinite(left.force)) return std::nullopt;
    const double off = target_.value - measure(*now.z, now.s);
    if (left.relative() <= options_.tolerance && std::abs(off) <= tolerance * scale) return now;
    equilibrium_->residual_rate(*now.z, now.s, rate);
    equilibrium_->linearise(*now.z, now.s);
    if (!equilibrium_->solve(f, a) || !equilibrium_->solve(rate, b)) return std::nullopt;
    a.scale(-1.0);
    b.scale(-1.0);
    const double along = slope(now, b, 1.0);
    if (along == 0.0) return std::nullopt;
    const double ds = (off - slope(now, a, 0.0)) / along;
    a.update(ds, b, 1.0);
    const RCP<Vector> next = rcp(new Vector(*now.z, Teuchos::Copy));
    next->update(1.0, a, 1.0);
    now = {next, now.s + ds};
  }
  return std::nullopt;
}

}  // namespace toile::solve
