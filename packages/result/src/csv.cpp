#include "toile/result/csv.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "toile/result/replace_file.hpp"

namespace toile::result {
namespace {

/// Quoted where commas or quotes need it (RFC 4180).
std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter;
    if (letter == '"') {
      quoted += letter;
    }
  }
  return quoted + '"';
}

std::string header(const FieldName& name) {
  return cell(name.unit.empty() ? name.name : name.name + " [" + name.unit + "]");
}

void write_header(std::ostream& out, const Table& table) {
  const char* separator = "";
  if (!table.row_names.empty() || !table.row_title.empty()) {
    out << cell(table.row_title);
    separator = ",";
  }
  for (const auto& [title, texts] : table.more_names) {
    out << separator << cell(title);
    separator = ",";
  }
  for (const Column& column : table.columns) {
    out << separator << header(column.name);
    separator = ",";
  }
  if (!table.texts.empty() || !table.text_title.empty()) {
    out << separator << cell(table.text_title);
  }
  out << '\n';
}

void write_row(std::ostream& out, const Table& table, std::size_t row) {
  const char* separator = "";
  if (!table.row_names.empty()) {
    out << cell(table.row_names[row]);
    separator = ",";
  }
  for (const auto& [title, texts] : table.more_names) {
    out << separator << cell(texts[row]);
    separator = ",";
  }
  for (const Column& column : table.columns) {
    out << separator;
    if (std::isfinite(column.values[row])) {
      out << column.values[row];
    }
    separator = ",";
  }
  if (!table.texts.empty()) {
    out << separator << cell(table.texts[row]);
  }
  out << '\n';
}

}  // namespace

void write_csv(const std::string& path, const Table& table, int digits) {
  std::ostringstream out;
  out << std::setprecision(digits);
  write_header(out, table);
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().values.size();
  for (std::size_t row = 0; row < rows; ++row) {
    write_row(out, table, row);
  }
  replace_file(path, out.str(), "cannot write the table '" + path + "': ");
}

}  // namespace toile::result
