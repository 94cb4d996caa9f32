#include "toile/report/report.hpp"

#include <algorithm>
#include <filesystem>

#include "content.hpp"
#include "pages.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "toile/result/replace_file.hpp"
#include "toile/result/results_file.hpp"

namespace toile::report {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_table_bytes = 2'000'000;
constexpr std::size_t most_record_bytes = 20'000'000;
const std::string record_name = "run.json", record_format = "toile run 1";

/// The record of the run, or null, and what is to be said of it.
Json record_of(const fs::path& folder, int steps, std::vector<std::string>& problems) {
  const fs::path path = folder / record_name;
  if (!fs::exists(path)) {
    problems.push_back(
        "There is no " + record_name +
        " beside the results: warnings of the run, its checks, its fabrics and its scene are not known.");
    return {};
  }
  const std::string text = base::read_file(path.string(), "the record of a run", most_record_bytes);
  Json record = Json::parse(text, nullptr, false);
  if (!record.is_object() || record.value("format", Json()) != record_format)
    throw base::InputError(path.string() + ": it is not the record of a run in the format \"" + record_format + "\"");
  const Json end = record.value("end", Json()), recorded = record.value("steps", Json());
  if (end == "not yet") {
    problems.emplace_back("The run had not ended when this page was made: warnings and checks are not all there.");
  } else if (recorded != steps) {
    problems.push_back("The results hold " + std::to_string(steps) + " steps and " + record_name + " tells of " +
                       recorded.dump() + ": its warnings and checks may be of another state.");
  }
  return record;
}

/// Every table beside the results, by name.
Json tables_of(const fs::path& folder, std::vector<std::string>& problems) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".csv") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  Json tables = Json::array();
  for (const fs::path& path : paths) {
    if (fs::is_regular_file(path) && fs::file_size(path) > most_table_bytes) {
      problems.push_back("The table " + path.filename().string() + " is left out: it is larger than " +
                         std::to_string(most_table_bytes / 1'000'000) + " MB.");
      continue;
    }
    tables.push_back(
        {{"name", path.filename().string()}, {"text", base::read_file(path.string(), "a table", most_table_bytes)}});
  }
  return tables;
}

/// As the content of a script element: nothing in it ends the element.
std::string script_text(const Json& content) {
  std::string text = content.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

/// The page with each comment <!--NAME--> replaced; each is there once.
std::string filled(std::string_view page, const std::vector<std::pair<std::string, std::string_view>>& parts) {
  std::string text(page);
  for (const auto& [name, part] : parts) {
    const std::string mark = "<!--" + name + "-->";
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) throw base::Error(base::ExitCode::internal_error, "the page has no place " + mark);
    text.replace(at, mark.size(), part);
  }
  return text;
}

std::string page_of(const Json& content) {
  const std::string data = script_text(content);
  return filled(page_html,
                {{"style", page_css}, {"libraries", page_libraries}, {"data", data}, {"scripts", page_scripts}});
}

}  // namespace

bool available() {
  return true;
}

Written write_report(const std::string& results_path, const std::string& page_path, const Options& options) {
  const std::string failure = "cannot write the report '" + page_path + "': ";
  const result::Results results = result::read_results(results_path);
  result::check_replaceable(page_path, failure);
  const fs::path folder = fs::path(results_path).has_parent_path() ? fs::path(results_path).parent_path() : ".";
  std::vector<std::string> problems;
  Json beside;
  beside["results"] = fs::path(results_path).filename().string();
  beside["run"] = record_of(folder, results.steps, problems);
  beside["tables"] = tables_of(folder, problems);

  Written written;
  std::vector<std::string> fields = shown_fields(results);
  const auto page = [&] {
    Json content = content_of(results, fields);
    content.update(beside);
    content["problems"] = problems;
    content["leftOut"] = written.left_out;
    return page_of(content);
  };
  std::string text = page();
  while (text.size() > options.most_bytes && fields.size() > 1) {
    // A quarter at once: what is made again is large.
    const std::size_t kept = fields.size() - std::max<std::size_t>(1, fields.size() / 4);
    written.left_out.insert(written.left_out.begin(), fields.begin() + static_cast<std::ptrdiff_t>(kept), fields.end());
    fields.resize(kept);
    text = page();
  }
  written.bytes = text.size();
  result::replace_file(page_path, text, failure);
  return written;
}

}  // namespace toile::report
