#include <Tpetra_Core.hpp>
#include <iostream>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
#include "toile/run/outputs.hpp"

namespace toile::app {

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
  log.info(arguments.scene + ": valid. " + std::to_string(scene.garment().mesh.nodes()) + " nodes, " +
           std::to_string(scene.garment().mesh.elements()) + " elements, " +
           std::to_string(scene.garment().seams.size()) + " seams, " + std::to_string(scene.stages().size()) +
           " stages" + (scene.surface() != nullptr ? "; " + scene.surface()->summary() : std::string()));
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace toile::app
