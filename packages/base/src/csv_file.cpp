#include "toile/base/csv_file.hpp"

#include <charconv>
#include <cmath>
#include <regex>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/base/file.hpp"

namespace toile::base {
namespace {

constexpr std::size_t most_csv_bytes = 64U << 20U;

/// What spreadsheets put in front of UTF-8.
const std::string byte_order_mark = "\xEF\xBB\xBF";

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The cells of a line; one in double quotes may hold the separator.
std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

CsvColumn title(const std::string& cell, int number) {
  const auto open = cell.rfind('['), close = cell.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return {cell, "", number, false, {}};
  return {trimmed(cell.substr(0, open)), trimmed(cell.substr(open + 1, close - open - 1)), number, true, {}};
}

void add_titles(CsvFile& file, const std::string& line) {
  file.separator = ',';
  for (const char separator : {'\t', ';'})
    if (cells_of(line, separator).size() > 1) file.separator = separator;
  for (const std::string& cell : cells_of(line, file.separator))
    file.columns.push_back(title(cell, static_cast<int>(file.columns.size()) + 1));
}

void add_row(CsvFile& file, const std::string& line, int number) {
  const std::vector<std::string> cells = cells_of(line, file.separator);
  if (cells.size() != file.columns.size())
    throw InputError(file.path + ", line " + std::to_string(number) + ": " + std::to_string(cells.size()) +
                     " cells, but the titles of line " + std::to_string(file.title_line) + " are " +
                     std::to_string(file.columns.size()) +
                     (file.separator == ',' && cells.size() > file.columns.size()
                          ? "; if numbers have a decimal comma, separate the columns by semicolons"
                          : ""));
  file.lines.push_back(number);
  for (std::size_t i = 0; i < cells.size(); ++i) file.columns[i].cells.push_back(cells[i]);
}

/// Where a number with a point or a comma stands.
struct Sample {
  std::string place, text;
};

/// What the numbers of a file show of their decimal mark.
class DecimalMark {
 public:
  explicit DecimalMark(const CsvFile& file) : file_(file) {
    static const std::regex number("[+-]?[0-9]*[.,][0-9]*([eE][+-]?[0-9]+)?");
    static const std::regex perhaps_thousands("[+-]?[1-9][0-9]{0,2}[.,][0-9]{3}");
    for (const CsvColumn& column : file.columns)
      for (std::size_t row = 0; row < column.cells.size(); ++row) {
        const std::string& cell = column.cells[row];
        if (!std::regex_match(cell, number)) continue;
        const bool comma = cell.find(',') != std::string::npos;
        Sample& sample = comma ? comma_ : point_;
        if (sample.text.empty()) sample = {place(file, file.lines[row], column), cell};
        certain_ = certain_ || !std::regex_match(cell, perhaps_thousands);
      }
  }

  char mark() const {
    const std::string way_out = "; write the mark in the parameter \"decimal mark\"";
    if (!comma_.text.empty() && !point_.text.empty())
      throw InputError(point_.place + "\"" + point_.text + "\" has a point, but " + comma_.place + "\"" + comma_.text +
                       "\" has a comma: write all numbers with one decimal mark, and without "
                       "thousands separators");
    const Sample& only = comma_.text.empty() ? point_ : comma_;
    // Where commas separate the columns, a point is decimal: who writes decimal commas cannot write so.
    const bool open = !only.text.empty() && !certain_ && !(file_.separator == ',' && comma_.text.empty());
    if (open)
      throw InputError(only.place + "\"" + only.text + "\" and all other numbers could have a thousands separator " +
                       "as well as a decimal mark" + way_out);
    return comma_.text.empty() ? '.' : ',';
  }

 private:
  const CsvFile& file_;
  Sample point_, comma_;
  bool certain_ = false;  ///< a number that cannot have a thousands separator was seen
};

}  // namespace

CsvFile read_csv(const std::string& path, const std::string& decimal_mark) {
  if (const std::string why = unreadable(path); !why.empty())
    throw InputError("cannot read the data file " + path + ": " + why);
  const std::string text = read_file(path, "a CSV file", most_csv_bytes);
  if (text.find('\0') != std::string::npos)
    throw InputError(path + ": this is no text, or UTF-16 text; save it as CSV in UTF-8");
  std::istringstream stream(text);
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
  if (file.title_line == 0) throw InputError(path + ": the file has no line of titles");
  file.decimal_mark = decimal_mark == "found" ? DecimalMark(file).mark() : decimal_mark == "comma" ? ',' : '.';
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
    std::string text = cell;
    if (file.decimal_mark == ',')
      for (char& c : text) c = c == ',' ? '.' : c == '.' ? ',' : c;  // a point is then no part of a number
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + (text.size() > 1 && text[0] == '+'), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      throw InputError(place(file, file.lines[row], column) +
                       (cell.empty() ? "the cell is empty" : "\"" + cell + "\"") +
                       ", expected a finite number with a decimal " + (file.decimal_mark == ',' ? "comma" : "point"));
    values.push_back(value);
  }
  return values;
}

}  // namespace toile::base
