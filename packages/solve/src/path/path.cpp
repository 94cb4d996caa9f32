#include "path/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "path/arc_path.hpp"
#include "path/natural_path.hpp"

namespace toile::solve {

namespace {
constexpr double step_round_off = 1e-15;
}

Path::Path(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage, const NewtonOptions& options,
           bool tangent_first, AcceptsStep accepts)
    : equilibrium_(std::move(equilibrium)),
      stage_(stage),
      options_(options),
      tangent_first_(tangent_first),
      accepts_(std::move(accepts)) {
  memory_.step = stage.first_step;
  memory_.smallest = stage.smallest_step;
  memory_.largest = stage.largest_step;
  clip();
}

// Between the smallest and the largest step.
void Path::clip() {
  memory_.step = std::min(memory_.step, memory_.largest);
  memory_.is_smallest = memory_.step < memory_.smallest;
  memory_.step = std::max(memory_.step, memory_.smallest);
}

void Path::aim(double s, double rate) {
  memory_.aimed = false;
  const double end = stage_.until ? std::numeric_limits<double>::infinity() : 1.0;
  if (memory_.is_smallest || s + memory_.step * rate <= end * (1.0 - step_round_off)) return;
  memory_.step = (end - s) / rate;
  memory_.aimed = true;
}

bool Path::is_at_end(double s) const {
  constexpr double near = 0.9;  // of the first step
  return memory_.aimed && std::abs(s - 1.0) < near * stage_.first_step;
}

Attempt Path::land(const Vector& z) {
  return solve_at(equilibrium_, stage_, options_, z, 1.0, accepts_);
}

RCP<const Vector> Path::direction(const Vector& z, double s) {
  if (!change_.is_null()) {
    const RCP<Vector> unit = rcp(new Vector(*change_, Teuchos::Copy));
    unit->scale(1.0 / std::abs(memory_.interval));
    return unit;
  }
  if (!tangent_first_) return Teuchos::null;
  if (tangent_.is_null()) {
    Vector rate(z.getMap());
    const RCP<Vector> tangent = rcp(new Vector(z.getMap()));
    equilibrium_->residual_rate(z, s, rate);
    equilibrium_->linearise(z, s);
    if (equilibrium_->solve(rate, *tangent))
      tangent->scale(-1.0);
    else
      tangent->putScalar(0.0);
    tangent_ = tangent;
  }
  return tangent_;
}

// The fewer iterations a step took, the more the next one is longer.
void Path::go_on(const Vector& from, double s, const Attempt& end) {
  const RCP<Vector> change = rcp(new Vector(*end.z, Teuchos::Copy));
  change->update(-1.0, from, 1.0);
  change_ = change;
  tangent_ = Teuchos::null;
  memory_.interval = end.s - s;
  const double scale = rescale(*direction(*end.z, end.s));
  const double most = options_.max_iterations, spare = (most - end.iterations) / most;
  memory_.smallest *= scale;
  memory_.largest *= scale;
  memory_.step *= (1.0 + spare * spare) * scale;
  clip();
}

bool Path::shorten() {
  constexpr double cut = 0.5;
  memory_.aimed = false;
  if (memory_.is_smallest) return false;
  memory_.step *= cut;
  clip();
  return true;
}

PathMemory Path::memory() const {
  PathMemory memory = memory_;
  if (!change_.is_null()) memory.change = equilibrium_->gather(*change_);
  return memory;
}

void Path::resume(const PathMemory& memory) {
  memory_ = memory;
  memory_.change.clear();
  change_ = equilibrium_->scatter(memory.change);
}

std::unique_ptr<Path> make_path(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage,
                                const NewtonOptions& options, bool tangent_first, AcceptsStep accepts) {
  if (stage.arc_length)
    return std::make_unique<ArcPath>(std::move(equilibrium), stage, options, tangent_first, std::move(accepts));
  return std::make_unique<NaturalPath>(std::move(equilibrium), stage, options, tangent_first, std::move(accepts));
}

}  // namespace toile::solve
