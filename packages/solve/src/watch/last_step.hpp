#pragma once

#include <memory>

#include "equilibrium/equilibrium.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

/// a - b.
inline RCP<Vector> difference(const Vector& a, const Vector& b) {
  RCP<Vector> d = rcp(new Vector(a, Teuchos::Copy));
  d->update(-1.0, b, 1.0);
  return d;
}

/// The last accepted state of a stage, and the step that led there: what a watch compares the next step with.
class LastStep {
 public:
  explicit LastStep(const Equilibrium& equilibrium) : equilibrium_(equilibrium) {}

  /// A state was accepted.
  bool known() const { return !z_.is_null(); }
  const Vector& z() const { return *z_; }
  double s() const { return s_; }
  /// From the one before; null: not known.
  const RCP<const Vector>& change() const { return change_; }
  double interval() const { return interval_; }  ///< of s in it

  RCP<Vector> to(const Vector& z) const { return difference(z, *z_); }
  /// `follows`: the step from the last state points along the path.
  void accept(const Vector& z, double s, bool follows) {
    change_ = follows ? to(z) : Teuchos::null;
    interval_ = follows ? s - s_ : 0.0;
    z_ = rcp(new Vector(z, Teuchos::Copy));
    s_ = s;
  }

  /// Its part of what a watch remembers. Collective.
  WatchMemory memory() const {
    WatchMemory memory;
    if (known()) memory.last = equilibrium_.gather(*z_);
    if (!change_.is_null()) memory.change = equilibrium_.gather(*change_);
    memory.s = s_;
    memory.interval = interval_;
    return memory;
  }
  void resume(const WatchMemory& memory) {
    z_ = equilibrium_.scatter(memory.last);
    change_ = equilibrium_.scatter(memory.change);
    s_ = memory.s;
    interval_ = memory.interval;
  }

 private:
  const Equilibrium& equilibrium_;
  RCP<const Vector> z_, change_;
  double s_ = 0.0, interval_ = 0.0;
};

}  // namespace toile::solve
