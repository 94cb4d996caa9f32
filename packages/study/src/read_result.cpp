#include "read_result.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <optional>

#include "not_a_number.hpp"
#include "toile/base/csv_file.hpp"
#include "toile/base/error.hpp"

namespace toile::study {

namespace {

double number(const std::string& cell) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && stop == cell.data() + cell.size() ? value : not_a_number;
}

const base::CsvColumn* find_column(const base::CsvFile& file, const std::string& name, const std::string& unit = "") {
  for (const base::CsvColumn& column : file.columns)
    if (column.name == name && (unit.empty() || column.unit == unit)) return &column;
  return nullptr;
}

/// Where a quantity stands in the files of a run. An empty row is the last one.
struct Place {
  std::string file, row, column, unit, bar;
};

Place place_of(const Quantity& q) {
  if (q.type == "level") return {"pressure-levels.csv", q.of, "mean pressure", "kPa", "error of the mean pressure"};
  if (q.type == "point") return {"pressure-points.csv", q.of, "pressure", "kPa", "its error"};
  if (q.type == "displacement") return {"points.csv", "", q.of + ": displacement " + q.component, "mm", ""};
  if (q.type == "distance") return {"distances.csv", "", q.of, "mm", ""};
  if (q.type == "reaction") return {"reactions.csv", "", "support " + q.of + ": " + q.component, "N", ""};
  if (q.type == "body force") return {"body-force.csv", q.component, "force", "N", "its error"};
  if (q.type == "torque") return {"torques.csv", "", q.of + ": torque", "N mm", ""};
  return {"figures.csv", q.of, "value", "", ""};
}

std::optional<std::size_t> find_row(const base::CsvFile& file, const std::string& name) {
  const std::vector<std::string>& names = file.columns.front().cells;
  if (names.empty()) return std::nullopt;
  if (name.empty()) return names.size() - 1;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

Reading read(const std::string& folder, const Place& place) {
  const std::string path = folder + "/" + place.file;
  if (!std::filesystem::exists(path)) return {not_a_number, not_a_number};
  const base::CsvFile file = base::read_csv(path, "point");
  const base::CsvColumn* value = find_column(file, place.column, place.unit);
  const base::CsvColumn* bar = place.bar.empty() ? nullptr : find_column(file, place.bar, place.unit);
  const auto row = find_row(file, place.row);
  if (value == nullptr || !row) return {not_a_number, not_a_number};
  return {number(value->cells[*row]), bar == nullptr ? not_a_number : number(bar->cells[*row])};
}

/// A label of the study and a cell of the file mean the same: as texts or as numbers.
bool same(const std::string& label, const std::string& cell) {
  return label == cell || number(label) == number(cell);
}

double from_file(const Study& study, const Quantity& quantity, const Case& one) {
  const base::CsvFile file = base::read_csv(quantity.reference_file, "point");
  const base::CsvColumn* value = find_column(file, quantity.reference_column);
  if (value == nullptr)
    throw base::InputError(file.path + ": there is no column \"" + quantity.reference_column + "\"");
  for (std::size_t row = 0; row < value->cells.size(); ++row) {
    bool found = true;
    for (std::size_t a = 0; a < study.axes.size(); ++a)
      for (std::size_t c = 0; c < study.axes[a].changes.size(); ++c)
        if (const base::CsvColumn* key = find_column(file, study.axes[a].changes[c].name))
          found = found && same(study.label(one, a, c), key->cells[row]);
    if (!found) continue;
    if (number(value->cells[row]) == 0.0)
      throw base::InputError(file.path + ": the value of " + one.name + " is 0, and errors are told in % of it");
    return number(value->cells[row]);
  }
  throw base::InputError(file.path + ": no row is that of " + one.name);
}

}  // namespace

Reading read_result(const std::string& folder, const Quantity& quantity) {
  return read(folder, place_of(quantity));
}

double read_figure(const std::string& folder, const std::string& name) {
  return read(folder, {"figures.csv", name, "value", "", ""}).value;
}

double reference_value(const Study& study, const Quantity& quantity, const Case& one) {
  if (!quantity.reference_file.empty()) return from_file(study, quantity, one);
  if (quantity.reference.empty()) return not_a_number;
  if (quantity.reference.size() == 1) return quantity.reference.front();
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (study.axes[a].problem) return quantity.reference[one.place[a]];
  return not_a_number;
}

}  // namespace toile::study
