#pragma once

#include <string>

#include "toile/run/record.hpp"

namespace toile::run {

/// Somebody who is told of a run as it goes on: by a session, in the order in which they were added to it.
/// What an observer throws ends the run with that error on every rank, with all that was written before kept.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// False: only the first rank calls it, as who writes files wants it. It must not communicate.
  virtual bool on_every_rank() const { return false; }

  /// The scene is built, and nothing is solved yet.
  virtual void start(const Record&) {}
  virtual void start_stage(const Record&, const solve::StageOptions&) {}
  /// After each iteration of Newton's method. An error ends the run after this iteration.
  virtual void iteration(const Record&, const solve::IterationReport&) {}
  /// A step was accepted: it is the last one of the record.
  virtual void step(const Record&) {}
  virtual void end_stage(const Record&, const solve::StageOptions&) {}
  /// Every stage has reached its end.
  virtual void end(const Record&) {}
  /// A stage failed, or an observer did; the record ends with the last accepted step. Returns where this observer keeps
  /// that state, for the message (" is in out/restart.h5"), or nothing. What it throws becomes a warning.
  virtual std::string failure(const Record&) { return {}; }
};

}  // namespace toile::run
