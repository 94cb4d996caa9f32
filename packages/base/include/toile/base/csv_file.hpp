#pragma once

#include <string>
#include <vector>

namespace toile::base {

/// One column of a CSV file with its title taken apart: "name [unit]".
struct CsvColumn {
  std::string name, unit;
  int number;  ///< counts from 1
  bool has_unit = false;
  std::vector<std::string> cells;
};

/// The file as text; rows of numbers are parsed by those who need them.
struct CsvFile {
  std::string path;
  int title_line = 0;
  char separator = ',';     ///< of the columns: comma, semicolon or tab
  char decimal_mark = '.';  ///< in numbers: point or comma
  std::vector<int> lines;   ///< of each row, counted from 1
  std::vector<CsvColumn> columns;
};

/// Reads a CSV file. Columns are separated by what separates the titles: semicolons if there is one, else tabs, else
/// commas; a cell in double quotes may hold them. `decimal_mark`: "point", "comma", or "found": as the numbers show it.
/// Throws InputError if the file cannot be read, has no line of titles, a row has another number of cells, or the
/// numbers do not show their decimal mark: some have a point and others a comma, or all could have thousands separators
/// ("1.234").
CsvFile read_csv(const std::string& path, const std::string& decimal_mark = "found");

/// "path, line 4, column 2 "force": "
std::string place(const CsvFile& file, int line, const CsvColumn& column);

/// The numbers of a column. Throws InputError at a cell that is empty or not a finite number.
std::vector<double> numbers(const CsvFile& file, const CsvColumn& column);

}  // namespace toile::base
