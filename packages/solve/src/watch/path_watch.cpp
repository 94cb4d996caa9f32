#include "watch/path_watch.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "watch/found_steps.hpp"

namespace toile::solve {

PathWatch::PathWatch(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage, const NewtonOptions& options)
    : equilibrium_(std::move(equilibrium)), stage_(stage), options_(options), last_(*equilibrium_) {}

double PathWatch::bend(const Vector& z, double s) const {
  if (last_.change().is_null() || last_.interval() <= 0.0) return 0.0;
  const double scale = (s - last_.s()) / last_.interval();
  const double predicted = scale * equilibrium_->distance(*last_.change());
  const RCP<Vector> off = last_.to(z);
  off->update(-scale, *last_.change(), 1.0);
  return predicted > 0.0 ? equilibrium_->distance(*off) / predicted : 0.0;
}

// Where Newton's method does not find the way back, nothing is proven.
bool PathWatch::returns(const Vector& z, double s) {
  constexpr double same = 0.1;  // of the step's length
  const Attempt back = solve_at(equilibrium_, stage_, options_, z, last_.s());
  // What is frozen in a step (thickness and hourglass moduli of shells) moves its start a little.
  const Attempt start = solve_at(equilibrium_, stage_, options_, last_.z(), last_.s());
  const double step = equilibrium_->distance(*last_.to(z));
  const bool known = back.converged && start.converged;
  const double off = known ? equilibrium_->distance(*difference(*back.z, *start.z)) : 0.0;
  equilibrium_->tangent().renew();
  equilibrium_->linearise(z, s);  // the tangent and the contact of the step, for what follows it
  return off <= same * step;
}

// A leap is no bend: the garment moves noticeably, and ten times as far as the path points before it and after it.
// Newton's method may find the way back from it, if the other branch does not reach to where the step began; shorter
// steps separate the two.
bool PathWatch::leaps(const Vector& z, double s, double off) {
  constexpr double far = 10.0, noticeable = 0.1;
  const double moved = equilibrium_->distance(*last_.to(z));
  if (off <= far || moved <= noticeable * equilibrium_->distance(*difference(last_.z(), *start_))) return false;
  Vector rate(z.getMap()), tangent(z.getMap());
  equilibrium_->residual_rate(z, s, rate);
  equilibrium_->tangent().renew();
  equilibrium_->linearise(z, s);
  return !equilibrium_->solve(rate, tangent) || moved > far * (s - last_.s()) * equilibrium_->distance(tangent);
}

bool PathWatch::accepts(const Vector& z, double s, int iterations) {
  constexpr int many = 25;       // thin shells take up to 20 on their path
  constexpr double sharp = 1.0;  // what lies within the length of the predicted step from it is a bend
  left_ = false;
  if (!last_.known() || s <= last_.s()) return true;
  const double off = bend(z, s);
  const bool damped = stage_.damping.active;  // passes jumps: there they are told, not cut back
  if ((damped || iterations < many) && off <= sharp) return true;
  const bool leap = leaps(z, s, off), same = returns(z, s);
  if (same && !leap) return true;
  const double narrow = std::max(2.0 * stage_.smallest_step, (same ? 0.01 : 0.1) * stage_.first_step);
  if (!damped && s - last_.s() > narrow) return false;
  left_ = true;
  return true;
}

bool PathWatch::accepted(const Vector& z, double s) {
  const bool jumped = left_ && note(z, s);
  const bool follows = last_.known() && s > last_.s() && !jumped;  // a jump points nowhere
  last_.accept(z, s, follows);
  if (start_.is_null()) start_ = rcp(new Vector(z, Teuchos::Copy));
  left_ = false;
  return jumped;
}

bool PathWatch::note(const Vector& z, double s) {
  constexpr double counts = 1e-3;  // mm; less is round-off of a garment that rests
  const State before = equilibrium_->state(last_.z(), last_.s()), after = equilibrium_->state(z, s);
  const double from = stage_.kind->reached(before), to = stage_.kind->reached(after);
  const FurthestMove move = furthest_move(before, after);
  if (move.distance < counts) return false;
  count_step(jumps_, from, to, !jumps_.has_largest || move.distance > jumps_.distance, move);
  return true;
}

WatchMemory PathWatch::memory() const {
  WatchMemory memory = last_.memory();
  if (!start_.is_null()) memory.start = equilibrium_->gather(*start_);
  memory.found = jumps_;
  return memory;
}

void PathWatch::resume(const WatchMemory& memory) {
  last_.resume(memory);
  start_ = equilibrium_->scatter(memory.start);
  jumps_ = memory.found;
}

std::string PathWatch::warning() const {
  if (!jumps_.has_largest) return {};
  const bool sews = stage_.kind->closes_seams(), damped = stage_.damping.active;
  const Vec3& at = jumps_.at;
  std::ostringstream out;
  out << "between " << stage_.kind->measure() << " " << jumps_.from << " and " << jumps_.to
      << " the garment left its path of equilibria and jumped to another branch: the point at (" << at[0] << ", "
      << at[1] << ", " << at[2] << ") mm moved by " << jumps_.distance << " mm at once";
  if (!damped) out << ", which shorter steps do not follow";
  if (jumps_.count > 1)
    out << " (the largest of " << jumps_.count << " jumps between " << jumps_.first << " and " << jumps_.end << ")";
  out << ". The states after it are equilibria, but which branch is met depends on the steps";
  if (damped)
    out << " and the damping, with which such a jump is dynamic. Try another \"first step\" and \"fraction\"";
  else if (sews)
    out << "; \"Damping\" passes it slowly";
  else
    out << ": continuation in the load cannot follow a path over a limit point. \"continuation\" = \"arc length\" "
           "follows it (without a body), \"Damping\" passes it slowly";
  return out.str();
}

}  // namespace toile::solve
