#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "toile/base/timer.hpp"
#include "toile/run/pierced.hpp"
#include "toile/run/pressure_report.hpp"
#include "toile/scene/fingerprint.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/checkpoint.hpp"
#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::run {

/// What is known of a run up to its last accepted step; before the first one, of its start. The same on every rank.
class Record {
 public:
  /// Both must outlive it.
  Record(const scene::Scene& scene, base::Timer& timer);

  const scene::Scene& scene() const { return scene_; }
  const std::vector<solve::StepReport>& reports() const { return reports_; }  ///< [step]
  /// Of the last accepted step. Throws Error (internal) if there is none.
  const solve::StepReport& last() const;
  const solve::State& state() const { return state_; }
  /// [point of the scene's output][step] displacement, mm
  const std::vector<std::vector<solve::Vec3>>& points() const { return points_; }
  /// [distance of the scene's output][step] mm
  const std::vector<std::vector<double>>& distances() const { return distances_; }

  /// Of the state; computed by the rank that asks, once a state. Communicates nothing.
  const solve::Fields& fields() const { return *shared_fields(); }
  /// The same, for who keeps them beyond the state.
  std::shared_ptr<const solve::Fields> shared_fields() const;
  /// Pressure at the levels and along the axis, likewise. Throws Error (internal) before the first step.
  const PressureReport& pressure() const;
  /// Elements that the body goes through, likewise.
  const Pierced& pierced() const;

  /// From which the run goes on after the last accepted step. Throws Error (internal) before the first step.
  const solve::Checkpoint& checkpoint() const;
  /// Of the scene, once the run has begun.
  const scene::Fingerprint& fingerprint() const { return fingerprint_; }

  /// As of the last stage that ended or failed.
  const solve::SolveStatistics& statistics() const { return statistics_; }
  /// What is good to know of the run, and what limits the trust in its result.
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Why a stage had to end before its time, although it might go on; empty: none had to.
  const std::string& stopped() const { return stopped_; }
  /// Why the run failed; empty: it did not.
  const std::string& failure() const { return failure_; }

  /// A step was accepted, from which the run can go on.
  void add(const solve::StepReport& report, const solve::State& state, solve::Checkpoint checkpoint);
  /// The run begins.
  void identify(scene::Fingerprint fingerprint) { fingerprint_ = std::move(fingerprint); }
  /// It goes on after the steps of an earlier one, with their displacements of points and their distances.
  void resume(solve::Checkpoint checkpoint, std::vector<std::vector<solve::Vec3>> points,
              std::vector<std::vector<double>> distances);
  /// The run ends before its end.
  void fail(std::string reason) { failure_ = std::move(reason); }
  /// A stage ended or failed.
  void follow(const solve::Simulation& simulation);

 private:
  const scene::Scene& scene_;
  base::Timer& timer_;
  std::vector<solve::StepReport> reports_;
  solve::State state_;
  std::vector<std::vector<solve::Vec3>> points_;
  std::vector<std::vector<double>> distances_;
  solve::SolveStatistics statistics_;
  std::vector<std::string> notes_, warnings_;
  std::string stopped_, failure_;
  scene::Fingerprint fingerprint_;
  std::optional<solve::Checkpoint> checkpoint_;
  mutable std::shared_ptr<const solve::Fields> fields_;  ///< null: not asked for in this state
  mutable std::unique_ptr<PressureReport> pressure_;     ///< likewise
  mutable std::optional<Pierced> pierced_;               ///< likewise
};

}  // namespace toile::run
