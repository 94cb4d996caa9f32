#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

#include "toile/base/units.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/pressure_lines.hpp"

namespace toile::result {
namespace {

Column column(const std::string& name, const std::string& unit, const std::vector<LevelRow>& rows,
              const std::function<double(const LevelRow&)>& value) {
  Column result{{name, unit}, {}};
  std::transform(rows.begin(), rows.end(), std::back_inserter(result.values), value);
  return result;
}

void add_pressure(Table& table, const std::string& name, const std::vector<LevelRow>& rows, double LevelRow::*value) {
  table.columns.push_back(column(name, "kPa", rows, [=](const LevelRow& r) { return base::mpa_to_kpa(r.*value); }));
  table.columns.push_back(column(name, "mmHg", rows, [=](const LevelRow& r) { return base::mpa_to_mmhg(r.*value); }));
}

/// The rows of one section along the axis, with a gap in the line where it is not there.
std::vector<LevelRow> track(const std::vector<LevelRow>& curve, const std::string& section) {
  std::vector<LevelRow> rows;
  for (const LevelRow& row : curve) {
    if (rows.empty() || rows.back().height != row.height) {
      rows.emplace_back();
      rows.back().height = row.height;
      rows.back().pressure_mean = rows.back().laplace = std::numeric_limits<double>::quiet_NaN();
    }
    if (row.section == section) rows.back() = row;
  }
  return rows;
}

Series series(const std::string& title, const std::vector<LevelRow>& rows, double LevelRow::*value) {
  Series result;
  result.title = title;
  for (const LevelRow& row : rows) {
    result.x.push_back(row.height);
    result.y.push_back(base::mpa_to_kpa(row.*value));
  }
  return result;
}

void add_curves(Plot& plot, const std::vector<LevelRow>& curve, const std::string& title, double LevelRow::*value) {
  std::vector<std::string> sections;
  for (const LevelRow& row : curve)
    if (std::find(sections.begin(), sections.end(), row.section) == sections.end()) sections.push_back(row.section);
  for (const std::string& section : sections) {
    plot.series.push_back(series(title, track(curve, section), value));
    if (!section.empty()) plot.series.back().title = title + " (" + section + ")";
  }
}

}  // namespace

void write_pressure_csv(const std::string& path, const std::vector<LevelRow>& rows,
                        const std::vector<std::string>& error_parts) {
  Table table;
  const auto any = [&](std::string LevelRow::*text) {
    return std::any_of(rows.begin(), rows.end(), [=](const LevelRow& row) { return !(row.*text).empty(); });
  };
  const bool named = any(&LevelRow::name);
  if (named || any(&LevelRow::section)) {
    table.row_title = named ? "level" : "section";
    std::transform(rows.begin(), rows.end(), std::back_inserter(table.row_names),
                   [=](const LevelRow& row) { return named ? row.title() : row.section; });
  }
  table.columns.push_back(column("height", "mm", rows, [](const LevelRow& r) { return r.height; }));
  add_pressure(table, "mean pressure", rows, &LevelRow::pressure_mean);
  add_pressure(table, "smallest pressure", rows, &LevelRow::pressure_min);
  add_pressure(table, "largest pressure", rows, &LevelRow::pressure_max);
  add_pressure(table, "Laplace T/r", rows, &LevelRow::laplace);
  table.columns.push_back(column("girth", "mm", rows, [](const LevelRow& r) { return r.girth; }));
  table.columns.push_back(column("mean radius", "mm", rows, [](const LevelRow& r) { return r.radius; }));
  table.columns.push_back(column("hoop tension T", "N/mm", rows, [](const LevelRow& r) { return r.hoop_tension; }));
  table.columns.push_back(
      column("smallest principal stress", "MPa", rows, [](const LevelRow& r) { return r.smallest_stress; }));
  table.columns.push_back(column("at a support", "", rows, [](const LevelRow& r) { return r.at_support ? 1.0 : 0.0; }));
  table.columns.push_back(column("closed", "", rows, [](const LevelRow& r) { return r.closed ? 1.0 : 0.0; }));
  add_pressure(table, "error of the mean pressure", rows, &LevelRow::pressure_error);
  for (std::size_t part = 0; part < error_parts.size(); ++part)
    table.columns.push_back(column("its part by " + error_parts[part], "kPa", rows, [=](const LevelRow& r) {
      return r.reached() ? base::mpa_to_kpa(r.error_parts[part]) : std::numeric_limits<double>::quiet_NaN();
    }));
  table.text_title = "panels";
  std::transform(rows.begin(), rows.end(), std::back_inserter(table.texts),
                 [](const LevelRow& row) { return row.panels; });
  write_csv(path, table);
}

Plot pressure_plot(const std::string& title, const std::vector<LevelRow>& curve, const std::vector<LevelRow>& levels) {
  Plot plot;
  plot.title = title;
  plot.x_label = "height (mm)";
  plot.y_label = "contact pressure (kPa)";
  plot.second_axis = SecondAxis{"contact pressure (mmHg)", base::mmhg_per_kpa};
  plot.y_from_zero = true;
  plot.legend_above = std::any_of(curve.begin(), curve.end(), [](const LevelRow& row) { return !row.section.empty(); });
  std::vector<LevelRow> clear = curve;
  for (LevelRow& row : clear) {
    if (row.at_support) row.pressure_mean = std::numeric_limits<double>::quiet_NaN();
  }
  add_curves(plot, clear, "mean contact pressure", &LevelRow::pressure_mean);
  add_curves(plot, curve, "Laplace T/r", &LevelRow::laplace);
  std::vector<LevelRow> reached;
  std::copy_if(levels.begin(), levels.end(), std::back_inserter(reached),
               [](const LevelRow& row) { return row.reached(); });
  if (!reached.empty()) {
    Series markers = series("levels", reached, &LevelRow::pressure_mean);
    markers.line = false;
    markers.markers = true;
    std::transform(reached.begin(), reached.end(), std::back_inserter(markers.labels),
                   [](const LevelRow& row) { return row.title(); });
    plot.series.push_back(markers);
  }
  return plot;
}

}  // namespace toile::result
