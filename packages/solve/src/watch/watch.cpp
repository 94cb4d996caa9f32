#include "watch/watch.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <sstream>
#include <utility>

namespace toile::solve {

namespace {

enum class Stop { no, run_time, stage_time, iterations, wanted };

std::string seconds_text(double seconds) {
  std::ostringstream out;
  out << seconds << " s";
  return out.str();
}

}  // namespace

Watch::Watch(RCP<const Comm> comm, double most_time) : comm_(std::move(comm)), most_time_(most_time) {}

double Watch::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Watch::start_stage(const StageOptions& stage) {
  stage_most_time_ = stage.most_time;
  stage_start_ = now();
  stage_most_iterations_ = stage.most_iterations;
  iterations_ = 0;
  report_ = IterationReport();
  report_.stage = stage.name;
}

// The clock is the first rank's; the wish to stop may have reached any rank.
void Watch::find_reason() {
  const std::string wish = wanted_ ? wanted_() : std::string();
  Stop mine = Stop::no;
  if (!wish.empty())
    mine = Stop::wanted;
  else if (iterations_ > stage_most_iterations_)
    mine = Stop::iterations;
  else if (comm_->getRank() == 0 && stage_most_time_ > 0.0 && now() - stage_start_ > stage_most_time_)
    mine = Stop::stage_time;
  else if (comm_->getRank() == 0 && most_time_ > 0.0 && now() > most_time_)
    mine = Stop::run_time;
  int all = 0;
  Teuchos::reduceAll(*comm_, Teuchos::REDUCE_MAX, static_cast<int>(mine), Teuchos::outArg(all));
  if (all == static_cast<int>(Stop::wanted)) {
    stopped_ = wish.empty() ? "it was asked to end" : wish;
  } else if (all == static_cast<int>(Stop::iterations)) {
    stopped_ = "it has taken " + std::to_string(stage_most_iterations_) + " iterations, its \"most iterations in all\"";
  } else if (all == static_cast<int>(Stop::stage_time)) {
    stopped_ = "it has taken longer than its \"most time\", " + seconds_text(stage_most_time_);
  } else if (all == static_cast<int>(Stop::run_time)) {
    stopped_ = "the run has taken longer than \"most time\" of the list \"Solver\", " + seconds_text(most_time_);
  }
}

bool Watch::go_on(int iteration, double s, double residual, double gap) {
  if (!stopped_.empty()) return false;
  if (iteration == 0) residuals_.clear();
  residuals_.push_back(residual);
  if (iteration > 0) ++iterations_;
  report_.iteration = iteration;
  report_.parameter = s;
  report_.residual = residual;
  report_.gap = gap;
  if (observer_) observer_(report_);
  find_reason();
  return stopped_.empty();
}

}  // namespace toile::solve
