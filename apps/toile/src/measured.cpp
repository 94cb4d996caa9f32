#include "measured.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <tuple>
#include <utility>

#include "toile/base/csv_file.hpp"
#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"
#include "toile/base/units.hpp"
#include "toile/body/triangle_tree.hpp"
#include "toile/result/results_file.hpp"

namespace toile::app {
namespace {

using base::CsvColumn;
using base::CsvFile;

/// A table of a run with the titles of what is read from it.
struct ResultFile {
  std::string file, name, pressure, error;
};
const std::vector<ResultFile> result_files = {
    {"pressure-levels.csv", "level", "mean pressure", "error of the mean pressure"},
    {"pressure-points.csv", "point", "pressure", "its error"}};

/// The column of that name, of the first unit if a file has it in several. Throws InputError if there is none.
const CsvColumn& column(const CsvFile& file, const std::string& name) {
  base::Texts names;
  for (const CsvColumn& column : file.columns) {
    if (column.name == name) return column;
    names.push_back(column.name);
  }
  throw base::InputError(file.path + ": there is no column \"" + name + "\"" + base::hint(name, names));
}

bool has_column(const CsvFile& file, const std::string& name) {
  return std::any_of(file.columns.begin(), file.columns.end(), [&](const CsvColumn& c) { return c.name == name; });
}

[[noreturn]] void refuse_unit(const CsvFile& file, const CsvColumn& column, const std::string& allowed) {
  throw base::InputError(file.path + ": column \"" + column.name + "\" has the unit \"" + column.unit +
                         "\"; allowed in its title: " + allowed);
}

std::vector<double> kilopascals(const CsvFile& file, const CsvColumn& column) {
  if (column.unit != "kPa" && column.unit != "mmHg") refuse_unit(file, column, "[kPa], [mmHg]");
  std::vector<double> values = base::numbers(file, column);
  if (column.unit == "mmHg")
    for (double& value : values) value /= base::mmhg_per_kpa;
  return values;
}

void refuse_negative(const CsvFile& file, const CsvColumn& column, const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] < 0.0)
      throw base::InputError(base::place(file, file.lines[i], column) + "\"" + column.cells[i] +
                             "\", expected 0 or more");
}

std::vector<std::array<double, 3>> positions_of(const CsvFile& file) {
  const std::array<std::string, 3> titles = {"x", "y", "z"};
  if (std::none_of(titles.begin(), titles.end(), [&](const std::string& title) { return has_column(file, title); }))
    return {};
  std::vector<std::array<double, 3>> positions(file.lines.size());
  for (std::size_t k = 0; k < titles.size(); ++k) {
    const CsvColumn& coordinate = column(file, titles[k]);
    if (coordinate.unit != "mm") refuse_unit(file, coordinate, "[mm]");
    const std::vector<double> values = base::numbers(file, coordinate);
    for (std::size_t i = 0; i < values.size(); ++i) positions[i][k] = values[i];
  }
  return positions;
}

/// The row of that number alone, so that an empty cell elsewhere does no harm.
CsvFile only_row(CsvFile file, std::size_t row) {
  file.lines = {file.lines[row]};
  for (CsvColumn& column : file.columns) column.cells = {column.cells[row]};
  return file;
}

/// Each name must be that of a level or a point of the run, and of one only.
Pressures by_name(const MeasuredPlaces& measured, const std::string& folder) {
  std::vector<std::pair<const ResultFile*, CsvFile>> tables;
  base::Texts known;
  for (const ResultFile& result : result_files) {
    const std::string path = (std::filesystem::path(folder) / result.file).string();
    if (!std::filesystem::exists(path)) continue;
    tables.emplace_back(&result, base::read_csv(path, "point"));
    const CsvColumn& titles = column(tables.back().second, result.name);
    known.insert(known.end(), titles.cells.begin(), titles.cells.end());
  }
  if (tables.empty())
    throw base::InputError(folder +
                           ": neither pressure-levels.csv nor pressure-points.csv is there; name the folder of a run "
                           "whose scene asks for levels or points, or give positions x, y, z");
  Pressures computed;
  for (const std::string& name : measured.pressures.names) {
    const auto found = std::count(known.begin(), known.end(), name);
    if (found == 0)
      throw base::InputError(measured.path + ": \"" + name + "\" is no level or point of the run in " + folder +
                             base::hint(name, known));
    if (found > 1)
      throw base::InputError(measured.path + ": the run in " + folder + " has " + std::to_string(found) + " places \"" +
                             name + "\"; give each a name of its own in the scene");
    for (const auto& [result, table] : tables) {
      const std::vector<std::string>& titles = column(table, result->name).cells;
      const auto at = std::find(titles.begin(), titles.end(), name);
      if (at == titles.end()) continue;
      const CsvFile row = only_row(table, static_cast<std::size_t>(at - titles.begin()));
      computed.names.push_back(name);
      computed.values.push_back(kilopascals(row, column(row, result->pressure)).front());
      computed.errors.push_back(kilopascals(row, column(row, result->error)).front());
    }
  }
  return computed;
}

const std::vector<double>& nodal_field(const result::Results& results, const std::string& name,
                                       const std::string& path) {
  for (const result::FieldValues& field : results.nodal)
    if (field.name.name == name && field.name.unit == "kPa") return field.values;
  throw base::InputError(path + ": holds no \"" + name + "\"");
}

body::TriangleMesh body_of(const result::Results& results) {
  body::TriangleMesh mesh;
  const auto& [x, y, z] = std::tie(results.position[0], results.position[1], results.position[2]);
  for (std::size_t n = static_cast<std::size_t>(results.garment_nodes); n < x.size(); ++n)
    mesh.vertices.emplace_back(x[n], y[n], z[n]);
  const std::vector<int>& corners = results.body.front().connectivity;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    mesh.triangles.push_back({corners[t] - results.garment_nodes, corners[t + 1] - results.garment_nodes,
                              corners[t + 2] - results.garment_nodes});
  return mesh;
}

/// On the facets that show the body, between whose corners the pressure is linear.
Pressures by_position(const MeasuredPlaces& measured, const std::string& folder) {
  constexpr double near = 20.0;  // mm
  const std::string path = (std::filesystem::path(folder) / "results.exo").string();
  const result::Results results = result::read_results(path);
  if (results.body.empty()) throw base::InputError(path + ": the scene has no body, so there is no pressure");
  const std::vector<double>&pressure = nodal_field(results, "pressure", path),
        &error = nodal_field(results, "pressure_error", path);
  const body::TriangleMesh mesh = body_of(results);
  const body::TriangleTree tree(mesh);
  Pressures computed;
  for (std::size_t i = 0; i < measured.positions.size(); ++i) {
    const auto& [x, y, z] = measured.positions[i];
    const body::TriangleTree::Hit hit = tree.closest({x, y, z});
    if (hit.distance > near) {
      std::ostringstream text;
      text.precision(4);
      text << measured.path << ": \"" << measured.pressures.names[i] << "\" at (" << x << ", " << y << ", " << z
           << ") lies " << hit.distance << " mm from the body's skin; allowed are " << near << " mm";
      throw base::InputError(text.str());
    }
    double value = 0.0, its_error = 0.0;
    const std::array<int, 3>& corners = mesh.triangles[static_cast<std::size_t>(hit.triangle)];
    for (int k = 0; k < 3; ++k) {
      const std::size_t node = static_cast<std::size_t>(results.garment_nodes) +
                               static_cast<std::size_t>(corners[static_cast<std::size_t>(k)]);
      value += hit.barycentric[k] * pressure[node];
      its_error += hit.barycentric[k] * error[node];
    }
    computed.names.push_back(measured.pressures.names[i]);
    computed.values.push_back(value);
    computed.errors.push_back(its_error);
  }
  return computed;
}

}  // namespace

MeasuredPlaces read_measured(const std::string& path) {
  const CsvFile file = base::read_csv(path);
  const CsvColumn &pressure = column(file, "pressure"), &scatter = column(file, "scatter");
  MeasuredPlaces measured{
      path, {column(file, "name").cells, kilopascals(file, pressure), kilopascals(file, scatter)}, positions_of(file)};
  if (measured.pressures.names.empty()) throw base::InputError(path + ": no pressure follows the line of titles");
  refuse_negative(file, pressure, measured.pressures.values);
  refuse_negative(file, scatter, measured.pressures.errors);
  return measured;
}

Pressures computed_at(const MeasuredPlaces& measured, const std::string& folder) {
  return measured.positions.empty() ? by_name(measured, folder) : by_position(measured, folder);
}

}  // namespace toile::app
