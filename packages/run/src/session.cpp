#include "toile/run/session.hpp"

#include <omp.h>

#include <Tpetra_Core.hpp>
#include <utility>

#include "alike.hpp"
#include "overlaps.hpp"
#include "restart_file.hpp"
#include "toile/base/error.hpp"
#include "toile/base/read_content.hpp"
#include "toile/material/read_laws.hpp"

namespace toile::run {

namespace {

constexpr const char* root = "scene";

/// From here on the element loops have so many threads.
int ranks_with_threads(int threads) {
  if (threads > 0) omp_set_num_threads(threads);
  return Tpetra::getDefaultComm()->getSize();
}

bool listens(const Observer& observer) {
  return observer.on_every_rank() || is_first_rank();
}

}  // namespace

template <class Read>
Session::Input Session::read_input(const material::Laws& laws, const Read& read) {
  std::vector<std::string> warnings;
  const base::List list = read(scene::scene_spec(laws, &warnings));
  return {laws, list, warnings};
}

Session::Session(Input input, const Options& options)
    : log_(options.log),
      input_(std::move(input)),
      list_(input_.list),
      scene_(list_, ranks_with_threads(options.threads), timer_, input_.laws),
      record_(scene_, timer_) {}

Session::Session(const std::string& file, const Options& options)
    : Session(
          [&] {
            const material::Laws laws = material::read_laws(file, root, options.allow_plugins);
            return read_input(laws, [&](const base::Spec& spec) { return base::read_xml(file, spec); });
          }(),
          options) {}

Session::Session(const Teuchos::ParameterList& content, const std::string& name, const Options& options)
    : Session(
          [&] {
            const base::Content source{content, name};
            const material::Laws laws = material::read_laws(source, root, options.allow_plugins);
            return read_input(laws, [&](const base::Spec& spec) { return base::read_content(source, spec); });
          }(),
          options) {}

Session::Session(const base::List& list, const Options& options) : Session(Input{material::Laws(), list}, options) {}

Session::~Session() = default;

const scene::StartReport& Session::start_report() {
  if (!start_) {
    const solve::Fields fields = solve::compute_fields(scene_.problem(), scene_.start());
    start_ = scene::look_at_start(scene_, list_, fields);
    start_->warnings.insert(start_->warnings.end(), input_.warnings.begin(), input_.warnings.end());
    const auto phase = timer_.phase("overlaps");
    for (std::string& text : overlaps_of_start(scene_, fields)) start_->warnings.push_back(std::move(text));
  }
  return *start_;
}

void Session::add(std::unique_ptr<Observer> observer) {
  observers_.push_back(std::move(observer));
}

void Session::identify() {
  if (record_.fingerprint().values.empty())
    record_.identify(scene::fingerprint(list_, scene::scene_spec(input_.laws), scene_));
}

void Session::resume(const std::string& restart_file) {
  identify();
  alike([&] {
    read_restart(restart_file, record_);
    const solve::Checkpoint& checkpoint = record_.checkpoint();
    log_.info("Going on after step " + std::to_string(record_.last().step) + ", of stage \"" + checkpoint.stage.name +
              "\", from " + restart_file);
  });
  resumed_ = true;
}

void Session::run() {
  if (std::exchange(ran_, true)) throw base::Error(base::ExitCode::internal_error, "a session runs once");
  scene_.check_drape();
  identify();
  if (!resumed_) tell_start(start_report(), log_);
  notify([this](Observer& o) { o.start(record_); });
  try {
    run_stages();
  } catch (const base::SolveError& error) {
    record_.fail(error.what());
    throw base::SolveError(error.what() + tell_failure());
  } catch (const std::exception& error) {
    record_.fail(error.what());
    if (alike_) tell_failure();
    throw;
  }
  notify([this](Observer& o) { o.end(record_); });
}

void Session::run_stages() {
  solve::Simulation simulation(scene_.problem(), scene_.solver());
  if (resumed_)
    simulation.resume(record_.checkpoint());
  else
    simulation.set_start(record_.state());
  record_.follow(simulation);
  watch(simulation);
  int number = 0;
  for (const solve::StageOptions& stage : scene_.stages())
    if (number++ < simulation.stages_behind())
      simulation.run(stage);  // passes over it
    else
      run_stage(simulation, stage);
}

void Session::run_stage(solve::Simulation& simulation, const solve::StageOptions& stage) {
  notify([&](Observer& o) { o.start_stage(record_, stage); });
  try {
    const auto phase = timer_.phase("solve");
    simulation.run(stage);
  } catch (const base::SolveError&) {
    record_.follow(simulation);
    throw_pending();
    throw;
  } catch (...) {
    record_.follow(simulation);
    throw;
  }
  record_.follow(simulation);
  throw_pending();
  notify([&](Observer& o) { o.end_stage(record_, stage); });
}

/// An error of who is told of an iteration must not leave the solve on one rank alone: it waits for the stage's end.
void Session::watch(solve::Simulation& simulation) {
  simulation.observe([this, &simulation](const solve::StepReport& report, const solve::State& state) {
    record_.add(report, state, simulation.checkpoint());
    const auto phase = timer_.phase("output");
    notify([this](Observer& o) { o.step(record_); });
  });
  simulation.observe_iterations([this](const solve::IterationReport& report) {
    for (const auto& observer : observers_) {
      if (pending_ || !listens(*observer)) continue;
      try {
        observer->iteration(record_, report);
      } catch (...) {
        pending_ = std::current_exception();
        failed_ = observer.get();
      }
    }
  });
  simulation.stop_when([this]() -> std::string {
    if (pending_) return "who follows the run has failed";
    return wanted_ ? wanted_() : std::string();
  });
}

void Session::notify(const std::function<void(Observer&)>& tell) {
  alike_ = true;
  alike([&] {
    for (const auto& observer : observers_) {
      if (!listens(*observer)) continue;
      failed_ = observer.get();
      tell(*observer);
    }
    failed_ = nullptr;
  });
  alike_ = false;
}

void Session::throw_pending() {
  alike_ = true;
  alike([this] {
    if (pending_) std::rethrow_exception(std::exchange(pending_, nullptr));
  });
  alike_ = false;
}

std::string Session::tell_failure() {
  std::string kept;
  for (const auto& observer : observers_) {
    if (!listens(*observer) || observer.get() == failed_) continue;
    try {
      const std::string here = observer->failure(record_);
      if (!here.empty()) kept += (kept.empty() ? "" : ", and") + here;
    } catch (const std::exception& error) {
      log_.warn(error.what());
    }
  }
  if (kept.empty()) return kept;
  if (record_.reports().empty()) return " No step was accepted" + kept + ".";
  return " The last converged state, step " + std::to_string(record_.last().step) + "," + kept + ".";
}

void tell_start(const scene::StartReport& start, base::Log& log) {
  std::string text = "Start";
  for (const std::string& line : start.lines) text += "\n  " + line;
  log.info(text);
  for (const std::string& warning : start.warnings) log.warn(warning);
  if (start.errors.empty()) return;
  std::string all;
  for (const std::string& error : start.errors) all += (all.empty() ? "" : "\n") + error;
  throw base::InputError(all);
}

}  // namespace toile::run
