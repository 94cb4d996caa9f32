#include "toile/study/study.hpp"

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "stop_signal.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "toile/base/log.hpp"
#include "toile/study/report.hpp"
#include "toile/study/run_cases.hpp"
#include "toile/study/spec.hpp"

namespace toile::app {

namespace {

/// What the command line says of a study.
struct StudyArguments {
  std::string file;
  std::string output = "";  ///< folder; empty: results/<name of the file>
  int jobs = 0;             ///< 0: as the file says
  bool quiet = false, allow_plugins = false;
  bool describe = false, markdown = false;
};

const std::string study_reference_title =
    "# Input reference of a study\n\n"
    "What `toile study` reads: `<ParameterList name=\"study\">` with the lists below; see [study](study.md). "
    "This page is what `toile study --describe --markdown` prints.\n\n";

constexpr std::size_t most_program_bytes = std::size_t{4} << 30U;

/// Version and contents of this program: cases that another one has run are run again.
std::string program_identity(const std::string& program) {
  const std::string bytes = base::read_file(program, "this program", most_program_bytes);
  return std::string(TOILE_VERSION) + " " + std::to_string(std::hash<std::string>()(bytes));
}

std::string ended_text(const study::Outcome& outcome) {
  if (outcome.known) return "known";
  if (outcome.reason.empty()) return "done";
  return outcome.reason.substr(0, outcome.reason.find('\n'));
}

/// Runs a study and writes its report. Returns how many of its cases are bad.
std::size_t run_one(const std::string& file, const std::string& folder, const StudyArguments& arguments,
                    base::Log& log) {
  study::Study study = study::read_study(file, arguments.allow_plugins);
  if (arguments.jobs > 0) study.jobs = arguments.jobs;
  study::RunOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe").string();
  options.identity = program_identity(options.program);
  options.folder = folder;
  options.allow_plugins = arguments.allow_plugins;
  options.stop = [] { return !stop_signal().empty(); };
  std::size_t ended = 0;
  options.tell = [&](const study::Case& one, const study::Outcome& outcome) {
    log.info("  " + std::to_string(++ended) + "/" + std::to_string(study.cases.size()) + " " + one.name + ": " +
             ended_text(outcome));
  };
  log.info(study.title + "\n" + std::to_string(study.cases.size()) + " cases, results in " + folder);
  const std::vector<study::Outcome> outcomes = study::run_cases(study, options);
  const study::Evaluation evaluation = study::evaluate(study, outcomes, folder);
  for (const std::string& warning : study::write_report(study, outcomes, evaluation, folder)) log.warn(warning);
  log.info(study::report_text(study, outcomes, evaluation));
  const auto bad = std::count_if(evaluation.rows.begin(), evaluation.rows.end(), [](const study::Row& row) {
    return row.verdict == study::Verdict::wrong || row.verdict == study::Verdict::crashed ||
           row.verdict == study::Verdict::endless;
  });
  return static_cast<std::size_t>(bad);
}

int run_study(const StudyArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError("a study starts its runs itself: without mpirun; ranks are varied by the path run/ranks");
  namespace fs = std::filesystem;
  base::Log log(std::cout, std::cerr, arguments.quiet);
  const std::string folder =
      arguments.output.empty() ? "results/" + fs::path(arguments.file).stem().string() : arguments.output;
  const base::Texts files = study::study_files(arguments.file);
  catch_stop_signals();
  std::size_t bad = 0;
  for (const std::string& file : files)
    bad += run_one(file, files.size() == 1 ? folder : folder + "/" + fs::path(file).stem().string(), arguments, log);
  if (bad > 0)
    throw base::Error(base::ExitCode::check_failed,
                      std::to_string(bad) + " cases are wrong without a word of it, crashed or did not end in time");
  return static_cast<int>(base::ExitCode::success);
}

int describe_study(const StudyArguments& arguments) {
  const base::Spec spec = study::study_spec();
  if (Tpetra::getDefaultComm()->getRank() == 0)
    std::cout << (arguments.markdown ? study_reference_title + base::describe_markdown(spec)
                                     : base::describe_text(spec))
              << std::flush;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_study(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* study = program.add_subcommand("study", "Run variants of a scene: error against time and unknowns");
  CLI::Option* file = study->add_option("study", arguments->file, "XML file of the study");
  add_output_option(study, arguments->output, "Folder of the results (default: results/<name of the file>)");
  study->add_option("--jobs", arguments->jobs, "Cases that run side by side (default: as the file says)")
      ->check(CLI::Range(1, 1024));
  study->add_flag("--quiet", arguments->quiet, "Print errors and warnings only");
  add_plugins_flag(study, arguments->allow_plugins);
  CLI::Option* describing = study->add_flag("--describe", arguments->describe, "Print every parameter of a study file");
  study->add_flag("--markdown", arguments->markdown, "With --describe: as Markdown")->needs(describing);
  study->callback([arguments, file, &chosen] {
    if (!arguments->describe && file->count() == 0) throw CLI::RequiredError("study");
    chosen = [arguments] { return arguments->describe ? describe_study(*arguments) : run_study(*arguments); };
  });
}

}  // namespace toile::app
