#include <Tpetra_Core.hpp>
#include <iostream>

#include "commands.hpp"
#include "recorder.hpp"
#include "start.hpp"
#include "toile/base/error.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/result/available.hpp"

namespace toile::app {

int check(const CheckArguments& arguments) {
  const bool first = Tpetra::getDefaultComm()->getRank() == 0;
  base::Log log = first ? base::Log(std::cout, std::cerr) : base::Log();
  base::Timer timer;
  const material::Laws laws = material::read_laws(arguments.scene, "scene", arguments.allow_plugins);
  const base::List list = base::read_xml(arguments.scene, scene::scene_spec(laws));
  const scene::Scene scene(list, 1, timer, laws);
  check_names(scene, list);
  const scene::StartReport start = scene::look_at_start(scene, list);
  if (!arguments.output.empty() && first) {
    if (!result::files_available()) log.warn("this build of Toile writes no start.exo (TOILE_ENABLE_RESULT=OFF)");
    Recorder(scene, arguments.output).write_start();
  }
  tell_start(start, log);
  log.info(arguments.scene + ": valid. " + std::to_string(scene.garment().mesh.nodes()) + " nodes, " +
           std::to_string(scene.garment().mesh.elements()) + " elements, " +
           std::to_string(scene.garment().seams.size()) + " seams, " + std::to_string(scene.stages().size()) +
           " stages" + (scene.surface() != nullptr ? "; " + scene.surface()->summary() : std::string()));
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace toile::app
