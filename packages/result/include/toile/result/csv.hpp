#pragma once

#include <string>
#include <utility>
#include <vector>

#include "toile/result/field_name.hpp"

namespace toile::result {

struct Column {
  FieldName name;
  std::vector<double> values;
};

/// Columns of equal length, optionally with a text in front of each row and one behind it: if these have a title, or
/// there are some.
struct Table {
  std::string row_title;
  std::vector<std::string> row_names;  ///< empty: none
  std::vector<Column> columns;
  std::string text_title = {};
  std::vector<std::string> texts = {};  ///< empty: none
  /// Further texts in front of each row, behind its name: title and a text a row.
  std::vector<std::pair<std::string, std::vector<std::string>>> more_names = {};
};

/// Comma-separated values with one header line, "name [unit]", and 10 significant digits (`digits` of them if told: 17
/// tell a number exactly); a value that is not a number is an empty cell. Throws InputError if the file cannot be
/// written.
void write_csv(const std::string& path, const Table& table, int digits = 10);

}  // namespace toile::result
