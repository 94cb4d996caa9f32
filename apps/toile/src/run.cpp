#include <Tpetra_Core.hpp>
#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "stop_signal.hpp"
#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
#include "toile/run/outputs.hpp"

namespace toile::app {

namespace {

std::string folder_of(const RunArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return "results/" + std::filesystem::path(arguments.scene).stem().string();
}

}  // namespace

int run(const RunArguments& arguments) {
  const auto comm = Tpetra::getDefaultComm();
  run::Options options;
  options.threads = arguments.threads;
  options.allow_plugins = arguments.allow_plugins;
  if (comm->getRank() == 0) options.log = base::Log(std::cout, std::cerr, arguments.quiet);
  run::Session session(arguments.scene, options);
  const std::string folder = folder_of(arguments);
  run::add_outputs(session, {folder, arguments.heartbeat});
  session.log().info(session.scene().title() + "\n" + std::to_string(session.scene().garment().mesh.nodes()) +
                     " nodes, " + std::to_string(comm->getSize()) + " rank(s), results in " + folder);
  if (!result::files_available())
    session.log().warn(
        "this build of Toile writes no results.exo, history.h5 and restart.h5 (TOILE_ENABLE_RESULT=OFF)");
  catch_stop_signals();
  session.stop_when(stop_signal);
  session.run();
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace toile::app
