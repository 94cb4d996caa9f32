#include "torques.hpp"

#include <cctype>
#include <cmath>

namespace toile::app {

namespace {

/// A name that every reader of Exodus and HDF5 takes.
std::string plain(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

constexpr size_t first_column = 2;  // after step and load

}  // namespace

std::string torque_name(const solve::Support& support) {
  return "torque_" + plain(support.name);
}

std::vector<result::FieldName> torque_names(const solve::Problem& problem) {
  std::vector<result::FieldName> names;
  for (const solve::Support& support : problem.supports)
    if (support.turn) names.push_back({torque_name(support), "N mm"});
  return names;
}

std::vector<double> torques(const solve::Problem& problem, const solve::StepReport& report) {
  std::vector<double> values;
  for (size_t s = 0; s < problem.supports.size(); ++s)
    if (problem.supports[s].turn) values.push_back(report.balance.torque[s]);
  return values;
}

result::Table torque_table(const solve::Problem& problem, const std::vector<solve::StepReport>& reports) {
  result::Table table;
  table.columns = {{{"step", ""}, {}}, {{"load", ""}, {}}};
  for (const solve::StepReport& r : reports) {
    table.columns[0].values.push_back(r.step);
    table.columns[1].values.push_back(r.load);
  }
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
