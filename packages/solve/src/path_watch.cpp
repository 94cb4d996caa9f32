#include "path_watch.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace toile::solve {

namespace {

RCP<Vector> difference(const Vector& a, const Vector& b) {
  RCP<Vector> d = rcp(new Vector(a, Teuchos::Copy));
  d->update(-1.0, b, 1.0);
  return d;
}

}  // namespace

PathWatch::PathWatch(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage, const NewtonOptions& options)
    : equilibrium_(std::move(equilibrium)), stage_(stage), options_(options) {}

// The path points along its last secant. What lies within the length of the predicted step from it is a bend.
bool PathWatch::suspect(const Vector& z, double s, int iterations) const {
  constexpr int many = 25;  // thin shells take up to 20 on their path
  constexpr double bend = 1.0;
  if (iterations >= many) return true;
  if (change_.is_null() || interval_ <= 0.0) return false;
  const double scale = (s - s_) / interval_;
  const RCP<Vector> off = difference(z, *last_);
  off->update(-scale, *change_, 1.0);
  return equilibrium_->distance(*off) > bend * scale * equilibrium_->distance(*change_);
}

// Where Newton's method does not find the way back, nothing is proven.
bool PathWatch::returns(const Vector& z, double s) {
  constexpr double same = 0.1;  // of the step's length
  const Attempt back = solve_at(equilibrium_, stage_, options_, z, s_);
  // What is frozen in a step (thickness and hourglass moduli of shells) moves its start a little.
  const Attempt start = solve_at(equilibrium_, stage_, options_, *last_, s_);
  const double step = equilibrium_->distance(*difference(z, *last_));
  const bool known = back.converged && start.converged;
  const double off = known ? equilibrium_->distance(*difference(*back.z, *start.z)) : 0.0;
  equilibrium_->renew_factorisation();
  equilibrium_->linearise(z, s);  // the tangent and the contact of the step, for what follows it
  return off <= same * step;
}

bool PathWatch::accepts(const Vector& z, double s, int iterations) {
  left_ = false;
  if (last_.is_null() || s <= s_ || !suspect(z, s, iterations)) return true;
  if (returns(z, s)) return true;
  const double narrow = std::max(2.0 * stage_.smallest_step, 0.1 * stage_.first_step);
  if (s - s_ > narrow) return false;
  left_ = true;
  return true;
}

bool PathWatch::accepted(const Vector& z, double s) {
  const bool jumped = left_;
  if (jumped) note(z, s);
  const bool follows = !last_.is_null() && s > s_ && !jumped;  // a jump points nowhere
  change_ = follows ? difference(z, *last_) : Teuchos::null;
  interval_ = follows ? s - s_ : 0.0;
  last_ = rcp(new Vector(z, Teuchos::Copy));
  s_ = s;
  left_ = false;
  return jumped;
}

void PathWatch::note(const Vector& z, double s) {
  const State before = equilibrium_->state(*last_, s_), after = equilibrium_->state(z, s);
  const bool sews = stage_.type == StageType::sew;
  Jump jump{sews ? before.seam : before.load, sews ? after.seam : after.load, 0.0, Vec3::Zero()};
  for (size_t c = 0; c < after.position.size(); ++c) {
    const double moved = (after.position[c] - before.position[c]).norm();
    if (moved > jump.distance) jump = {jump.from, jump.to, moved, before.position[c]};
  }
  if (!largest_ || jump.distance > largest_->distance) largest_ = jump;
  if (++jumps_ == 1) first_ = jump.from;
  end_ = jump.to;
}

std::string PathWatch::warning() const {
  if (!largest_) return {};
  const bool sews = stage_.type == StageType::sew;
  const Vec3& at = largest_->at;
  std::ostringstream out;
  out << "between " << (sews ? "closing " : "load ") << largest_->from << " and " << largest_->to
      << " the garment left its path of equilibria and jumped to another branch: the point at (" << at[0] << ", "
      << at[1] << ", " << at[2] << ") mm moved by " << largest_->distance
      << " mm at once, shorter steps do not follow, and the way back does not return";
  if (jumps_ > 1) out << " (the largest of " << jumps_ << " jumps between " << first_ << " and " << end_ << ")";
  out << ". The states after it are equilibria, but which branch is met depends on the steps";
  if (sews)
    out << "; \"Damping\" passes it slowly";
  else
    out << ": continuation in the load cannot follow a path over a limit point. \"continuation\" = \"arc length\" "
           "follows it (without a body), \"Damping\" passes it slowly";
  return out.str();
}

}  // namespace toile::solve
