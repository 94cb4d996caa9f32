// The command line of Toile; the commands are in sources of their own.
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

void add_footer(CLI::App& app) {
  app.footer(footer);
  for (CLI::App* sub : app.get_subcommands(nullptr)) add_footer(*sub);
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Toile computes what a garment does to the body that wears it.", "toile"};
  app.set_version_flag("--version", std::string("toile ") + TOILE_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  toile::app::Chosen chosen;
  for (const toile::app::AddCommand add : toile::app::commands()) add(app, chosen);
  add_footer(app);
  if (const int status = parse(app, argc, argv); status >= 0) return status;
  return chosen();
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
