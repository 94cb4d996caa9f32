#include "material_map.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"

namespace toile::app {
namespace {

using criteria::MapPoint;

template <class Value>
result::Column column(const std::vector<MapPoint>& map, const result::FieldName& name, Value value) {
  result::Column result{name, {}};
  for (const MapPoint& p : map) result.values.push_back(value(p));
  return result;
}

result::Table table_of(const std::vector<MapPoint>& map) {
  result::Table table;
  const auto add = [&](const char* name, const char* unit, auto value) {
    table.columns.push_back(column(map, {name, unit}, value));
  };
  add("wale stretch", "", [](const MapPoint& p) { return p.wale; });
  add("course stretch", "", [](const MapPoint& p) { return p.course; });
  add("shear", "", [](const MapPoint& p) { return p.shear; });
  add("status", "", [](const MapPoint& p) { return static_cast<double>(p.state.status); });
  add("tensile", "", [](const MapPoint& p) { return p.tensile ? 1.0 : 0.0; });
  add("elliptic", "", [](const MapPoint& p) { return p.elliptic ? 1.0 : 0.0; });
  add("convex in stretches", "", [](const MapPoint& p) { return p.convex ? 1.0 : 0.0; });
  add("smallest acoustic eigenvalue", "MPa", [](const MapPoint& p) { return p.ellipticity; });
  add("its direction from the wale", "degrees", [](const MapPoint& p) { return p.direction; });
  add("smaller eigenvalue of the stretch Hessian", "MPa", [](const MapPoint& p) { return p.convexity; });
  add("condition of D", "", [](const MapPoint& p) { return p.condition; });
  add("W", "MPa", [](const MapPoint& p) { return p.state.W; });
  add("S11", "MPa", [](const MapPoint& p) { return p.state.S[0]; });
  add("S22", "MPa", [](const MapPoint& p) { return p.state.S[1]; });
  add("S12", "MPa", [](const MapPoint& p) { return p.state.S[2]; });
  return table;
}

constexpr const char* classes[] = {"kept, in tension",
                                   "kept, compressed",
                                   "convexity in stretches lost",
                                   "ellipticity lost, compressed",
                                   "not admissible",
                                   "convexity in stretches lost in tension",
                                   "ellipticity lost in tension"};

/// Index in `classes`.
int class_of(const MapPoint& p) {
  if (!p.state.admissible()) return 4;
  if (!p.elliptic) return p.tensile ? 6 : 3;
  if (!p.convex) return p.tensile ? 5 : 2;
  return p.tensile ? 0 : 1;
}

/// The points of one plane of the map, a series for each class that it holds.
template <class X, class Y, class Picks>
result::Plot plane(const std::vector<MapPoint>& map, X x, Y y, Picks picks) {
  result::Plot plot;
  plot.legend_above = true;
  for (int k = 0; k < static_cast<int>(std::size(classes)); ++k) {
    result::Series series;
    series.title = classes[k];
    series.line = false;
    series.markers = true;
    series.colour = k + 1;
    for (const MapPoint& p : map)
      if (picks(p) && class_of(p) == k) {
        series.x.push_back(x(p));
        series.y.push_back(y(p));
      }
    if (!series.x.empty()) plot.series.push_back(series);
  }
  return plot;
}

}  // namespace

std::string file_stem(const criteria::Report& report) {
  std::string stem;
  for (const char letter : report.fabric.name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    if (plain || (!stem.empty() && stem.back() != '-')) stem += plain ? letter : '-';
  }
  while (!stem.empty() && stem.back() == '-') stem.pop_back();
  return stem.empty() ? "fabric" : stem;
}

std::string write_map(const criteria::Report& report, const std::string& folder) {
  const std::vector<MapPoint>& map = report.map;
  const std::string stem = file_stem(report);
  result::write_csv(folder + "/" + stem + ".csv", table_of(map));
  const auto nearest = [&](auto value, double wanted) {
    double best = value(map.front());
    for (const MapPoint& p : map)
      if (std::abs(value(p) - wanted) < std::abs(best - wanted)) best = value(p);
    return best;
  };
  const auto wale = [](const MapPoint& p) { return p.wale; };
  const auto course = [](const MapPoint& p) { return p.course; };
  const auto shear = [](const MapPoint& p) { return p.shear; };
  const double no_shear = nearest(shear, 0.0), no_wale = nearest(wale, 1.0);
  result::Plot stretches = plane(map, wale, course, [&](const MapPoint& p) { return p.shear == no_shear; });
  stretches.title = report.fabric.name + ": shear " + criteria::figure(no_shear);
  stretches.x_label = "wale stretch";
  stretches.y_label = "course stretch";
  result::Plot sheared = plane(map, shear, course, [&](const MapPoint& p) { return p.wale == no_wale; });
  sheared.title = report.fabric.name + ": wale stretch " + criteria::figure(no_wale);
  sheared.x_label = "shear";
  sheared.y_label = "course stretch";
  std::string warnings;
  for (const auto& [name, plot] : {std::pair(stem + "-stretches", stretches), std::pair(stem + "-shear", sheared)})
    if (const auto warning = result::write_plot(folder, name, plot)) warnings += *warning + '\n';
  return warnings;
}

}  // namespace toile::app
