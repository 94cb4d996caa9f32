// testers.csv: what the testers of a laboratory would read on this garment.
#include <algorithm>
#include <cstdio>

#include "table_output.hpp"
#include "toile/base/units.hpp"
#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

const std::string testers_name = "testers.csv";

/// In the last state of a run.
class Worn : public scene::WornGarment {
 public:
  explicit Worn(const Record& record) : record_(record) {}

  double force(const std::string& support) const override {
    const std::vector<solve::Support>& supports = record_.scene().problem().supports;
    const auto named = [&support](const solve::Support& one) { return one.name == support; };
    const auto at = std::find_if(supports.begin(), supports.end(), named) - supports.begin();
    return record_.last().balance.support[static_cast<size_t>(at)].norm();
  }

  scene::LimbSection section(const std::string& level) const override {
    scene::LimbSection limb;
    const result::LevelRow* row = run::section(record_.pressure(), level, limb.problem);
    if (row == nullptr) return limb;
    if (!row->reached())
      limb.problem = "no fabric reaches level \"" + level + "\"";
    else if (!row->closed)
      limb.problem = "the fabric at level \"" + level + "\" does not close round the body";
    limb.radius = row->radius;
    limb.laplace = row->laplace;
    limb.pressure_error = row->pressure_error;
    return limb;
  }

 private:
  const Record& record_;
};

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
    for (const auto& tester : record.scene().output().testers) {
      const scene::TesterReading r = tester->read(Worn(record));
      table.row_names.push_back(tester->name());
      const double mmhg[3] = {base::mpa_to_mmhg(r.reading), base::mpa_to_mmhg(r.error), base::mpa_to_mmhg(r.pressure)};
      table.columns[0].values.push_back(base::mpa_to_kpa(r.reading));
      for (size_t c = 0; c < 3; ++c) table.columns[c + 1].values.push_back(mmhg[c]);
      if (!r.problem.empty()) {
        log_.warn("tester \"" + tester->name() + "\" reads nothing: " + r.problem);
        continue;
      }
      char line[160];
      std::snprintf(line, sizeof line, "  %-24s %6.2f +- %-6.2g %9.2f\n", tester->name().c_str(), mmhg[0], mmhg[1],
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
