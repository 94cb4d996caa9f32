#include "report.hpp"

#include <Tpetra_Core.hpp>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/report/report.hpp"

namespace toile::app {

const char* const report_name = "report.html";

namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::string results;      ///< a folder, or an Exodus file
  std::string output = "";  ///< the page; empty: report.html beside the Exodus file
};

std::string text_of(const std::string& page, const report::Written& written) {
  std::ostringstream text;
  text << "Report in " << page << " (" << std::fixed << std::setprecision(1) << static_cast<double>(written.bytes) / 1e6
       << " MB)";
  if (written.left_out.empty()) return text.str();
  text << "; left out for its size:";
  for (const std::string& field : written.left_out) text << " " << field;
  return text.str();
}

int report(const ReportArguments& arguments) {
  const bool is_folder = fs::is_directory(arguments.results);
  const fs::path file = is_folder ? fs::path(arguments.results) / "results.exo" : fs::path(arguments.results);
  const fs::path page = arguments.output.empty() ? file.parent_path() / report_name : fs::path(arguments.output);
  const std::string text = write_report_page(file.string(), page.string());
  if (!text.empty()) std::cout << text << "\n";
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

std::string write_report_page(const std::string& results, const std::string& page) {
  std::string text;
  if (Tpetra::getDefaultComm()->getRank() == 0) text = text_of(page, report::write_report(results, page));
  return text;
}

void add_report(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = program.add_subcommand("report", "Write one HTML page of a run's results, for any browser");
  command->add_option("results", arguments->results, "Folder of the results, or its results.exo or start.exo")
      ->required();
  command->add_option("--output", arguments->output, "The page (default: report.html beside the results)")
      ->type_name("FILE");
  command->callback([arguments, &chosen] { chosen = [arguments] { return app::report(*arguments); }; });
}

}  // namespace toile::app
