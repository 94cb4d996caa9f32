#include <omp.h>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "checks.hpp"
#include "commands.hpp"
#include "findings.hpp"
#include "recorder.hpp"
#include "start.hpp"
#include "stop_signal.hpp"
#include "summary.hpp"
#include "toile/base/error.hpp"
#include "toile/base/log.hpp"
#include "toile/base/progress.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/result/available.hpp"

namespace toile::app {

namespace {

/// Something that only rank 0 does (files): if it fails there, every rank gets the error.
template <class F>
void on_first_rank(const F& work) {
  const auto comm = Tpetra::getDefaultComm();
  int code = 0;
  std::string message;
  if (comm->getRank() == 0) {
    try {
      work();
    } catch (const base::Error& error) {
      code = static_cast<int>(error.code());
      message = error.what();
    } catch (const std::exception& error) {
      code = static_cast<int>(base::ExitCode::internal_error);
      message = error.what();
    }
  }
  Teuchos::broadcast(*comm, 0, Teuchos::outArg(code));
  if (code != 0) throw base::Error(static_cast<base::ExitCode>(code), message);
}

/// What is on disk after a stage failed. A run that accepted no step writes its start now.
std::string kept_text(Recorder& recorder, const std::string& folder) {
  if (!result::files_available()) return "";
  if (!recorder.reports().empty())
    return " The last converged state, step " + std::to_string(recorder.reports().back().step) +
           ", is the last one in " + folder + "/results.exo, and in " + folder + "/restart.h5.";
  try {
    recorder.write_start();
  } catch (const base::Error& error) {
    return std::string(" No step was accepted, and the start is not written either: ") + error.what();
  }
  return " No step was accepted; the start is in " + folder + "/start.exo.";
}

/// The tables over the steps that were accepted; that the stage failed matters more than that they cannot be written.
void write_histories_of_failed_run(std::optional<Recorder>& recorder, base::Log& log) {
  try {
    on_first_rank([&] { recorder->write_histories(log); });
  } catch (const base::Error& error) {
    log.warn(error.what());
  }
}

/// The files of a run that has ended.
std::string files_text(const Recorder& recorder) {
  std::string text = "Files in " + recorder.folder() + ":";
  for (const std::string& name : recorder.written()) text += " " + name;
  return text;
}

/// What is good to know of a run and what limits the trust in it, whether or not it reached its end.
void tell(const solve::Simulation& simulation, base::Log& log) {
  for (const std::string& note : simulation.notes()) log.info("note: " + note);
  for (const std::string& warning : simulation.warnings()) log.warn(warning);
}

base::ProgressPoint progress_of(const solve::StepReport& r, int stage_number, int stages, double seconds) {
  base::ProgressPoint point;
  point.stage = r.stage;
  point.stage_number = stage_number;
  point.stages = stages;
  point.step = r.step;
  point.parameter = r.parameter;
  point.load = r.load;
  point.iterations = r.iterations;
  point.seconds = seconds;
  point.final_state = r.undamped;
  return point;
}

/// What the terminal shows while a stage runs: a line an accepted step, and one now and then inside a step that takes
/// long.
class Progress {
 public:
  Progress(const scene::Scene& scene, const base::Timer& timer, base::Log& log, double interval)
      : scene_(scene), timer_(timer), log_(log), heartbeat_(interval, [&timer] { return timer.elapsed(); }) {}

  void start_stage() {
    ++stage_number_;
    path_.start(timer_.elapsed());
  }
  void step(const solve::StepReport& report) {
    base::ProgressPoint point = progress_of(report, stage_number_, stages(), timer_.elapsed());
    path_.reach(report.parameter, point.seconds);
    if (!report.undamped) point.left = path_.left();
    log_.info(base::progress_line(point));
    heartbeat_.line_printed();
  }
  void iteration(const solve::IterationReport& report) {
    if (!log_.prints() || !heartbeat_.due()) return;
    base::IterationPoint point;
    point.stage = report.stage;
    point.stage_number = stage_number_;
    point.stages = stages();
    point.parameter = report.parameter;
    point.relaxing = report.relaxing;
    point.iteration = report.iteration;
    point.cut_backs = report.cut_backs;
    point.residual = report.residual;
    point.tolerance = scene_.solver().newton.tolerance;
    point.seconds = timer_.elapsed();
    log_.info(base::iteration_line(point));
  }

 private:
  int stages() const { return static_cast<int>(scene_.stages().size()); }

  const scene::Scene& scene_;
  const base::Timer& timer_;
  base::Log& log_;
  base::Heartbeat heartbeat_;
  base::PathClock path_;
  int stage_number_ = 0;
};

/// A garment that does not press may be right, but nobody runs a scene for it.
void tell_idle(const scene::Scene& scene, const solve::Fields& fields, base::Log& log) {
  constexpr double nothing = 1e-7;  // MPa
  const auto presses = [](double pressure) { return pressure > nothing; };
  if (scene.problem().surface != nullptr && std::none_of(fields.pressure.begin(), fields.pressure.end(), presses))
    log.warn("the garment presses on the body nowhere: it is wider than the body, or beside it");
}

std::string folder_of(const RunArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return "results/" + std::filesystem::path(arguments.scene).stem().string();
}

}  // namespace

int run(const RunArguments& arguments) {
  const auto comm = Tpetra::getDefaultComm();
  const bool first = comm->getRank() == 0;
  base::Log log = first ? base::Log(std::cout, std::cerr, arguments.quiet) : base::Log();
  base::Timer timer;
  omp_set_num_threads(arguments.threads);

  const material::Laws laws = material::read_laws(arguments.scene, "scene", arguments.allow_plugins);
  const base::List list = base::read_xml(arguments.scene, scene::scene_spec(laws));
  const scene::Scene scene(list, comm->getSize(), timer, laws);
  check_names(scene, list);
  const std::string folder = folder_of(arguments);
  std::optional<Recorder> recorder;
  on_first_rank([&] { recorder.emplace(scene, folder); });
  log.info(scene.title() + "\n" + std::to_string(scene.garment().mesh.nodes()) + " nodes, " +
           std::to_string(comm->getSize()) + " rank(s), results in " + folder);

  if (!result::files_available())
    log.warn("this build of Toile writes no results.exo, history.h5 and restart.h5 (TOILE_ENABLE_RESULT=OFF)");

  tell_start(scene::look_at_start(scene, list), log);

  catch_stop_signals();
  solve::Simulation simulation(scene.problem(), scene.solver());
  simulation.set_start(scene.start());
  Progress progress(scene, timer, log, arguments.heartbeat);
  simulation.observe_iterations([&](const solve::IterationReport& report) { progress.iteration(report); });
  simulation.stop_when(stop_signal);
  simulation.observe([&](const solve::StepReport& r, const solve::State& state) {
    progress.step(r);
    const auto phase = timer.phase("output");
    on_first_rank([&] { recorder->step(r, state); });
  });
  for (const solve::StageOptions& stage : scene.stages()) {
    progress.start_stage();
    const auto phase = timer.phase("solve");
    try {
      simulation.run(stage);
    } catch (const base::SolveError& error) {
      tell(simulation, log);
      write_histories_of_failed_run(recorder, log);
      throw base::SolveError(error.what() + (first ? kept_text(*recorder, folder) : std::string()));
    }
  }

  std::vector<std::string> failed;
  on_first_rank([&] {
    const solve::StepReport& last = recorder->reports().back();
    PressureReport pressure;
    {
      const auto phase = timer.phase("curves");
      pressure = pressure_report(scene, recorder->last(), last);
      recorder->write_histories(log);
      recorder->write_pressure(pressure, log);
    }
    tell(simulation, log);
    for (const std::string& warning : pressure.warnings) log.warn(warning);
    tell_idle(scene, recorder->last(), log);
    for (const std::string& warning : field_warnings(scene, recorder->last(), last)) log.warn(warning);
    log.info(summary(scene, recorder->last(), last, simulation.statistics(), timer));
    log.info(findings(scene, recorder->last(), pressure) + files_text(*recorder));
    if (const auto warning = implausible_pressure(scene, recorder->last())) log.warn(*warning);
    failed = failed_checks(scene, figures_of(recorder->last(), last), pressure);
    std::string all;
    for (const std::string& f : failed) all += (all.empty() ? "" : "\n") + f;
    if (!failed.empty()) throw base::Error(base::ExitCode::check_failed, all);
  });
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace toile::app
