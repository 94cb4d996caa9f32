#pragma once

#include <string>
#include <vector>

#include "toile/result/field_name.hpp"

namespace toile::result {

/// Time histories in one HDF5 file: a one-dimensional dataset a column, named as the column, with the attribute "unit".
/// It is replaced as a whole by each row (see Replacement), so that its columns are always complete.
class History {
 public:
  /// Writes nothing: an older file stays until there is a row.
  History(const std::string& path, const std::vector<FieldName>& columns);

  /// Appends one value to each column, in their order. Throws InputError if the file cannot be written,
  /// Error (internal) if the number of values is not that of the columns.
  void append(const std::vector<double>& row);
  /// Appends rows that an earlier file has, all at once.
  void restore(const std::vector<std::vector<double>>& rows);

  int rows() const { return rows_; }
  const std::string& path() const { return path_; }

 private:
  void add(const std::vector<double>& row);
  void write() const;

  std::string path_;
  std::vector<FieldName> columns_;
  std::vector<std::vector<double>> values_;  ///< [column][row]
  int rows_ = 0;
};

}  // namespace toile::result
