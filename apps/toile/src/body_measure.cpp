#include <Eigen/Geometry>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "body_input.hpp"
#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/body/landmarks.hpp"
#include "toile/body/section.hpp"
#include "toile/result/csv.hpp"

namespace toile::app {
namespace {

using body::Vec3;

struct MeasureArguments {
  BodyFileArguments body;
  std::vector<std::string> at;      ///< heights, points or landmarks
  std::vector<double> normal;       ///< empty: z, or that of the landmark
  bool all_pieces = false;          ///< at landmarks too
  std::vector<std::string> length;  ///< pairs of places
  std::string csv;                  ///< file; empty: none
};

/// A place that the command line names.
struct Place {
  std::string text;
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  bool is_landmark = false;
  bool is_height = false;
};

/// A piece of a section with where it was cut.
struct Row {
  std::string name;
  body::SectionPiece piece;
};

/// Numbers that fill a text, separated by commas; none if it is something else.
std::optional<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> values;
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, comma - at);
    std::size_t read = 0;
    try {
      values.push_back(std::stod(part, &read));
    } catch (const std::logic_error&) {
      return {};
    }
    if (part.find_first_not_of(' ', read) != std::string::npos || !std::isfinite(values.back())) return {};
    at = comma + 1;
  }
  return values;
}

/// The body with its landmarks, which are looked for when the first is named.
class Measured {
 public:
  Measured(const body::TriangleMesh& mesh, std::string file) : mesh_(mesh), file_(std::move(file)), sections_(mesh) {}
  const body::Sections& sections() const { return sections_; }

  Place place(const std::string& text) {
    Place place;
    place.text = text;
    if (const auto values = numbers_of(text)) {
      if (values->size() != 1 && values->size() != 3)
        throw base::InputError("\"" + text + "\" has " + std::to_string(values->size()) +
                               " numbers; a place is a height z, a point x,y,z or a landmark");
      place.is_height = values->size() == 1;
      place.point = place.is_height ? Vec3(0.0, 0.0, values->front()) : Vec3((*values)[0], (*values)[1], (*values)[2]);
      return place;
    }
    if (!landmarks_) {
      landmarks_ = body::find_landmarks(mesh_, file_);
      tell_warnings(*landmarks_);
    }
    const body::Landmark landmark = landmarks_->place(text);
    place.point = landmark.point;
    if (!landmark.normal.isZero()) place.normal = landmark.normal;
    place.is_landmark = true;
    return place;
  }

 private:
  const body::TriangleMesh& mesh_;
  std::string file_;
  body::Sections sections_;
  std::optional<body::Landmarks> landmarks_;
};

Vec3 read_normal(const std::vector<double>& values) {
  const Vec3 normal(values[0], values[1], values[2]);
  if (!(normal.norm() > 0.0)) throw base::InputError("--normal must not be zero");
  return normal.normalized();
}

void add_rows(const MeasureArguments& arguments, Measured* body, const std::string& text, std::vector<Row>* rows) {
  Place place = body->place(text);
  if (!arguments.normal.empty()) place.normal = read_normal(arguments.normal);
  std::vector<body::SectionPiece> pieces = body->sections().cut(place.point, place.normal);
  if (pieces.empty()) throw base::InputError("--at " + text + ": the plane misses the body");
  if (place.is_landmark && !arguments.all_pieces) {
    const auto nearest = std::min_element(pieces.begin(), pieces.end(), [&place](const auto& a, const auto& b) {
      return (a.centre - place.point).norm() < (b.centre - place.point).norm();
    });
    rows->push_back({text, *nearest});
    return;
  }
  // From the body's left to its right.
  std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.centre.x() > b.centre.x(); });
  for (std::size_t i = 0; i < pieces.size(); ++i)
    rows->push_back({text + (pieces.size() > 1 ? " (" + std::to_string(i + 1) + ")" : ""), pieces[i]});
}

void print_sections(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> table = {
      {"section", "tape girth [mm]", "[cm]", "perimeter [mm]", "[cm]", "area [cm2]", "centre x, y, z [mm]", ""}};
  for (const Row& row : rows) {
    const body::SectionPiece& p = row.piece;
    table.push_back({row.name, decimals(p.tape_girth, 1), decimals(0.1 * p.tape_girth, 2), decimals(p.perimeter, 1),
                     decimals(0.1 * p.perimeter, 2), decimals(0.01 * p.area, 1),
                     decimals(p.centre.x(), 1) + ", " + decimals(p.centre.y(), 1) + ", " + decimals(p.centre.z(), 1),
                     p.closed ? "" : "open"});
  }
  std::cout << text_table(table);
}

void write_sections(const std::string& file, const std::vector<Row>& rows) {
  result::Table table{"section", {}, {}};
  const auto column = [&](const std::string& name, const std::string& unit, auto value) {
    table.columns.push_back({{name, unit}, {}});
    for (const Row& row : rows) table.columns.back().values.push_back(value(row.piece));
  };
  for (const Row& row : rows) table.row_names.push_back(row.name);
  column("tape girth", "mm", [](const auto& p) { return p.tape_girth; });
  column("perimeter", "mm", [](const auto& p) { return p.perimeter; });
  column("area", "mm^2", [](const auto& p) { return p.area; });
  column("x", "mm", [](const auto& p) { return p.centre.x(); });
  column("y", "mm", [](const auto& p) { return p.centre.y(); });
  column("z", "mm", [](const auto& p) { return p.centre.z(); });
  column("closed", "", [](const auto& p) { return p.closed ? 1.0 : 0.0; });
  result::write_csv(file, table);
}

void print_lengths(const MeasureArguments& arguments, Measured* body) {
  std::vector<std::vector<std::string>> table = {{"length", "straight [mm]", "[cm]", "on the body [mm]", "[cm]"}};
  for (std::size_t i = 0; i + 1 < arguments.length.size(); i += 2) {
    const Place from = body->place(arguments.length[i]), to = body->place(arguments.length[i + 1]);
    for (const Place& place : {from, to})
      if (place.is_height)
        throw base::InputError("--length: \"" + place.text +
                               "\" is a height; a length is between points x,y,z or "
                               "landmarks");
    const double straight = (to.point - from.point).norm();
    const double along = body->sections().length_on_surface(from.point, to.point);
    table.push_back({from.text + " to " + to.text, decimals(straight, 1), decimals(0.1 * straight, 2),
                     decimals(along, 1), decimals(0.1 * along, 2)});
  }
  std::cout << text_table(table);
}

int measure_body(const MeasureArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError("body measure runs on one rank; start it without mpirun");
  if (arguments.csv.size() > 0 && arguments.at.empty())
    throw base::InputError("--csv writes the sections, and --at asks for none");
  const body::Import import = read_body(arguments.body);
  const body::Extent extent = body::extent_of(import.mesh);
  Measured body(import.mesh, arguments.body.file);
  std::vector<Row> rows;
  for (const std::string& text : arguments.at) add_rows(arguments, &body, text, &rows);
  std::cout << "extents    ";
  for (int i = 0; i < 3; ++i)
    std::cout << (i == 0   ? "x "
                  : i == 1 ? ", y "
                           : ", z ")
              << decimals(extent.lower[i], 1) << " to " << decimals(extent.upper[i], 1);
  std::cout << " mm\nvolume     " << decimals(1e-6 * extent.volume, 3) << " litres"
            << (arguments.body.open ? " (seen from its centre, if it is open)" : "") << "\nsurface    "
            << decimals(1e-6 * extent.area, 4) << " m2\npieces     " << extent.pieces << "\n";
  if (!rows.empty()) print_sections(rows);
  if (!arguments.csv.empty()) write_sections(arguments.csv, rows);
  if (!arguments.length.empty()) print_lengths(arguments, &body);
  std::cout << std::flush;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_body_measure(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<MeasureArguments>();
  CLI::App* command = body_command(program)->add_subcommand("measure", "Size, girths, sections and lengths of a body");
  add_body_file(command, arguments->body);
  command
      ->add_option("--at", arguments->at,
                   "Cut here: a height (1020), a point (0,-50,1020), a landmark (waist) or mm above or below one "
                   "(waist+30); may be repeated. At a landmark the piece nearest to it is told, else all pieces, from "
                   "the body's left to its right")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("WHERE");
  command
      ->add_option("--normal", arguments->normal, "Normal of the planes (default: z; across the arm at its landmarks)")
      ->expected(3)
      ->delimiter(',')
      ->type_name("X,Y,Z");
  command->add_flag("--all-pieces", arguments->all_pieces, "Every piece of the sections at landmarks");
  command
      ->add_option("--length", arguments->length,
                   "Length between two points or landmarks, straight and on the body; may be repeated")
      ->expected(2)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("A B");
  command->add_option("--csv", arguments->csv, "Also write the sections to this file")->type_name("FILE");
  command->callback([arguments, &chosen] { chosen = [arguments] { return measure_body(*arguments); }; });
}

}  // namespace toile::app
