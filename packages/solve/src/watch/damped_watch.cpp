#include "watch/damped_watch.hpp"

#include <algorithm>
#include <sstream>

#include "toile/solve/stage_kind.hpp"
#include "watch/found_steps.hpp"

namespace toile::solve {

namespace {

std::string drive_name(const StageOptions& stage) {
  return stage.kind->measure() + std::string(" ");
}

}  // namespace

bool DampedWatch::accepted(const DampedStep& step) {
  constexpr double noticeable = 0.01, times_wanted = 10.0;  // of the energy; of what a step is to dissipate
  const double share = step.energy > 0.0 ? step.dissipated / step.energy : 0.0;
  if (share <= std::max(noticeable, times_wanted * stage_.damping.fraction)) return false;
  const double before = stage_.kind->reached(step.before), after = stage_.kind->reached(step.after);
  const bool is_largest = !snaps_.has_largest || step.dissipated > snaps_.dissipated;
  count_step(snaps_, before, after, is_largest, furthest_move(step.before, step.after));
  if (is_largest) {
    snaps_.dissipated = step.dissipated;
    snaps_.share = share;
  }
  snaps_.part += step.to - step.from;
  snaps_.taken += step.dissipated;
  return true;
}

std::vector<std::string> DampedWatch::warnings() const {
  std::vector<std::string> all;
  for (const std::string& text : {snap_warning(), frozen_warning()})
    if (!text.empty()) all.push_back(text);
  return all;
}

bool DampedWatch::holds_back() const {
  constexpr double much = 0.25;  // of the stage
  return snaps_.count > 2 && snaps_.part > much;
}

std::string DampedWatch::snap_warning() const {
  if (!snaps_.has_largest || holds_back()) return {};
  const Vec3& at = snaps_.at;
  std::ostringstream out;
  out.precision(4);
  if (snaps_.to > snaps_.from)
    out << "between " << drive_name(stage_) << snaps_.from << " and " << snaps_.to;
  else
    out << "at " << drive_name(stage_) << snaps_.to;
  out << " the garment snapped: the point at (" << at[0] << ", " << at[1] << ", " << at[2] << ") mm moved by "
      << snaps_.distance << " mm in one step, in which the damping took " << snaps_.dissipated << " N mm, ";
  if (snaps_.share > 1.0)
    out << "more than the strain energy";
  else
    out << 100.0 * snaps_.share << " % of the strain energy";
  if (snaps_.count > 1)
    out << " (the largest of " << snaps_.count << " such steps between " << snaps_.first << " and " << snaps_.end
        << ")";
  out << ". That is dynamic: slack fabric that was drawn tight, or a jump to another branch of equilibria, which then "
         "depends on the damping and the steps. Another \"fraction\" and \"first step\" tell which: a jump may end "
         "elsewhere";
  return out.str();
}

std::string DampedWatch::frozen_warning() const {
  if (!holds_back()) return {};
  std::ostringstream out;
  out.precision(3);
  out << "in " << snaps_.count << " steps between " << drive_name(stage_) << snaps_.first << " and " << snaps_.end
      << " the damping took " << snaps_.taken
      << " N mm: it held the garment back, which did not follow. The states of these steps are no equilibria (only "
         "the final one is). Take a smaller \"first step\" and \"largest step\" (now "
      << stage_.first_step << " and " << stage_.largest_step << "), which give it time";
  return out.str();
}

}  // namespace toile::solve
