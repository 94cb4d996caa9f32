// testers.csv: what the testers of a laboratory would read on this garment.
#include <algorithm>
#include <cstdio>
#include <limits>

#include "table_output.hpp"
#include "toile/base/units.hpp"
#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

const std::string testers_name = "testers.csv";

/// MPa.
struct Reading {
  std::string problem;    ///< why there is no reading; empty: there is one
  double pressure = 0.0;  ///< by Laplace's law, of the limb without a tester
  double error = 0.0;     ///< of the reading, by what is known of the pressure's
  double reading = 0.0;
};

Reading read(const scene::FlatJaws& jaws, const Record& record) {
  const std::vector<solve::Support>& supports = record.scene().problem().supports;
  const auto named = [&jaws](const solve::Support& support) { return support.name == jaws.support; };
  const auto at = std::find_if(supports.begin(), supports.end(), named) - supports.begin();
  const double pressure = jaws.pressure(record.last().balance.support[static_cast<size_t>(at)].norm());
  return {"", pressure, 0.0, pressure};
}

Reading read(const scene::RigidSensor& sensor, const Record& record) {
  std::string problem;
  const result::LevelRow* row = section(record.pressure(), sensor.level, problem);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (row != nullptr && !row->reached()) problem = "no fabric reaches level \"" + sensor.level + "\"";
  if (problem.empty() && !row->closed)
    problem = "the fabric at level \"" + sensor.level + "\" does not close round the body";
  if (problem.empty() && sensor.width > 2.0 * row->radius) problem = "the sensor is wider than the limb";
  if (!problem.empty()) return {problem, none, none, none};
  const double ratio = sensor.ratio(row->radius);
  return {"", row->laplace, ratio * row->pressure_error, ratio * row->laplace};
}

class Testers : public Observer {
 public:
  explicit Testers(const OutputContext& context) : folder_(context.folder), log_(context.log) {}

  void end(const Record& record) override {
    result::Table table{"tester",
                        {},
                        {{{"reading", "kPa"}, {}},
                         {{"reading", "mmHg"}, {}},
                         {{"its error", "mmHg"}, {}},
                         {{"pressure by Laplace's law", "mmHg"}, {}}}};
    std::string text = "What testers read\n  tester                    mmHg +- error   by Laplace\n";
    for (const scene::Tester& tester : record.scene().output().testers) {
      const Reading r = std::visit([&record](const auto& kind) { return read(kind, record); }, tester.kind);
      table.row_names.push_back(tester.name);
      const double mmhg[3] = {base::mpa_to_mmhg(r.reading), base::mpa_to_mmhg(r.error), base::mpa_to_mmhg(r.pressure)};
      table.columns[0].values.push_back(base::mpa_to_kpa(r.reading));
      for (size_t c = 0; c < 3; ++c) table.columns[c + 1].values.push_back(mmhg[c]);
      if (!r.problem.empty()) {
        log_.warn("tester \"" + tester.name + "\" reads nothing: " + r.problem);
        continue;
      }
      char line[160];
      std::snprintf(line, sizeof line, "  %-24s %6.2f +- %-6.2g %9.2f\n", tester.name.c_str(), mmhg[0], mmhg[1],
                    mmhg[2]);
      text += line;
    }
    log_.info(text);
    if (folder_ == nullptr) return;
    result::write_csv(folder_->file(testers_name), table);
    folder_->add(testers_name);
  }

 private:
  std::shared_ptr<Folder> folder_;
  base::Log& log_;
};

}  // namespace

Output testers_output() {
  return {{testers_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.scene.output().testers.empty()) return nullptr;
            return std::make_unique<Testers>(context);
          }};
}

}  // namespace toile::run
