#include "toile/identify/curve.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "toile/base/csv_file.hpp"
#include "toile/base/error.hpp"

namespace toile::identify {
namespace {

using base::CsvColumn;
using base::CsvFile;

constexpr std::size_t least_rows = 3;
/// No fabric reaches it: what is above is in another unit than its title says.
constexpr double largest_stretch = 10.0;

struct Unit {
  const char* name;
  double factor;  ///< to 1, mm, MPa, N/mm or N
};

/// A quantity that a column may hold, with its units.
struct Quantity {
  const char* name;
  std::vector<Unit> units;
};

const std::vector<Quantity>& elongations() {
  static const std::vector<Quantity> all = {
      {"stretch", {{"-", 1.0}}},
      {"strain", {{"-", 1.0}, {"%", 0.01}}},
      {"displacement", {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}}},
  };
  return all;
}

const std::vector<Quantity>& loads() {
  static const std::vector<Quantity> all = {
      {"nominal stress", {{"MPa", 1.0}, {"N/mm^2", 1.0}, {"kPa", 1e-3}, {"Pa", 1e-6}}},
      {"line force", {{"N/mm", 1.0}, {"N/cm", 0.1}, {"N/m", 1e-3}}},
      {"force", {{"N", 1.0}, {"mN", 1e-3}, {"cN", 1e-2}, {"kN", 1e3}}},
  };
  return all;
}

std::string units_text(const Quantity& quantity) {
  std::string text;
  for (const Unit& unit : quantity.units) text += (text.empty() ? "" : ", ") + std::string(unit.name);
  return text;
}

struct Found {
  const Quantity* quantity;
  const CsvColumn* column;
};

/// The one column of `file` that holds one of `quantities`.
Found find_column(const CsvFile& file, const std::vector<Quantity>& quantities, const std::string& what) {
  Found found = {nullptr, nullptr};
  std::string titles, valid;
  for (const CsvColumn& column : file.columns) titles += (titles.empty() ? "\"" : ", \"") + column.name + "\"";
  for (const Quantity& quantity : quantities) {
    valid += (valid.empty() ? "\"" : ", \"") + std::string(quantity.name) + "\" [" + units_text(quantity) + "]";
    for (const CsvColumn& column : file.columns) {
      if (column.name != quantity.name) continue;
      if (found.column != nullptr)
        throw base::InputError(place(file, file.title_line, column) + "a second column of the " + what + ", beside \"" +
                               found.column->name + "\" in column " + std::to_string(found.column->number) +
                               ": only one may be there");
      found = {&quantity, &column};
    }
  }
  if (found.column == nullptr)
    throw base::InputError(file.path + ", line " + std::to_string(file.title_line) + ": no column of the " + what +
                           ". Found: " + titles + ". One of these is needed: " + valid);
  return found;
}

/// Values of the column in the unit that Toile computes in.
std::vector<double> converted(const CsvFile& file, const Found& found) {
  const auto& units = found.quantity->units;
  const auto unit =
      std::find_if(units.begin(), units.end(), [&](const Unit& u) { return found.column->unit == u.name; });
  if (unit == units.end())
    throw base::InputError(place(file, file.title_line, *found.column) +
                           (found.column->has_unit ? "unknown unit \"" + found.column->unit + "\"" : "no unit") +
                           "; write \"" + found.column->name + " [unit]\" with one of: " + units_text(*found.quantity));
  std::vector<double> values = numbers(file, *found.column);
  for (double& value : values) value *= unit->factor;
  return values;
}

double needed(const base::List& list, const std::string& parameter, const std::string& why) {
  if (!list.given(parameter)) list.fail(parameter, "must be given, because " + why);
  return list.real(parameter);
}

double needed(const base::List& list, const std::string& parameter, const Found& found) {
  return needed(list, parameter, "the data file holds \"" + std::string(found.quantity->name) + "\"");
}

std::string too_large(const CsvFile& file, const Found& found, std::size_t row, double stretch) {
  std::string question = "is \"gauge length\" the length at rest, and is the unit right?";
  if (found.column->unit == "-") question = "was \"strain [%]\" meant?";
  if (found.column->unit == "%") question = "is the number right?";
  std::ostringstream text;
  text << place(file, file.lines[row], *found.column) << found.column->cells[row] << " is a stretch of " << stretch
       << ", allowed: <= " << largest_stretch << "; " << question;
  return text.str();
}

std::vector<double> stretches(const CsvFile& file, const base::List& list) {
  const Found found = find_column(file, elongations(), "elongation");
  const std::string name = found.quantity->name;
  std::vector<double> values = converted(file, found);
  const double scale = name == "displacement" ? 1.0 / needed(list, "gauge length", found) : 1.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && values[i] <= values[i - 1])
      throw base::InputError(place(file, file.lines[i], *found.column) + found.column->cells[i] +
                             " is not larger than " + found.column->cells[i - 1] +
                             " of the row before: elongations must increase from row to row (loading only, one row "
                             "for each)");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = name == "stretch" ? values[i] : 1.0 + scale * values[i];
    if (values[i] <= 0.0)
      throw base::InputError(place(file, file.lines[i], *found.column) + found.column->cells[i] +
                             " is a stretch of zero or less; a stretch is the length over the length at rest");
    if (values[i] > largest_stretch) throw base::InputError(too_large(file, found, i, values[i]));
  }
  return values;
}

std::vector<double> stresses(const CsvFile& file, const base::List& list, double thickness) {
  const Found found = find_column(file, loads(), "load");
  const std::string name = found.quantity->name;
  std::vector<double> values = converted(file, found);
  double section = 1.0;
  if (name != "nominal stress") section = thickness;
  if (name == "force") section *= needed(list, "width", found);
  for (double& value : values) value /= section;
  return values;
}

TestKind kind_of(const std::string& word) {
  if (word == "uniaxial") return TestKind::uniaxial;
  return word == "equibiaxial" ? TestKind::equibiaxial : TestKind::strip_biaxial;
}

std::optional<StripSpecimen> strip_of(const base::List& list) {
  if (list.word("model") == "homogeneous") {
    if (list.given("elements across"))
      list.fail("elements across", "a homogeneous state has no elements; \"model\" must be \"clamped strip\"");
    return std::nullopt;
  }
  if (list.word("kind") != "uniaxial")
    list.fail("model", "a clamped strip is a uniaxial test, but \"kind\" is \"" + list.word("kind") + "\"");
  const std::string why = "\"model\" is \"clamped strip\"";
  return StripSpecimen{needed(list, "gauge length", why), needed(list, "width", why), list.integer("elements across")};
}

}  // namespace

std::vector<TestPoint> Curve::points() const {
  std::vector<TestPoint> all;
  for (const double l : stretch) all.push_back({kind, angle, l});
  return all;
}

base::Spec curve_spec() {
  using base::Range;
  base::Spec spec("curve", "One measured curve.");
  spec.word("file",
            "CSV file, from the folder of this file. Its first line names the columns with their units: one of "
            "stretch [-], strain [- or %], displacement [mm, cm, m], and one of nominal stress [MPa, N/mm^2, kPa, Pa], "
            "line force [N/mm, N/cm, N/m], force [N, mN, cN, kN]. Columns are separated by semicolons, tabs or commas.")
      .choice("decimal mark", "Of the numbers in the file; found: the one that they show.", {"found", "point", "comma"},
              std::string("found"))
      .choice("kind",
              "uniaxial: strip with free lateral contraction and shear. equibiaxial: the same stretch across. strip "
              "biaxial and pure shear: no lateral contraction, two names of one state.",
              {"uniaxial", "equibiaxial", "strip biaxial", "pure shear"}, std::string("uniaxial"))
      .choice("model",
              "homogeneous: one state for the whole specimen. clamped strip: finite elements of a uniaxial specimen "
              "between clamps; the global search takes the homogeneous state in its place, the polish does not.",
              {"homogeneous", "clamped strip"}, std::string("homogeneous"))
      .real("angle", "deg", "Angle of the measured direction to the wale: 0 wale, 90 course, 45 bias.")
      .real("weight", "", "Factor of the curve's squared residuals; 0: it is not fitted, only predicted.", 1.0,
            Range::non_negative())
      .real("noise", "", "Standard deviation of the stress, as a part of the curve's largest.", 0.01, Range::positive())
      .real("relative noise", "", "Further standard deviation, as a part of the stress itself.", 0.0,
            Range::non_negative())
      .real("gauge length", "mm", "Length at rest; for displacements, and between the clamps of a clamped strip.", 0.0,
            Range::positive())
      .real("width", "mm", "Width at rest; for forces and for a clamped strip.", 0.0, Range::positive())
      .integer("elements across",
               "Of a clamped strip: elements across its width; sqrt(gauge length / width) times as many lie along it, "
               "both graded to the corners. The report says how far they are from a mesh twice as fine.",
               12, Range::between(4, 100));
  return spec;
}

Curve read_curve(const base::List& list, double thickness) {
  const std::filesystem::path folder = std::filesystem::path(list.file("file")).parent_path();
  const CsvFile file = base::read_csv((folder / list.word("file")).string(), list.word("decimal mark"));
  Curve curve;
  curve.name = list.name();
  curve.kind = kind_of(list.word("kind"));
  curve.angle = list.real("angle") * std::acos(-1.0) / 180.0;
  curve.weight = list.real("weight");
  curve.strip = strip_of(list);
  curve.stretch = stretches(file, list);
  curve.stress = stresses(file, list, thickness);
  if (curve.stretch.size() < least_rows)
    throw base::InputError(file.path + ": " + std::to_string(curve.stretch.size()) + " rows of data, at least " +
                           std::to_string(least_rows) + " are needed");
  double largest = 0.0;
  for (const double value : curve.stress) largest = std::max(largest, std::abs(value));
  if (largest == 0.0) throw base::InputError(file.path + ": every load is zero");
  for (const double value : curve.stress)
    curve.deviation.push_back(std::hypot(list.real("noise") * largest, list.real("relative noise") * value));
  return curve;
}

}  // namespace toile::identify
