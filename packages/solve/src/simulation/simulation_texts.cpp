// What a simulation says: warnings at the end of a stage, and why one fails.
#include <algorithm>
#include <sstream>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/fabric_state.hpp"
#include "simulation/simulation_data.hpp"
#include "toile/solve/loss_of_ellipticity.hpp"

namespace toile::solve {

// A step that is looked at for its stability is looked at for the material's too.
void Simulation::Data::watch_ellipticity(const StepReport& report) {
  if (!report.undamped && progress.lost_ellipticity) return;
  const LossOfEllipticity loss = find_loss_of_ellipticity(problem, state);
  if (!loss.found()) return;
  if (report.undamped)
    warnings.push_back(where() + "in its final state " + loss.text());
  else
    notes.add(where() + "at load " + std::to_string(report.load) + " " + loss.text());
  progress.lost_ellipticity = true;
}

// What did not converge where the last attempt gave up, and why; of one that was stopped, where the garment was on its
// way to. Collective.
std::string Simulation::Data::diagnosis() {
  if (!tries.failed) return {};
  Remainder left = remainder_of(*equilibrium, *tries.failed, tries.failed_damping, problem.clusters.size());
  const Failure failure{problem,  stage,          options.newton,
                        held,     progress.start, state,
                        left,     reached,        statistics.steps > progress.earlier_steps,
                        relaxing, tries.cut_backs};
  if (!watch.stopped().empty()) {
    const std::string motion = unheld_motion(failure);
    if (!motion.empty()) return " Likely cause: " + motion + ".";
    const std::string on_its_way = relaxing || !failure.stepped ? farthest_motion(failure) : "";
    return on_its_way.empty() ? on_its_way : " Where it was stopped, " + on_its_way + ".";
  }
  if (left.finite) left.softest = softest_motion(*equilibrium, *tries.failed, problem.clusters.size());
  const std::string cause = likely_cause(failure);
  return " " + what_failed(failure) + (cause.empty() ? "" : " Likely cause: " + cause + ".");
}

std::string Simulation::Data::end_failure() {
  std::string text = where() + "no undamped equilibrium was found at its end";
  if (!watch.stopped().empty()) text += ", because " + watch.stopped();
  if (statistics.steps > progress.earlier_steps)
    text += std::string("; the last converged ") + (stage.damping.active ? "(damped) " : "") +
            "state was kept, and its pressures must not be read as final.";
  else
    text += ", and no step of it was accepted.";
  return text + diagnosis();
}

void Simulation::Data::tell_of_damping() {
  if (!watches.damped) return;
  for (const std::string& text : watches.damped->warnings()) warnings.push_back(where() + text);
  watches.damped.reset();
}

// Then the signs of the pivots are those of round-off.
bool Simulation::Data::is_slack_membrane() const {
  const bool shells = std::all_of(problem.models.begin(), problem.models.end(),
                                  [](const BlockModel& model) { return model.is_shell(); });
  return !shells && fabric_state(problem, state).is_slack();
}

void Simulation::Data::judge(const StepReport& last) {
  const std::string unstable = stability_warning(last);
  if (!unstable.empty() && is_slack_membrane())
    notes.add(where() +
              "its fabric carries no tension at its end. A membrane without tension resists no motion across itself: "
              "what is written is one of the shapes that it may hang in");
  else if (!unstable.empty())
    warnings.push_back(where() + unstable);
  constexpr double most_stabilised = 0.05;
  if (progress.stabilised > most_stabilised) {
    std::ostringstream text;
    text.precision(3);
    text << "up to " << 100.0 * progress.stabilised << " % of the strain energy (at load " << progress.stabilised_at
         << ") is that of the hourglass modes of reduced shells, which bends what the mesh cannot follow: it is too "
            "coarse "
            "there, and may snap early or be too soft or too stiff. Take more elements";
    warnings.push_back(where() + text.str());
  }
  constexpr double most_kept = 1e-3;
  if (last.accuracy.kept > most_kept) {
    std::ostringstream text;
    text.precision(3);
    text << "the residual stiffness of slack fabric still carries " << 100.0 * last.accuracy.kept
         << " % of the forces at its end: slack fabric is not where it would come to rest. Give the fabric a smaller "
            "\"residual stiffness\"";
    warnings.push_back(where() + text.str());
  }
  tell_of_damping();
  if (stage.damping.active && energies.dissipated > stage.damping.limit * energies.largest)
    warnings.push_back(where() +
                       "the damping dissipated more than the limit; its path was not quasi-static (the final state is "
                       "undamped)");
}

std::string Simulation::Data::path_failure() {
  std::ostringstream message;
  message << "stage \"" << stage.name << "\" could not reach its end: it stopped at "
          << stage.kind->reached_text(stage, state);
  if (stage.until)
    message << " (and before \"Until\" " << stage.until->value
            << (stage.until->volume ? " mm^3" : " on " + stage.until->on) << ")";
  if (!watch.stopped().empty()) {
    message << ", because " << watch.stopped() << ".";
  } else if (statistics.steps == progress.earlier_steps) {
    message << ", and no step of it was accepted.";
  } else {
    message << ", after " << tries.cut_backs << " cut-backs at that point (\"smallest step\" " << stage.smallest_step
            << ").";
  }
  return message.str() + diagnosis();
}

}  // namespace toile::solve
