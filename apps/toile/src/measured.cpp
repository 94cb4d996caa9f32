#include "measured.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <sstream>
#include <utility>

#include "toile/base/csv_file.hpp"
#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"
#include "toile/base/units.hpp"
#include "toile/body/border.hpp"
#include "toile/body/triangle_tree.hpp"
#include "toile/result/body_map.hpp"
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
  std::string all;
  for (const CsvColumn& column : file.columns) {
    if (column.name == name) return column;
    names.push_back(column.name);
    all += (all.empty() ? "" : ", ") + column.name;
  }
  const std::string near = base::nearest_name(name, names);
  throw base::InputError(file.path + ", line " + std::to_string(file.title_line) + ": there is no column \"" + name +
                         "\"" + (near.empty() ? "" : "; is it \"" + near + "\"?") + " (found: " + all + ")");
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

/// Whether a row has a position, or a part of one, in the columns of x, y and z. Throws InputError if some rows have
/// one and others have none.
bool have_positions(const CsvFile& file, const std::array<const CsvColumn*, 3>& xyz) {
  std::array<int, 2> line = {0, 0};  // [has one] the first of those
  for (std::size_t row = 0; row < file.lines.size(); ++row) {
    const bool has = std::any_of(xyz.begin(), xyz.end(), [&](const CsvColumn* c) { return !c->cells[row].empty(); });
    if (line[has] == 0) line[has] = file.lines[row];
  }
  if (line[0] != 0 && line[1] != 0)
    throw base::InputError(file.path + ": line " + std::to_string(line[1]) + " has a position x, y, z, and line " +
                           std::to_string(line[0]) +
                           " has none: places are either on the body by their positions, or levels and points of the "
                           "run by their names; give each line a position, or write two files");
  return line[1] != 0;
}

std::vector<std::array<double, 3>> positions_of(const CsvFile& file) {
  const std::array<std::string, 3> titles = {"x", "y", "z"};
  if (std::none_of(titles.begin(), titles.end(), [&](const std::string& title) { return has_column(file, title); }))
    return {};
  const std::array<const CsvColumn*, 3> xyz = {&column(file, "x"), &column(file, "y"), &column(file, "z")};
  if (!have_positions(file, xyz)) return {};
  std::vector<std::array<double, 3>> positions(file.lines.size());
  for (std::size_t k = 0; k < xyz.size(); ++k) {
    if (xyz[k]->unit != "mm") refuse_unit(file, *xyz[k], "[mm]");
    const std::vector<double> values = base::numbers(file, *xyz[k]);
    for (std::size_t i = 0; i < values.size(); ++i) positions[i][k] = values[i];
  }
  return positions;
}

void refuse_nameless(const CsvFile& file, const CsvColumn& name) {
  for (std::size_t row = 0; row < name.cells.size(); ++row)
    if (name.cells[row].empty())
      throw base::InputError(base::place(file, file.lines[row], name) + "the cell is empty; give each place a name");
}

/// A measured quantity in several units, or twice in one, could mean several things.
void refuse_several(const CsvFile& file) {
  for (const CsvColumn& one : file.columns)
    for (const CsvColumn& other : file.columns)
      if (one.number < other.number && one.name == other.name)
        throw base::InputError(file.path + ", line " + std::to_string(file.title_line) + ": the columns " +
                               std::to_string(one.number) + " and " + std::to_string(other.number) + " are both \"" +
                               one.name + "\"; keep one of them");
}

/// Rows of one place.
struct Repeated {
  std::vector<std::size_t> rows;
  std::string lines;  ///< "2, 5"
};

std::vector<Repeated> places_of(const MeasuredPlaces& rows, const CsvFile& file) {
  const std::vector<std::string>& names = rows.pressures.names;
  std::vector<Repeated> places;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto same = [&](const Repeated& place) { return names[place.rows.front()] == names[i]; };
    const auto at = std::find_if(places.begin(), places.end(), same);
    if (at == places.end()) {
      places.push_back({{i}, std::to_string(file.lines[i])});
      continue;
    }
    at->rows.push_back(i);
    at->lines += ", " + std::to_string(file.lines[i]);
    if (!rows.positions.empty() && rows.positions[i] != rows.positions[at->rows.front()])
      throw base::InputError(file.path + ": \"" + names[i] + "\" has several positions (lines " + at->lines +
                             "); give each place a name of its own");
  }
  return places;
}

/// One row a place.
MeasuredPlaces averaged(const MeasuredPlaces& rows, const CsvFile& file) {
  MeasuredPlaces all{rows.path, {}, {}};
  for (const Repeated& place : places_of(rows, file)) {
    const auto count = static_cast<double>(place.rows.size());
    double mean = 0.0, squares = 0.0;
    for (const std::size_t i : place.rows) mean += rows.pressures.values[i] / count;
    for (const std::size_t i : place.rows)
      squares += (std::pow(rows.pressures.errors[i], 2) + std::pow(rows.pressures.values[i] - mean, 2)) / count;
    const std::size_t first = place.rows.front();
    const bool once = place.rows.size() == 1;
    all.pressures.names.push_back(rows.pressures.names[first]);
    all.pressures.values.push_back(once ? rows.pressures.values[first] : mean);
    all.pressures.errors.push_back(once ? rows.pressures.errors[first] : std::sqrt(squares));
    if (!rows.positions.empty()) all.positions.push_back(rows.positions[first]);
    if (!once)
      all.pressures.notes.push_back("\"" + rows.pressures.names[first] + "\" was measured " +
                                    std::to_string(place.rows.size()) + " times (lines " + place.lines +
                                    "): compared is the mean, with the scatter of all together");
  }
  return all;
}

std::string no_fabric(const std::string& name) {
  return "no fabric lies at \"" + name + "\", so 0 is computed there";
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
      if (has_column(row, "gap") && column(row, "gap").cells.front().empty()) computed.notes.push_back(no_fabric(name));
    }
  }
  return computed;
}

const std::vector<double>& nodal_field(const result::Results& results, const std::string& name,
                                       const std::string& path) {
  for (const result::FieldValues& field : results.nodal)
    if (field.name.name == name) return field.values;
  throw base::InputError(path + ": holds no \"" + name + "\"");
}

/// Of the last step.
body::Vec3 position_of(const result::Results& results, std::size_t node) {
  return {results.position[0][node], results.position[1][node], results.position[2][node]};
}

body::TriangleMesh body_of(const result::Results& results) {
  body::TriangleMesh mesh;
  for (std::size_t n = static_cast<std::size_t>(results.garment_nodes); n < results.position[0].size(); ++n)
    mesh.vertices.push_back(position_of(results, n));
  const std::vector<int>& corners = results.body.front().connectivity;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
    mesh.triangles.push_back({corners[t] - results.garment_nodes, corners[t + 1] - results.garment_nodes,
                              corners[t + 2] - results.garment_nodes});
  return mesh;
}

/// The garment's elements, as far as a BodyMap asks for them.
mesh::Mesh mesh_of(const result::Results& results) {
  mesh::Mesh mesh;
  mesh.pattern.assign(static_cast<std::size_t>(results.garment_nodes), mesh::Vec2::Zero());
  for (const result::ResultsBlock& panel : results.garment) {
    mesh.blocks.emplace_back();
    mesh.blocks.back().nodes_per_element = panel.nodes_per_element;
    mesh.blocks.back().connectivity = panel.connectivity;
  }
  return mesh;
}

/// [node] the first of those that lie at the same place: a closed seam ties them.
std::vector<int> tied(const std::vector<body::Vec3>& position) {
  constexpr double same = 1e-6;  // mm
  std::map<std::array<long, 3>, int> first;
  std::vector<int> tied;
  for (const body::Vec3& x : position)
    tied.push_back(first
                       .try_emplace({std::lround(x[0] / same), std::lround(x[1] / same), std::lround(x[2] / same)},
                                    static_cast<int>(tied.size()))
                       .first->second);
  return tied;
}

result::GarmentOnBody garment_of(const result::Results& results, const mesh::Mesh& mesh, const std::string& path) {
  result::GarmentOnBody garment;
  garment.mesh = &mesh;
  garment.distance = nodal_field(results, "gap", path);
  garment.distance.resize(static_cast<std::size_t>(results.garment_nodes));
  const std::array<const std::vector<double>*, 3> normal = {&nodal_field(results, "normal_x", path),
                                                            &nodal_field(results, "normal_y", path),
                                                            &nodal_field(results, "normal_z", path)};
  for (std::size_t n = 0; n < garment.distance.size(); ++n) {
    garment.position.push_back(position_of(results, n));
    garment.normal.emplace_back((*normal[0])[n], (*normal[1])[n], (*normal[2])[n]);
  }
  garment.tied = tied(garment.position);
  return garment;
}

/// Where the positions lie on the skin, of which facets show a part.
struct OnSkin {
  std::vector<body::Vec3> points, normals;
};

/// The place is on the facets' border, where the skin may go on although it is not shown.
bool at_border(const body::TriangleTree::Hit& hit, const body::TriangleMesh& facets, const std::vector<char>& border) {
  constexpr double none = 1e-9;
  const std::array<int, 3>& corners = facets.triangles[static_cast<std::size_t>(hit.triangle)];
  for (int k = 0; k < 3; ++k) {
    const int corner = corners[static_cast<std::size_t>(k)];
    if (hit.barycentric[k] > none && border[static_cast<std::size_t>(corner)] == 0) return false;
  }
  return true;
}

OnSkin on_skin(const MeasuredPlaces& measured, const result::Results& results) {
  constexpr double near = 20.0;  // mm
  const body::TriangleMesh facets = body_of(results);
  const std::vector<char> border = body::border_vertices(facets);
  const body::TriangleTree tree(facets);
  OnSkin skin;
  for (std::size_t i = 0; i < measured.positions.size(); ++i) {
    const auto& [x, y, z] = measured.positions[i];
    const body::Vec3 position(x, y, z);
    const body::TriangleTree::Hit hit = tree.closest(position);
    if (hit.distance > near) {
      std::ostringstream text;
      text.precision(4);
      text << measured.path << ": \"" << measured.pressures.names[i] << "\" at (" << x << ", " << y << ", " << z
           << ") lies " << hit.distance << " mm from the body's skin; allowed are " << near << " mm";
      throw base::InputError(text.str());
    }
    const body::Vec3& normal = hit.pseudo_normal;
    // Beyond the border the closest place is the border itself, where fabric may lie that ends there.
    skin.points.push_back(at_border(hit, facets, border) ? position - (position - hit.point).dot(normal) * normal
                                                         : hit.point);
    skin.normals.push_back(normal);
  }
  return skin;
}

/// Of the fabric itself: what the body's facets show beside a hem is spread over their width.
Pressures by_position(const MeasuredPlaces& measured, const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "results.exo").string();
  const result::Results results = result::read_results(path);
  if (results.body.empty()) throw base::InputError(path + ": the scene has no body, so there is no pressure");
  const OnSkin skin = on_skin(measured, results);
  const mesh::Mesh mesh = mesh_of(results);
  const result::GarmentOnBody garment = garment_of(results, mesh, path);
  const result::BodyMap map(garment, skin.points, skin.normals);
  const std::vector<double>& pressure = nodal_field(results, "pressure", path);
  Pressures computed{measured.pressures.names, map.on(pressure), map.on(nodal_field(results, "pressure_error", path))};
  const std::vector<double> beside = map.beside(pressure);
  for (std::size_t i = 0; i < beside.size(); ++i) {
    computed.errors[i] = std::hypot(computed.errors[i], beside[i]);
    if (map.layers()[i] == 0) computed.notes.push_back(no_fabric(computed.names[i]));
  }
  return computed;
}

}  // namespace

MeasuredPlaces read_measured(const std::string& path) {
  const CsvFile file = base::read_csv(path);
  refuse_several(file);
  const CsvColumn &pressure = column(file, "pressure"), &scatter = column(file, "scatter");
  MeasuredPlaces measured{
      path, {column(file, "name").cells, kilopascals(file, pressure), kilopascals(file, scatter)}, positions_of(file)};
  refuse_nameless(file, column(file, "name"));
  if (measured.pressures.names.empty()) throw base::InputError(path + ": no pressure follows the line of titles");
  refuse_negative(file, pressure, measured.pressures.values);
  refuse_negative(file, scatter, measured.pressures.errors);
  return averaged(measured, file);
}

Pressures computed_at(const MeasuredPlaces& measured, const std::string& folder) {
  return measured.positions.empty() ? by_name(measured, folder) : by_position(measured, folder);
}

}  // namespace toile::app
