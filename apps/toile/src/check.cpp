#include <Tpetra_Core.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
#include "toile/run/outputs.hpp"

namespace toile::app {

namespace {

/// What the command line says of a check of a scene.
struct CheckArguments {
  std::string scene;           ///< XML file
  std::string output = "";     ///< folder for the start; empty: it is not written
  bool allow_plugins = false;  ///< the scene may load programs
};

int check(const CheckArguments& arguments) {
  run::Options options;
  options.allow_plugins = arguments.allow_plugins;
  if (Tpetra::getDefaultComm()->getRank() == 0) options.log = base::Log(std::cout, std::cerr);
  run::Session session(arguments.scene, options);
  base::Log& log = session.log();
  const scene::Scene& scene = session.scene();
  run::check_names(scene, session.list());
  if (!arguments.output.empty()) {
    if (!result::files_available()) log.warn("this build of Toile writes no start.exo (TOILE_ENABLE_RESULT=OFF)");
    run::write_start(session, arguments.output);
  }
  run::tell_start(session.start_report(), log);
  scene.check_drape();
  log.info(arguments.scene + ": valid. " + std::to_string(scene.garment().mesh.nodes()) + " nodes, " +
           std::to_string(scene.garment().mesh.elements()) + " elements, " +
           std::to_string(scene.garment().seams.size()) + " seams, " + std::to_string(scene.stages().size()) +
           " stages" + (scene.surface() != nullptr ? "; " + scene.surface()->summary() : std::string()));
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_check(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* check = program.add_subcommand("check", "Read and build a scene without solving it, and look at its start");
  check->add_option("scene", arguments->scene, "XML file of the scene")->required();
  add_output_option(check, arguments->output, "Write the start to start.exo in this folder");
  add_plugins_flag(check, arguments->allow_plugins);
  check->callback([arguments, &chosen] { chosen = [arguments] { return app::check(*arguments); }; });
}

}  // namespace toile::app
