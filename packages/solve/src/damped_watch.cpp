#include "damped_watch.hpp"

#include <algorithm>
#include <sstream>

namespace toile::solve {

namespace {

double drive_of(const StageOptions& stage, const State& state) {
  return stage.type == StageType::sew ? state.seam : state.load;
}
const char* drive_name(const StageOptions& stage) {
  return stage.type == StageType::sew ? "closing " : "load ";
}

}  // namespace

bool DampedWatch::accepted(const DampedStep& step) {
  constexpr double noticeable = 0.01, times_wanted = 10.0;  // of the energy; of what a step is to dissipate
  const double share = step.energy > 0.0 ? step.dissipated / step.energy : 0.0;
  if (share <= std::max(noticeable, times_wanted * stage_.damping.fraction)) return false;
  const double before = drive_of(stage_, step.before), after = drive_of(stage_, step.after);
  const Snap snap{before, after, step.dissipated, share, furthest_move(step.before, step.after)};
  if (!largest_ || snap.dissipated > largest_->dissipated) largest_ = snap;
  if (++snaps_ == 1) first_ = before;
  end_ = after;
  part_ += step.to - step.from;
  taken_ += step.dissipated;
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
  return snaps_ > 2 && part_ > much;
}

std::string DampedWatch::snap_warning() const {
  if (!largest_ || holds_back()) return {};
  const Vec3& at = largest_->move.at;
  std::ostringstream out;
  out.precision(4);
  if (largest_->to > largest_->from)
    out << "between " << drive_name(stage_) << largest_->from << " and " << largest_->to;
  else
    out << "at " << drive_name(stage_) << largest_->to;
  out << " the garment snapped: the point at (" << at[0] << ", " << at[1] << ", " << at[2] << ") mm moved by "
      << largest_->move.distance << " mm in one step, in which the damping took " << largest_->dissipated << " N mm, ";
  if (largest_->share > 1.0)
    out << "more than the strain energy";
  else
    out << 100.0 * largest_->share << " % of the strain energy";
  if (snaps_ > 1) out << " (the largest of " << snaps_ << " such steps between " << first_ << " and " << end_ << ")";
  out << ". That is dynamic: slack fabric that was drawn tight, or a jump to another branch of equilibria, which then "
         "depends on the damping and the steps. Another \"fraction\" and \"first step\" tell which: a jump may end "
         "elsewhere";
  return out.str();
}

std::string DampedWatch::frozen_warning() const {
  if (!holds_back()) return {};
  std::ostringstream out;
  out.precision(3);
  out << "in " << snaps_ << " steps between " << drive_name(stage_) << first_ << " and " << end_ << " the damping took "
      << taken_
      << " N mm: it held the garment back, which did not follow. The states of these steps are no equilibria (only "
         "the final one is). Take a smaller \"first step\" and \"largest step\" (now "
      << stage_.first_step << " and " << stage_.largest_step << "), which give it time";
  return out.str();
}

}  // namespace toile::solve
