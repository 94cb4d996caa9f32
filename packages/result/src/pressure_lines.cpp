#include "toile/result/pressure_lines.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

#include "cutter.hpp"
#include "layers.hpp"
#include "toile/base/units.hpp"

namespace toile::result {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string panels_of(const Section& section, const mesh::Mesh& mesh) {
  std::set<int> blocks;
  for (const Segment& segment : section.segments) blocks.insert(segment.block);
  std::string names;
  for (const int block : blocks)
    names += (names.empty() ? "" : ", ") + mesh.blocks[static_cast<std::size_t>(block)].name;
  return names;
}

LevelRow row_of(const Section& section, const GarmentFields& garment) {
  LevelRow row;
  row.panels = panels_of(section, *garment.mesh);
  row.closed = section.closed;
  row.mirrored = section.mirrored;
  const double length = section.girth();
  row.girth = row.mirrored ? 2.0 * length : length;
  row.pressure_min = std::numeric_limits<double>::infinity();
  row.pressure_max = -row.pressure_min;
  row.smallest_stress = row.pressure_min;
  double missed = 0.0;
  row.error_parts.assign(garment.pressure_errors.size(), 0.0);
  for (const Segment& segment : section.segments) {
    const double share = segment.length() / length;
    const auto element = static_cast<std::size_t>(segment.element);
    const auto [low, high] = std::minmax(segment.pressure[0], segment.pressure[1]);
    row.pressure_mean += 0.5 * share * (low + high);
    for (std::size_t part = 0; part < row.error_parts.size(); ++part)
      row.error_parts[part] += 0.5 * share * (segment.errors[0][part] + segment.errors[1][part]);
    missed += share * segment.missed;
    row.hoop_tension += share * segment.tension;
    row.pressure_min = std::min(row.pressure_min, low);
    row.pressure_max = std::max(row.pressure_max, high);
    row.at_support = row.at_support || (!garment.at_support.empty() && garment.at_support[element]);
    row.smallest_stress = std::min(row.smallest_stress, garment.smallest_stress[element]);
  }
  for (double& part : row.error_parts) part = std::abs(part);
  if (!row.error_parts.empty()) row.error_parts.front() += std::abs(missed);
  const double squares =
      std::inner_product(row.error_parts.begin(), row.error_parts.end(), row.error_parts.begin(), 0.0);
  row.pressure_error = row.error_parts.empty() ? none : std::sqrt(squares);
  row.radius = row.closed ? row.girth / (2.0 * M_PI) : none;
  row.laplace = row.hoop_tension / row.radius;
  return row;
}

/// The row of several layers, from those of each.
LevelRow sum_row(const std::vector<Section>& sections, const std::vector<std::size_t>& members,
                 const std::vector<LevelRow>& rows, const GarmentFields& garment) {
  std::vector<const Section*> of;
  for (const std::size_t k : members) of.push_back(&sections[k]);
  LevelRow row = row_of(sum_of(of), garment);
  row.panels.clear();
  row.laplace = 0.0;  // each layer has a radius of its own
  for (const std::size_t k : members) {
    row.section += (row.section.empty() ? "" : "+") + rows[k].section;
    row.panels += (row.panels.empty() ? "" : " + ") + rows[k].panels;
    row.laplace += rows[k].laplace;
    row.at_support = row.at_support || rows[k].at_support;
    row.smallest_stress = std::min(row.smallest_stress, rows[k].smallest_stress);
  }
  return row;
}

LevelRow not_reached() {
  LevelRow row;
  for (double LevelRow::*value : {&LevelRow::girth, &LevelRow::pressure_mean, &LevelRow::pressure_min,
                                  &LevelRow::pressure_max, &LevelRow::pressure_error, &LevelRow::radius,
                                  &LevelRow::hoop_tension, &LevelRow::laplace, &LevelRow::smallest_stress})
    row.*value = none;
  return row;
}

/// Every section at a height, then the sums of layers.
std::vector<LevelRow> rows_at(const Cutter& cutter, const Level& level) {
  const std::vector<Section> sections = cutter.cut(level.height);
  std::vector<LevelRow> rows;
  for (const Section& section : sections) {
    rows.push_back(row_of(section, cutter.garment()));
    if (sections.size() > 1) rows.back().section = std::to_string(rows.size());
  }
  for (const std::vector<std::size_t>& members : layers(sections))
    rows.push_back(sum_row(sections, members, rows, cutter.garment()));
  if (rows.empty()) rows.push_back(not_reached());
  for (LevelRow& row : rows) {
    row.name = level.name;
    row.height = level.height;
  }
  return rows;
}

}  // namespace

std::vector<LevelRow> levels(const GarmentFields& garment, const Axis& axis, const std::vector<Level>& levels) {
  const Cutter cutter(garment, axis);
  std::vector<LevelRow> all;
  for (const Level& level : levels) {
    const std::vector<LevelRow> rows = rows_at(cutter, level);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

std::vector<LevelRow> pressure_curve(const GarmentFields& garment, const Axis& axis, int stations) {
  assert(stations >= 2);
  const Cutter cutter(garment, axis);
  const double length = cutter.highest() - cutter.lowest();
  std::vector<LevelRow> all;
  for (int i = 0; i < stations; ++i) {
    std::vector<LevelRow> rows = rows_at(cutter, {"", cutter.lowest() + length * i / (stations - 1)});
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(all), [](const LevelRow& row) { return row.closed; });
  }
  return all;
}

std::vector<std::string> level_warnings(const GarmentFields& garment, const Axis& axis,
                                        const std::vector<LevelRow>& rows) {
  const Cutter cutter(garment, axis);
  std::vector<std::string> warnings;
  for (const LevelRow& row : rows) {
    const auto seam = row.reached() ? cutter.seam_at(row.height) : std::nullopt;
    if (!seam || std::abs(seam->pressure[1] - seam->pressure[0]) <= row.pressure_error) continue;
    std::ostringstream text;
    text.precision(3);
    const auto name = [&](int k) {
      return "\"" + garment.mesh->blocks[static_cast<std::size_t>(seam->block[k])].name + "\"";
    };
    text << "level \"" << row.title() << "\" runs along the seam of panels " << name(0) << " and " << name(1)
         << ", which press with " << base::mpa_to_kpa(seam->pressure[0]) << " and "
         << base::mpa_to_kpa(seam->pressure[1]) << " kPa there: its values mix both. Put it beside the seam";
    warnings.push_back(text.str());
  }
  for (const LevelRow& row : rows) {
    if (row.closed) continue;
    std::ostringstream text;
    text.precision(4);
    text << "level \"" << row.title() << "\" at the height " << row.height << " mm ";
    if (row.reached())
      text << "cuts " << row.girth << " mm of fabric (" << row.panels
           << ") that does not close round the body: it has no radius, and no value by Laplace's law";
    else
      text << "does not meet the garment, which lies between " << cutter.lowest() << " and " << cutter.highest()
           << " mm: it has no values";
    warnings.push_back(text.str());
  }
  return warnings;
}

}  // namespace toile::result
