#include "toile/study/run_cases.hpp"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "toile/base/error.hpp"
#include "toile/base/process.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::study {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Ends a case's folder: there when the case has ended, whatever came of it.
constexpr const char* record_name = "case.json";
const std::string warning_mark = "warning: ", error_mark = "toile: ";

void write(const std::string& path, const std::string& text) {
  result::replace_file(path, text, "cannot write '" + path + "': ");
}

std::optional<Outcome> known_outcome(const std::string& folder, const Case& one, const Study& study,
                                     const RunOptions& options) {
  std::ifstream file(folder + "/" + record_name);
  if (!file) return std::nullopt;
  const Json record = Json::parse(file, nullptr, false);
  if (!record.is_object() || record.value("program", "") != options.identity ||
      record.value("input", "") != one.identity)
    return std::nullopt;
  Outcome outcome;
  outcome.status = record.value("status", 0);
  outcome.signal = record.value("signal", 0);
  outcome.out_of_time = record.value("out of time", false);
  outcome.reason = record.value("reason", "");
  outcome.warnings = record.value("warnings", base::Texts{});
  outcome.seconds = record.value("seconds", 0.0);
  outcome.processor_seconds = record.value("processor seconds", 0.0);
  outcome.known = true;
  if (outcome.out_of_time && outcome.seconds < study.most_seconds) return std::nullopt;
  return outcome;
}

void keep(const std::string& folder, const Case& one, const Outcome& outcome, const RunOptions& options) {
  const Json record = {{"program", options.identity},
                       {"input", one.identity},
                       {"status", outcome.status},
                       {"signal", outcome.signal},
                       {"out of time", outcome.out_of_time},
                       {"reason", outcome.reason},
                       {"warnings", outcome.warnings},
                       {"seconds", outcome.seconds},
                       {"processor seconds", outcome.processor_seconds}};
  write(folder + "/" + record_name, record.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::vector<std::string> command_of(const Case& one, const RunOptions& options) {
  std::vector<std::string> command;
  // Who started the study has decided under which user it runs, and how many ranks share the processors.
  if (one.ranks > 1)
    command = {
        "mpirun", "--allow-run-as-root",    "--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1",
        "-n",     std::to_string(one.ranks)};
  for (const char* word :
       {options.program.c_str(), "run", "case.xml", "--output", ".", "--quiet", "--no-pictures", "--threads"})
    command.emplace_back(word);
  command.push_back(std::to_string(one.threads));
  if (options.allow_plugins) command.emplace_back("--allow-plugins");
  return command;
}

/// What the program said: warnings, and after "toile: " why it has no result.
void read_messages(const std::string& errors, Outcome& outcome) {
  std::istringstream lines(errors);
  std::string* last = nullptr;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(warning_mark, 0) == 0) {
      last = &outcome.warnings.emplace_back(line.substr(warning_mark.size()));
    } else if (line.rfind(error_mark, 0) == 0) {
      outcome.reason = line.substr(error_mark.size());
      last = &outcome.reason;
    } else if (last != nullptr) {
      *last += "\n" + line;
    }
  }
}

std::string end_text(const base::ProcessEnd& end, double most_seconds) {
  std::ostringstream text;
  if (!end.found)
    text << "the program was not found";
  else if (end.out_of_time)
    text << "it did not end in " << most_seconds << " s";
  else if (end.signal != 0)
    text << "the program was ended by signal " << end.signal;
  else if (end.status != 0)
    text << "exit status " << end.status << "; messages.txt of the case has what was said";
  return text.str();
}

/// Empty: it was stopped.
std::optional<Outcome> run_case(const Case& one, const std::string& folder, const Study& study,
                                const RunOptions& options) {
  if (auto known = known_outcome(folder, one, study, options)) return known;
  fs::remove_all(folder);
  fs::create_directories(folder);
  write(folder + "/case.xml", one.scene.xml(folder));
  base::ProcessOptions process;
  process.folder = folder;
  process.most_seconds = study.most_seconds;
  process.as_started = true;
  process.stop = options.stop;
  const base::ProcessEnd end = base::run_process(command_of(one, options), process);
  if (end.stopped) return std::nullopt;
  write(folder + "/messages.txt", end.output + end.errors);
  Outcome outcome;
  outcome.status = end.found ? end.status : -1;
  outcome.signal = end.signal;
  outcome.out_of_time = end.out_of_time;
  outcome.seconds = end.seconds;
  outcome.processor_seconds = end.processor_seconds;
  read_messages(end.errors, outcome);
  if (outcome.status == 0)
    outcome.reason.clear();
  else if (outcome.reason.empty())
    outcome.reason = end_text(end, study.most_seconds);
  keep(folder, one, outcome, options);
  return outcome;
}

}  // namespace

std::vector<Outcome> run_cases(const Study& study, const RunOptions& options) {
  std::vector<Outcome> outcomes(study.cases.size());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::mutex telling;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < study.cases.size() && !stopped;) {
      try {
        const Case& one = study.cases[i];
        if (options.stop && options.stop()) stopped = true;
        const auto outcome =
            stopped ? std::nullopt
                    : run_case(one, fs::absolute(options.folder + "/" + one.name).string(), study, options);
        if (!outcome) {
          stopped = true;
          return;
        }
        outcomes[i] = *outcome;
        const std::lock_guard<std::mutex> lock(telling);
        if (options.tell) options.tell(one, *outcome);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(telling);
        if (!failure) failure = std::current_exception();
        stopped = true;
      }
    }
  };
  std::vector<std::thread> workers;
  for (int w = 1; w < study.jobs; ++w) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
  if (stopped) throw base::SolveError("the study was stopped; cases that had ended are kept: the same command goes on");
  return outcomes;
}

}  // namespace toile::study
