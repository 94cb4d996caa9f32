// torques.*: angle and torque of each support that turns.
#include <algorithm>
#include <cmath>

#include "step_table.hpp"
#include "table_output.hpp"

namespace toile::run {

namespace {

const std::string torques_name = "torques";

class Torques : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    result::Table table = step_table(record.reports());
    result::Plot plot;
    plot.title = record.scene().title();
    plot.x_label = "angle (deg)";
    plot.y_label = "torque (N mm)";
    const std::vector<solve::Support>& supports = record.scene().problem().supports;
    for (size_t s = 0; s < supports.size(); ++s) {
      if (!supports[s].turn) continue;
      result::Column angle{{supports[s].name + ": angle", "deg"}, {}};
      result::Column torque{{supports[s].name + ": torque", "N mm"}, {}};
      for (const solve::StepReport& r : record.reports()) {
        angle.values.push_back(supports[s].path.share(r.load) * supports[s].turn->angle * 180.0 / M_PI);
        torque.values.push_back(r.balance.torque[s]);
      }
      result::Series series;
      series.title = torque.name.name;
      series.x = angle.values;
      series.y = torque.values;
      plot.series.push_back(series);
      table.columns.push_back(angle);
      table.columns.push_back(torque);
    }
    TableOutput::write(torques_name, table);
    draw(torques_name, plot);
  }
};

}  // namespace

Output torques_output() {
  return {plot_files(torques_name), [](const OutputContext& context) -> std::unique_ptr<Observer> {
            const std::vector<solve::Support>& supports = context.scene.problem().supports;
            const bool any =
                std::any_of(supports.begin(), supports.end(), [](const auto& s) { return s.turn.has_value(); });
            if (context.folder == nullptr || !any) return nullptr;
            return std::make_unique<Torques>(context);
          }};
}

}  // namespace toile::run
