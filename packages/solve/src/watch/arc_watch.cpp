#include "watch/arc_watch.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "watch/found_steps.hpp"

namespace toile::solve {

ArcWatch::ArcWatch(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage)
    : equilibrium_(std::move(equilibrium)), stage_(stage), last_(*equilibrium_) {}

double ArcWatch::turn(const Vector& step) const {
  const double now = equilibrium_->distance(step), before = equilibrium_->distance(*last_.change());
  if (now == 0.0 || before == 0.0) return 0.0;
  Vector off(step, Teuchos::Copy);
  off.update(-1.0 / before, *last_.change(), 1.0 / now);
  const double chord = equilibrium_->distance(off);  // between unit vectors
  return 2.0 * std::asin(std::min(1.0, 0.5 * chord)) * 180.0 / M_PI;
}

bool ArcWatch::accepts(const Vector& z) {
  constexpr double sharp = 60.0;     // degrees
  constexpr double above = 16.0;     // times the smallest step: the path ends at one that is cut below it
  constexpr double shortest = 0.05;  // of the first step: a bend that this does not round off is none
  off_ = 0.0;
  if (last_.change().is_null()) return true;
  const RCP<Vector> step = last_.to(z);
  const double angle = turn(*step);
  if (angle <= sharp) return true;
  const double length = stage_.first_step * equilibrium_->distance(*step) / first_length_;
  if (length > std::max(above * stage_.smallest_step, shortest * stage_.first_step)) return false;
  off_ = angle;
  return true;
}

bool ArcWatch::accepted(const Vector& z, double s) {
  const bool turned = off_ > 0.0;
  if (turned) {
    const double from = equilibrium_->state(last_.z(), last_.s()).load, to = equilibrium_->state(z, s).load;
    count_step(turns_, from, to, off_ > turns_.distance, {off_, Vec3::Zero()});
  }
  last_.accept(z, s, last_.known());
  if (first_length_ == 0.0 && !last_.change().is_null()) first_length_ = equilibrium_->distance(*last_.change());
  off_ = 0.0;
  return turned;
}

WatchMemory ArcWatch::memory() const {
  WatchMemory memory = last_.memory();
  memory.first_length = first_length_;
  memory.found = turns_;
  return memory;
}

void ArcWatch::resume(const WatchMemory& memory) {
  last_.resume(memory);
  first_length_ = memory.first_length;
  turns_ = memory.found;
}

std::string ArcWatch::warning() const {
  if (turns_.count == 0) return {};
  std::ostringstream out;
  out.precision(4);
  out << "between load " << turns_.from << " and " << turns_.to << " the path turned by " << turns_.distance
      << " degrees at once, which shorter steps do not round off";
  if (turns_.count > 1) out << " (the sharpest of " << turns_.count << " turns)";
  out << ": it went over to another branch, or back along the one it came. The states after it are equilibria, but not "
         "those that follow on the path; smaller \"largest step\" and \"first step\" may stay on it";
  return out.str();
}

}  // namespace toile::solve
