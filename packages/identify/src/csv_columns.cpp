#include "csv_columns.hpp"

#include <charconv>
#include <cmath>
#include <fstream>

#include "toile/base/error.hpp"

namespace toile::identify {
namespace {

/// What spreadsheets put in front of UTF-8.
const std::string byte_order_mark = "\xEF\xBB\xBF";

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  for (std::size_t comma = line.find(','); comma != std::string::npos; comma = line.find(',', from)) {
    cells.push_back(trimmed(line.substr(from, comma - from)));
    from = comma + 1;
  }
  cells.push_back(trimmed(line.substr(from)));
  return cells;
}

CsvColumn title(const std::string& cell, int number) {
  const auto open = cell.rfind('['), close = cell.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return {cell, "", number, false, {}};
  return {trimmed(cell.substr(0, open)), trimmed(cell.substr(open + 1, close - open - 1)), number, true, {}};
}

/// The titles of `line`; a line whose cells are separated otherwise is refused.
void add_titles(CsvFile& file, const std::string& line) {
  if (line.find(',') == std::string::npos && line.find(';') != std::string::npos)
    throw base::InputError(file.path + ", line " + std::to_string(file.title_line) +
                           ": columns are separated by semicolons; write commas, and points in numbers");
  for (const std::string& cell : cells_of(line))
    file.columns.push_back(title(cell, static_cast<int>(file.columns.size()) + 1));
}

void add_row(CsvFile& file, const std::string& line, int number) {
  const std::vector<std::string> cells = cells_of(line);
  if (cells.size() != file.columns.size())
    throw base::InputError(file.path + ", line " + std::to_string(number) + ": " + std::to_string(cells.size()) +
                           " cells, but the titles of line " + std::to_string(file.title_line) + " are " +
                           std::to_string(file.columns.size()));
  file.lines.push_back(number);
  for (std::size_t i = 0; i < cells.size(); ++i) file.columns[i].cells.push_back(cells[i]);
}

}  // namespace

CsvFile read_csv(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw base::InputError("cannot read the data file " + path);
  CsvFile file;
  file.path = path;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (number == 1 && line.compare(0, byte_order_mark.size(), byte_order_mark) == 0)
      line.erase(0, byte_order_mark.size());
    if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
    if (file.title_line != 0) {
      add_row(file, line, number);
      continue;
    }
    file.title_line = number;
    add_titles(file, line);
  }
  if (file.title_line == 0) throw base::InputError(path + ": the file has no line of titles");
  return file;
}

std::string place(const CsvFile& file, int line, const CsvColumn& column) {
  return file.path + ", line " + std::to_string(line) + ", column " + std::to_string(column.number) + " \"" +
         column.name + "\": ";
}

std::vector<double> numbers(const CsvFile& file, const CsvColumn& column) {
  std::vector<double> values;
  for (std::size_t row = 0; row < column.cells.size(); ++row) {
    const std::string& cell = column.cells[row];
    double value = 0.0;
    const char* end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data() + (!cell.empty() && cell[0] == '+'), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      throw base::InputError(place(file, file.lines[row], column) +
                             (cell.empty() ? "the cell is empty" : "\"" + cell + "\"") + ", expected a finite number");
    values.push_back(value);
  }
  return values;
}

}  // namespace toile::identify
