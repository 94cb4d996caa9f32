// What a run is for, as it ends on the terminal, and the files that it has written.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>

#include "output.hpp"
#include "toile/base/units.hpp"
#include "toile/base/with_error.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::run {

namespace {

/// The largest pressure of the garment where no support ends: there a line force would pass for a pressure.
struct LargestPressure {
  double pressure = 0.0;  ///< MPa
  double error = 0.0;     ///< MPa
  std::string panel;
  solve::Vec3 place = solve::Vec3::Zero();  ///< mm
};

std::string number(const char* format, double value) {
  if (!std::isfinite(value)) return "";
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string in_mmhg(double pressure, double error) {
  if (!(error > 0.0)) return number("%.3g", base::mpa_to_mmhg(pressure));
  return base::with_error(base::mpa_to_mmhg(pressure), base::mpa_to_mmhg(error));
}

/// The parts of an error (MPa) in kPa, the largest first, as far as they count: "mesh 0.03, body 0.02".
std::string parts_of_error(const std::vector<double>& parts) {
  constexpr double counts = 0.1;  // of the largest: 0.5 % of the error
  std::vector<std::pair<double, std::string>> sorted;
  const std::vector<std::string> names = error_names();
  for (size_t p = 0; p < parts.size(); ++p) sorted.emplace_back(base::mpa_to_kpa(parts[p]), names[p]);
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [part, name] : sorted)
    if (part > 0.0 && part >= counts * sorted.front().first)
      text += (text.empty() ? "" : ", ") + name + " " + number("%.2g", part);
  return text;
}

/// Texts in columns: the first to the left, the others to the right.
std::string columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<size_t> width(rows.front().size(), 0);
  for (const auto& row : rows)
    for (size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    std::string line = "  " + row[0] + std::string(width[0] - row[0].size(), ' ');
    for (size_t c = 1; c < row.size(); ++c) line += std::string(3 + width[c] - row[c].size(), ' ') + row[c];
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

/// What a reader must know of a row.
std::string remark(const result::LevelRow& row) {
  if (!row.reached()) return "not reached";
  std::string text = row.mirrored ? "half, with its mirror image" : row.closed ? "" : "open";
  if (row.at_support) text += std::string(text.empty() ? "" : ", ") + "at a support";
  return text;
}

std::string level_table(const std::vector<result::LevelRow>& levels) {
  std::vector<std::vector<std::string>> rows = {
      {"level", "mmHg", "kPa", "error by, kPa", "of the first", "girth mm", "Laplace mmHg", "", ""}};
  const auto first =
      std::find_if(levels.begin(), levels.end(), [](const result::LevelRow& row) { return row.reached(); });
  const bool several = std::any_of(levels.begin(), levels.end(), [](const auto& row) { return !row.section.empty(); });
  for (const result::LevelRow& row : levels) {
    rows.push_back({row.title(), in_mmhg(row.pressure_mean, row.pressure_error),
                    number("%.3g", base::mpa_to_kpa(row.pressure_mean)), parts_of_error(row.error_parts), "",
                    number("%.1f", row.girth), number("%.3g", base::mpa_to_mmhg(row.laplace)),
                    several ? row.panels : "", remark(row)});
    if (!row.reached()) rows.back()[1].clear();
    if (row.reached() && first->pressure_mean > 0.0)
      rows.back()[4] = number("%.0f %%", 100.0 * row.pressure_mean / first->pressure_mean);
  }
  return "Pressure at the levels, mean round the section +- its error\n" + columns(rows);
}

std::string point_table(const scene::Scene& scene, const solve::Fields& fields,
                        const std::vector<PointPressure>& on_body) {
  std::vector<std::vector<std::string>> rows = {{"point", "mmHg", "kPa", "error by, kPa", "gap mm"}};
  const auto add = [&](const auto& points, const std::vector<PointPressure>& pressures) {
    for (size_t p = 0; p < points.size(); ++p) {
      const PointPressure& at = pressures[p];
      rows.push_back({points[p].title, in_mmhg(at.pressure, at.error), number("%.3g", base::mpa_to_kpa(at.pressure)),
                      parts_of_error(at.error_parts), at.gap ? number("%.2f", *at.gap) : "no fabric"});
    }
  };
  const scene::Output& output = scene.output();
  add(output.points, point_pressures(scene, output.points, fields));
  add(output.body_points, on_body);
  return "Pressure at the points +- its error\n" + columns(rows);
}

/// Value below which a share of the panel's area lies.
double quantile(const mesh::Mesh& mesh, const mesh::Block& block, const std::vector<double>& values, double share) {
  std::vector<std::pair<double, double>> sorted;  // value, area
  double total = 0.0;
  for (size_t e = 0; e < values.size(); ++e) {
    sorted.emplace_back(values[e], mesh::pattern_area(mesh, block, e));
    total += sorted.back().second;
  }
  std::sort(sorted.begin(), sorted.end());
  double sum = 0.0;
  for (const auto& [value, area] : sorted) {
    sum += area;
    if (sum >= share * total) return value;
  }
  return sorted.back().first;
}

std::string stretch_table(const scene::Scene& scene, const solve::Fields& fields) {
  const mesh::Mesh& mesh = scene.garment().mesh;
  std::vector<std::vector<std::string>> rows = {{"panel", "wale", "course"}};
  for (size_t b = 0; b < mesh.blocks.size(); ++b) {
    rows.push_back({mesh.blocks[b].name});
    for (const char* field : {"stretch_wale", "stretch_course"}) {
      const std::vector<double>& values = solve::named(fields.element[b], field).values;
      rows.back().push_back(number("%.3f", quantile(mesh, mesh.blocks[b], values, 0.05)) + " to " +
                            number("%.3f", quantile(mesh, mesh.blocks[b], values, 0.95)));
    }
  }
  return "Stretch, 5 to 95 % of each panel's area\n" + columns(rows);
}

std::string place_text(const solve::Vec3& x) {
  return "(" + number("%.1f", x[0]) + ", " + number("%.1f", x[1]) + ", " + number("%.1f", x[2]) + ") mm";
}

/// Nothing if the garment presses nowhere.
std::optional<LargestPressure> largest_pressure(const scene::Scene& scene, const solve::Fields& fields) {
  const std::vector<bool> at_support = elements_at_supports(scene);
  const mesh::Mesh& mesh = scene.garment().mesh;
  std::vector<bool> told(fields.pressure.size(), true);
  size_t element = 0;
  for (const mesh::Block& block : mesh.blocks)
    for (size_t i = 0; i < block.connectivity.size(); ++i) {
      if (at_support[element]) told[block.connectivity[i]] = false;
      if ((i + 1) % static_cast<size_t>(block.nodes_per_element) == 0) ++element;
    }
  std::optional<LargestPressure> largest;
  for (const mesh::Block& block : mesh.blocks)
    for (const int n : block.connectivity)
      if (told[n] && fields.pressure[n] > (largest ? largest->pressure : 0.0))
        largest = {fields.pressure[n], fields.pressure_error[n], mesh.panel_of(block).name, fields.position[n]};
  return largest;
}

/// The tables of levels and of points, the stretches of each panel, the largest pressure.
std::string findings(const scene::Scene& scene, const solve::Fields& fields, const PressureReport& pressure,
                     const std::vector<PointPressure>& on_body) {
  std::string text;
  if (!pressure.levels.empty()) text += level_table(pressure.levels);
  if (scene.surface() != nullptr && !(scene.output().points.empty() && on_body.empty()))
    text += point_table(scene, fields, on_body);
  text += stretch_table(scene, fields);
  if (const auto largest = largest_pressure(scene, fields))
    text += "Largest pressure away from supports: " + in_mmhg(largest->pressure, largest->error) + " mmHg (" +
            number("%.3g", base::mpa_to_kpa(largest->pressure)) + " kPa) in panel \"" + largest->panel + "\" at " +
            place_text(largest->place) + "\n";
  return text;
}

/// Warns of a pressure that no garment has, with the likely cause.
std::optional<std::string> implausible_pressure(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double most = 200.0;  // mmHg
  const auto largest = largest_pressure(scene, fields);
  if (!largest || base::mpa_to_mmhg(largest->pressure) <= most) return std::nullopt;
  const double mmhg = base::mpa_to_mmhg(largest->pressure);
  std::ostringstream text;
  text << "the pressure reaches " << number("%.4g", mmhg) << " mmHg in panel \"" << largest->panel << "\" at "
       << place_text(largest->place) << ", and no garment presses with more than " << most << " mmHg. ";
  if (mmhg / 1000.0 < most)
    text << "Is a modulus given in kPa? Moduli and stresses are in MPa, 1000 times less (it would be "
         << number("%.3g", mmhg / 1000.0) << " mmHg)";
  else
    text << "Look at the stretches above, at the moduli (MPa) and at the thickness (mm)";
  return text.str();
}

std::string files_text(const Folder& folder) {
  std::string text = "Files in " + folder.path() + ":";
  for (const std::string& name : folder.written()) text += " " + name;
  return text;
}

class Findings : public Observer {
 public:
  explicit Findings(const OutputContext& context) : folder_(context.folder), log_(context.log) {}

  void end(const Record& record) override {
    const scene::Scene& scene = record.scene();
    const std::string found =
        findings(scene, record.fields(), record.pressure(),
                 body_pressures(scene, scene.output().body_points, record.fields(), record.last()));
    log_.info(found + (folder_ != nullptr ? files_text(*folder_) : std::string()));
    if (const auto warning = implausible_pressure(scene, record.fields())) log_.warn(*warning);
  }

 private:
  std::shared_ptr<Folder> folder_;
  base::Log& log_;
};

}  // namespace

Output findings_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Findings>(context);
          }};
}

}  // namespace toile::run
