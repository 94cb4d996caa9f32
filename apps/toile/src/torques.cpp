#include "torques.hpp"

#include <algorithm>
#include <cmath>

#include "tables.hpp"

namespace toile::app {

namespace {

constexpr size_t first_column = 2;  // after step and load

}  // namespace

bool any_turns(const solve::Problem& problem) {
  return std::any_of(problem.supports.begin(), problem.supports.end(),
                     [](const solve::Support& support) { return support.turn.has_value(); });
}

result::Table torque_table(const solve::Problem& problem, const std::vector<solve::StepReport>& reports) {
  result::Table table = step_table(reports);
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const solve::Support& support = problem.supports[s];
    if (!support.turn) continue;
    result::Column angle{{support.name + ": angle", "deg"}, {}}, torque{{support.name + ": torque", "N mm"}, {}};
    for (const solve::StepReport& r : reports) {
      angle.values.push_back(support.path.share(r.load) * support.turn->angle * 180.0 / M_PI);
      torque.values.push_back(r.balance.torque[s]);
    }
    table.columns.push_back(angle);
    table.columns.push_back(torque);
  }
  return table;
}

result::Plot torque_plot(const std::string& title, const result::Table& table) {
  result::Plot plot;
  plot.title = title;
  plot.x_label = "angle (deg)";
  plot.y_label = "torque (N mm)";
  for (size_t c = first_column; c + 1 < table.columns.size(); c += 2) {
    result::Series series;
    series.title = table.columns[c + 1].name.name;
    series.x = table.columns[c].values;
    series.y = table.columns[c + 1].values;
    plot.series.push_back(series);
  }
  return plot;
}

}  // namespace toile::app
