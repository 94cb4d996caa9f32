// compression-class.csv: the pressures at the levels beside that of the level whose compression class is checked.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "table_output.hpp"
#include "toile/base/units.hpp"
#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

const std::string file_name = "compression-class.csv";

std::vector<scene::Check> class_checks(const scene::Scene& scene) {
  std::vector<scene::Check> found;
  std::copy_if(scene.checks().begin(), scene.checks().end(), std::back_inserter(found),
               [](const scene::Check& check) { return check.compression.has_value(); });
  return found;
}

/// "RAL-GZ 387: II" of a level whose class is checked, by each of its standards.
std::string classes_of(const result::LevelRow& row, const PressureReport& pressure,
                       const std::vector<scene::Check>& checks) {
  std::string text, problem;
  for (const scene::Check& check : checks) {
    if (section(pressure, check.sections.front(), problem) != &row) continue;
    const std::string& standard = check.compression->standard;
    const std::string one = standard + ": " + scene::class_text(standard, base::mpa_to_mmhg(row.pressure_mean));
    if (text.find(one) == std::string::npos) text += (text.empty() ? "" : "; ") + one;
  }
  return text;
}

class CompressionClassTable : public Observer {
 public:
  explicit CompressionClassTable(const OutputContext& context) : folder_(context.folder), log_(context.log) {}

  void end(const Record& record) override {
    const PressureReport& pressure = record.pressure();
    const std::vector<scene::Check> checks = class_checks(record.scene());
    const std::string& reference = checks.front().sections.front();
    std::string problem;
    const result::LevelRow* whole = section(pressure, reference, problem);
    result::Table table{"level",
                        {},
                        {{{"mean pressure", "mmHg"}, {}},
                         {{"its error", "mmHg"}, {}},
                         {{"part of that at level " + reference, "%"}, {}}},
                        "compression class"};
    std::string text = "Compression class\n  level    mmHg +- error   % of " + reference + "\n";
    for (const result::LevelRow& row : pressure.levels) {
      constexpr double none = std::numeric_limits<double>::quiet_NaN();
      const double value = base::mpa_to_mmhg(row.pressure_mean), error = base::mpa_to_mmhg(row.pressure_error),
                   part = whole == nullptr || !(whole->pressure_mean > 0.0)
                              ? none
                              : 100.0 * row.pressure_mean / whole->pressure_mean;
      table.row_names.push_back(row.title());
      table.columns[0].values.push_back(value);
      table.columns[1].values.push_back(error);
      table.columns[2].values.push_back(part);
      table.texts.push_back(classes_of(row, pressure, checks));
      text += line(row, value, error, part, table.texts.back());
    }
    log_.info(text);
    if (folder_ == nullptr) return;
    result::write_csv(folder_->file(file_name), table);
    folder_->add(file_name);
  }

 private:
  static std::string line(const result::LevelRow& row, double value, double error, double part,
                          const std::string& classes) {
    if (!row.reached()) return "  " + row.title() + "  not reached\n";
    char numbers[96], share[32] = "-";
    if (std::isfinite(part)) std::snprintf(share, sizeof share, "%.1f", part);
    std::snprintf(numbers, sizeof numbers, " %8.2f +- %-6.2g %8s  ", value, error, share);
    std::string title = row.title();
    title.resize(std::max<size_t>(title.size(), 6), ' ');
    return "  " + title + numbers + classes + "\n";
  }

  std::shared_ptr<Folder> folder_;
  base::Log& log_;
};

}  // namespace

Output compression_class_output() {
  return {{file_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (class_checks(context.scene).empty()) return nullptr;
            return std::make_unique<CompressionClassTable>(context);
          }};
}

}  // namespace toile::run
