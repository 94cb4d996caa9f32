#pragma once

#include <string>
#include <vector>

#include "toile/result/field_name.hpp"

namespace toile::result {

/// Time histories in one HDF5 file: a one-dimensional dataset a column, named as the column, with the attribute "unit".
/// The file is closed between rows, so that it is complete after each of them.
class History {
 public:
  /// Creates the file, replacing an older one. Throws InputError if that is not possible.
  History(const std::string& path, const std::vector<FieldName>& columns);

  /// Appends one value to each column, in their order. Throws InputError if the file cannot be written,
  /// Error (internal) if the number of values is not that of the columns.
  void append(const std::vector<double>& row);

  int rows() const { return rows_; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::vector<FieldName> columns_;
  int rows_ = 0;
};

}  // namespace toile::result
