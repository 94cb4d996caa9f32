#pragma once

#include <string>
#include <vector>

namespace toile::identify {

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
  std::vector<int> lines;  ///< of each row, counted from 1
  std::vector<CsvColumn> columns;
};

/// Throws InputError if the file cannot be read, has no line of titles, or a row has another number of cells.
CsvFile read_csv(const std::string& path);

/// "path, line 4, column 2 "force": "
std::string place(const CsvFile& file, int line, const CsvColumn& column);

/// The numbers of a column. Throws InputError at a cell that is empty or not a finite number.
std::vector<double> numbers(const CsvFile& file, const CsvColumn& column);

}  // namespace toile::identify
