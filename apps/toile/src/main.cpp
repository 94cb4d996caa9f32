// The command line of Toile: toile run | check | identify | describe | material.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"

namespace {

using toile::base::ExitCode;
using toile::base::Texts;

constexpr const char* footer =
    "Exit status: 0 success, 1 internal error, 2 bad input or command line, 3 a solve failed (the last converged state "
    "is on disk), 4 a check of the scene or of a fabric did not hold.";

constexpr const char* allow_text = "Load the plug-ins that the file names; they are programs that run with your rights";

int report(const std::string& message, ExitCode code) {
  if (Tpetra::getDefaultComm()->getRank() == 0) std::cerr << "toile: " << message << std::endl;
  return static_cast<int>(code);
}

/// The other ranks may not have failed, and would wait for this one for ever: all of them are ended.
int fail_everywhere(const std::string& message, ExitCode code) {
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() == 1) return report(message, code);
  std::cerr << "toile: on rank " << comm->getRank() << ": " << message << std::endl;
  return MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
}

[[noreturn]] void fail_unknown(const std::string& kind, const std::string& found, const Texts& valid) {
  const std::string near = toile::base::nearest_name(found, valid);
  std::string text = "unknown " + kind + " \"" + found + "\"";
  text += near.empty() ? "." : "; did you mean \"" + near + "\"?";
  text += " Valid here:";
  for (const std::string& name : valid) text += " " + name;
  throw toile::base::InputError(text);
}

Texts subcommands_of(const CLI::App& app) {
  Texts names;
  for (const CLI::App* sub : app.get_subcommands(nullptr)) names.push_back(sub->get_name());
  return names;
}

Texts options_of(const CLI::App& app) {
  Texts names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// What is wrong with the command line: a misspelt option, one argument too many, or what the parser says.
[[noreturn]] void explain(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* innermost = &app;
  std::string command = "toile";
  while (!innermost->get_subcommands().empty()) {
    innermost = innermost->get_subcommands().front();
    command += " " + innermost->get_name();
  }
  const CLI::App& used = *innermost;
  const Texts extras = app.remaining(true);
  for (const std::string& extra : extras)
    if (extra.front() == '-')
      fail_unknown("option of \"" + command + "\"", extra.substr(0, extra.find('=')), options_of(used));
  const std::string problem =
      extras.empty() ? error.what() : "\"" + command + "\" does not take the argument \"" + extras.front() + "\"";
  throw toile::base::InputError(problem + ". See " + command + " --help");
}

int parse(CLI::App& app, int argc, char** argv) {
  const Texts subcommands = subcommands_of(app);
  const std::string first = argc > 1 ? argv[1] : "";
  if (!first.empty() && first.front() != '-' &&
      std::find(subcommands.begin(), subcommands.end(), first) == subcommands.end())
    fail_unknown("subcommand", first, subcommands);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return Tpetra::getDefaultComm()->getRank() == 0 ? app.exit(help) : help.get_exit_code();
  } catch (const CLI::ParseError& error) {
    explain(app, error);
  }
  return -1;
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Toile computes what a garment does to the body that wears it.", "toile"};
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  app.footer(footer);

  toile::app::RunArguments arguments;
  CLI::App* run = app.add_subcommand("run", "Run a scene and write its results");
  run->add_option("scene", arguments.scene, "XML file of the scene")->required();
  run->add_option("--output", arguments.output, "Folder of the results (default: results/<name of the scene>)")
      ->type_name("DIR");
  run->add_option("--threads", arguments.threads, "Threads of each rank in the element loops (default: 1)")
      ->check(CLI::Range(1, 1024));
  run->add_option("--heartbeat", arguments.heartbeat,
                  "Seconds without a line after which the iterations of a step are told of (default: 5)")
      ->check(CLI::Range(0.0, 1e9));
  run->add_flag("--quiet", arguments.quiet, "Print errors and warnings only");
  run->add_flag("--restart", arguments.restart,
                "Go on after the last step that is in the folder of the results, from its restart.h5");

  run->add_flag("--allow-plugins", arguments.allow_plugins, allow_text);

  toile::app::CheckArguments checked;
  CLI::App* check = app.add_subcommand("check", "Read and build a scene without solving it, and look at its start");
  check->add_option("scene", checked.scene, "XML file of the scene")->required();
  check->add_option("--output", checked.output, "Write the start to start.exo in this folder")->type_name("DIR");
  check->add_flag("--allow-plugins", checked.allow_plugins, allow_text);

  toile::app::MaterialCheckArguments fabric;
  CLI::App* material = app.add_subcommand("material", "Work on fabrics");
  material->require_subcommand(1);
  CLI::App* check_material = material->add_subcommand("check", "Check a fabric's energy and map where it loses what");
  check_material->add_option("file", fabric.file, "XML file with lists Material and Check, or a scene");
  check_material->add_option("material", fabric.material, "Which of the scene's materials");
  check_material
      ->add_option("--output", fabric.output, "Folder of the maps (default: results/<name of the file>-check)")
      ->type_name("DIR");
  check_material->add_flag("--allow-plugins", fabric.allow_plugins, allow_text);
  check_material->add_flag("--all", fabric.all, "Every published set, in its literal form too");

  toile::app::IdentifyArguments fit_arguments;
  bool describe_fit = false;
  bool markdown = false;
  CLI::App* identify = app.add_subcommand("identify", "Fit the parameters of a material to tests of the fabric");
  CLI::Option* fit_file = identify->add_option("fit", fit_arguments.file, "XML file of the fit");
  identify->add_option("--output", fit_arguments.output, "Folder of the results (default: results/<name of the file>)")
      ->type_name("DIR");
  identify->add_flag("--quiet", fit_arguments.quiet, "Print errors and warnings only");
  identify->add_flag("--allow-plugins", fit_arguments.allow_plugins, allow_text);
  CLI::Option* describing = identify->add_flag("--describe", describe_fit,
                                               "Print every parameter of a fit file (of this one: its own laws too)");
  identify->add_flag("--markdown", markdown, "With --describe: as Markdown")->needs(describing);
  identify->callback([&] {
    if (!describe_fit && fit_file->count() == 0) throw CLI::RequiredError("fit");
  });

  std::string list, scene;
  bool allow_plugins = false;
  CLI::App* describe = app.add_subcommand("describe", "Print every list and parameter of a scene file");
  describe->add_option(
      "list", list,
      "Only this list or parameter: its name or path, \"Panels > front > width\", or an error message; "
      "fields: what is written");
  describe->add_flag("--markdown", markdown, "As Markdown");
  describe->add_option("--scene", scene, "Also the plug-ins and formulas of this scene");
  describe->add_flag("--allow-plugins", allow_plugins, allow_text);

  std::string source, library;
  bool verbose = false;
  CLI::App* build = material->add_subcommand("build", "Compile a fabric to a plug-in that scenes can load");
  build->add_option("source", source, "C++ file of the fabric")->required();
  build->add_option("-o,--output", library, "The plug-in (default: the name of the source with .so)")
      ->type_name("FILE");
  build->add_flag("--verbose", verbose, "Print the compiler's command and all that it says");
  for (CLI::App* sub : {run, check, identify, describe, material, check_material, build}) sub->footer(footer);

  if (const int status = parse(app, argc, argv); status >= 0) return status;
  if (run->parsed()) return toile::app::run(arguments);
  if (identify->parsed())
    return describe_fit ? toile::app::describe_fit(fit_arguments, markdown) : toile::app::identify(fit_arguments);
  if (check->parsed()) return toile::app::check(checked);
  if (check_material->parsed()) return toile::app::check_material(fabric);
  if (build->parsed()) return toile::app::build_material(source, library, verbose);
  return toile::app::describe(markdown, list, scene, allow_plugins);
}

}  // namespace

int main(int argc, char** argv) {
  // A file beyond the user's limit is then an error with a reason, as a full disk is, and not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  // Kokkos would read --threads and --help as its own.
  int own_argc = 1;
  char** own_argv = argv;
  Tpetra::ScopeGuard scope(&own_argc, &own_argv);
  try {
    return dispatch(argc, argv);
  } catch (const toile::base::Error& error) {
    return report(error.what(), error.code());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail_everywhere(std::string("a file cannot be used: ") + error.what(), ExitCode::bad_input);
  } catch (const std::bad_alloc&) {
    return fail_everywhere("the memory does not suffice for this input", ExitCode::bad_input);
  } catch (const std::exception& error) {
    return fail_everywhere(std::string("internal error: ") + error.what(), ExitCode::internal_error);
  }
}
