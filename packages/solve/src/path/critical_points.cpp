#include "path/critical_points.hpp"

#include <sstream>
#include <utility>

namespace toile::solve {

namespace {

std::string name_of(CriticalPoint kind) {
  switch (kind) {
    case CriticalPoint::limit:
      return "a limit point";
    case CriticalPoint::bifurcation:
      return "a bifurcation";
    default:
      return "a limit point, a bifurcation or a change of contact";
  }
}

}  // namespace

void CriticalPoints::start(RCP<const Vector> z) {
  pivots_ = -1;
  direction_ = 1.0;
  s_ = 0.0;
  z_ = std::move(z);
}

std::string CriticalPoints::count(Equilibrium& equilibrium, const Vector& z, double s, bool arc_length,
                                  StepReport& report) {
  const double damping = equilibrium.damping();
  equilibrium.set_damping(0.0);
  equilibrium.tangent().renew();
  double direction = 1.0;
  if (arc_length) {
    Vector step(z, Teuchos::Copy);
    step.update(-1.0, *z_, 1.0);
    direction = equilibrium.path_direction(z, s, step, s - s_);
  } else {
    equilibrium.linearise(z, s);
  }
  equilibrium.set_damping(damping);
  if (damping > 0.0) equilibrium.tangent().renew();  // the one just made is not of the damped tangent
  report.negative_pivots = equilibrium.tangent().unshifted_negative_pivots();
  if (report.negative_pivots == 0) report.condition = equilibrium.tangent().condition();
  std::ostringstream note;
  if (pivots_ >= 0 && report.negative_pivots >= 0 && report.negative_pivots != pivots_) {
    report.critical = !arc_length                    ? CriticalPoint::unclassified
                      : direction * direction_ < 0.0 ? CriticalPoint::limit
                                                     : CriticalPoint::bifurcation;
    note << name_of(report.critical) << " was passed between load " << load_ << " and " << report.load
         << " (negative pivots " << pivots_ << " -> " << report.negative_pivots << ")";
  }
  direction_ = direction;
  pivots_ = report.negative_pivots;
  load_ = report.load;
  s_ = s;
  z_ = rcp(new Vector(z, Teuchos::Copy));
  return note.str();
}

PivotMemory CriticalPoints::memory(const Equilibrium& equilibrium) const {
  return {pivots_, load_, s_, direction_, equilibrium.gather(*z_)};
}

void CriticalPoints::resume(const PivotMemory& memory, const Equilibrium& equilibrium) {
  pivots_ = memory.pivots;
  load_ = memory.load;
  s_ = memory.s;
  direction_ = memory.direction;
  z_ = equilibrium.scatter(memory.z);
}

std::string stability_warning(const StepReport& last) {
  if (last.negative_pivots > 0)
    return "its final state is not stable (" + std::to_string(last.negative_pivots) +
           " negative pivots): a small disturbance would take the garment elsewhere";
  if (last.negative_pivots < 0)
    return "it is not known whether its final state is stable (the tangent could not be factorised)";
  return {};
}

}  // namespace toile::solve
