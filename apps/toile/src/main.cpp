// The command line of Toile: toile run | check | describe.
#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <exception>
#include <iostream>

#include "commands.hpp"
#include "toile/base/error.hpp"

namespace {

using toile::base::ExitCode;

constexpr const char* footer =
    "Exit status: 0 success, 1 internal error, 2 bad input or command line, 3 a solve failed (the last converged state "
    "is on disk), 4 a check of the scene did not hold.";

int report(const std::string& message, ExitCode code) {
  if (Tpetra::getDefaultComm()->getRank() == 0) std::cerr << "toile: " << message << std::endl;
  return static_cast<int>(code);
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Toile computes what a garment does to the body that wears it."};
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION);
  app.require_subcommand(1);
  app.footer(footer);

  toile::app::RunArguments arguments;
  CLI::App* run = app.add_subcommand("run", "Run a scene and write its results");
  run->add_option("scene", arguments.scene, "XML file of the scene")->required();
  run->add_option("--output", arguments.output, "Folder of the results (default: results/<name of the scene>)");
  run->add_option("--threads", arguments.threads, "Threads of each rank in the element loops (default: 1)")
      ->check(CLI::Range(1, 1024));
  run->add_flag("--quiet", arguments.quiet, "Print errors and warnings only");
  run->footer(footer);

  std::string scene;
  CLI::App* check = app.add_subcommand("check", "Read and build a scene without solving it");
  check->add_option("scene", scene, "XML file of the scene")->required();

  bool markdown = false;
  std::string list;
  CLI::App* describe = app.add_subcommand("describe", "Print every list and parameter of a scene file");
  describe->add_option("list", list, "Only this list, for instance Panels");
  describe->add_flag("--markdown", markdown, "As Markdown");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const bool first = Tpetra::getDefaultComm()->getRank() == 0;
    const int status = first ? app.exit(error) : error.get_exit_code();
    return status == 0 ? 0 : static_cast<int>(ExitCode::bad_input);
  }
  if (run->parsed()) return toile::app::run(arguments);
  if (check->parsed()) return toile::app::check(scene);
  return toile::app::describe(markdown, list);
}

}  // namespace

int main(int argc, char** argv) {
  Tpetra::ScopeGuard scope(&argc, &argv);
  try {
    return dispatch(argc, argv);
  } catch (const toile::base::Error& error) {
    return report(error.what(), error.code());
  } catch (const std::exception& error) {
    return report(std::string("internal error: ") + error.what(), ExitCode::internal_error);
  }
}
