#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <Tpetra_Core.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "run.hpp"
#include "stop_signal.hpp"
#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
#include "toile/run/accuracy.hpp"
#include "toile/run/outputs.hpp"

namespace toile::app {

namespace {

std::string folder_of(const RunArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return "results/" + std::filesystem::path(arguments.scene).stem().string();
}

/// What takes the run up where it ended.
std::string restart_text(const RunArguments& arguments) {
  std::string command = "toile run " + arguments.scene;
  if (!arguments.output.empty()) command += " --output " + arguments.output;
  if (arguments.threads != 1) command += " --threads " + std::to_string(arguments.threads);
  return "\nTo go on after the last step that is on disk: " + command +
         (arguments.allow_plugins ? " --allow-plugins" : "") + " --restart";
}

/// Whether a later run may get further although nothing but a limit, or the room on the disk, is another.
bool may_go_on(const run::Session& session, base::ExitCode code, size_t steps_before) {
  const size_t steps = session.record().reports().size();
  if (!result::files_available()) return false;
  if (code == base::ExitCode::bad_input) return steps > steps_before;
  return steps > 0 && !session.record().stopped().empty();
}

/// The scene with another value of its parameter "finer".
std::unique_ptr<run::Session> finer_session(const RunArguments& arguments, double finer) {
  Teuchos::ParameterList content("scene");
  content.set("include", Teuchos::Array<std::string>(1, std::filesystem::absolute(arguments.scene).string()));
  content.set("finer", finer);
  return std::make_unique<run::Session>(content, arguments.scene, options_of(arguments));
}

int run(const RunArguments& arguments) {
  auto first = std::make_unique<run::Session>(arguments.scene, options_of(arguments));
  if (!first->scene().accuracy()) {
    run_session(*first, arguments);
    return static_cast<int>(base::ExitCode::success);
  }
  if (arguments.restart)
    first->list().list("Accuracy").fail("error", "a run to an accuracy starts anew each time; leave out --restart");
  const double own = first->list().real("finer");
  const auto start = [&](double finer) {
    if (first != nullptr) return std::move(first);
    return finer_session(arguments, own * finer);
  };
  run::run_to_accuracy(
      start, [&](run::Session& session) { run_session(session, arguments); }, folder_of(arguments));
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

run::Options options_of(const RunArguments& arguments) {
  run::Options options;
  options.threads = arguments.threads;
  options.allow_plugins = arguments.allow_plugins;
  if (Tpetra::getDefaultComm()->getRank() == 0) options.log = base::Log(std::cout, std::cerr, arguments.quiet);
  return options;
}

void run_session(run::Session& session, const RunArguments& arguments) {
  const std::string folder = folder_of(arguments);
  if (arguments.restart) session.resume(folder + "/restart.h5");
  run::add_outputs(session, {folder, arguments.heartbeat});
  session.log().info(session.scene().title() + "\n" + std::to_string(session.scene().garment().mesh.nodes()) +
                     " nodes, " + std::to_string(Tpetra::getDefaultComm()->getSize()) + " rank(s), results in " +
                     folder);
  if (!result::files_available())
    session.log().warn(
        "this build of Toile writes no results.exo, history.h5 and restart.h5 (TOILE_ENABLE_RESULT=OFF)");
  catch_stop_signals();
  session.stop_when(stop_signal);
  const size_t steps_before = session.record().reports().size();
  try {
    session.run();
  } catch (const base::Error& error) {
    if (!may_go_on(session, error.code(), steps_before)) throw;
    throw base::Error(error.code(), error.what() + restart_text(arguments));
  }
}

void add_run(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App* run = program.add_subcommand("run", "Run a scene and write its results");
  run->add_option("scene", arguments->scene, "XML file of the scene")->required();
  add_output_option(run, arguments->output, "Folder of the results (default: results/<name of the scene>)");
  run->add_option("--threads", arguments->threads, "Threads of each rank in the element loops (default: 1)")
      ->check(CLI::Range(1, 1024));
  run->add_option("--heartbeat", arguments->heartbeat,
                  "Seconds without a line after which the iterations of a step are told of (default: 5)")
      ->check(CLI::Range(0.0, 1e9));
  run->add_flag("--quiet", arguments->quiet, "Print errors and warnings only");
  run->add_flag("--restart", arguments->restart,
                "Go on after the last step that is in the folder of the results, from its restart.h5");
  add_plugins_flag(run, arguments->allow_plugins);
  run->callback([arguments, &chosen] { chosen = [arguments] { return app::run(*arguments); }; });
}

}  // namespace toile::app
