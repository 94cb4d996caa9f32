#include "toile/result/history.hpp"

#include "hdf5_file.hpp"
#include "toile/base/error.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::result {

History::History(const std::string& path, const std::vector<FieldName>& columns)
    : path_(path), columns_(columns), values_(columns.size()) {}

void History::add(const std::vector<double>& row) {
  if (row.size() != columns_.size()) {
    throw base::Error(base::ExitCode::internal_error, "a row of the history file '" + path_ + "' has " +
                                                          std::to_string(row.size()) + " values instead of " +
                                                          std::to_string(columns_.size()));
  }
  for (std::size_t i = 0; i < row.size(); ++i) {
    values_[i].push_back(row[i]);
  }
  ++rows_;
}

void History::append(const std::vector<double>& row) {
  add(row);
  write();
}

void History::restore(const std::vector<std::vector<double>>& rows) {
  for (const std::vector<double>& row : rows) {
    add(row);
  }
  write();
}

void History::write() const {
  const std::string failure = "cannot write the history file '" + path_ + "': ";
  const Hdf5File file = Hdf5File::in_memory(failure);
  const auto size = static_cast<hsize_t>(rows_);
  const Hdf5Handle space = file.own(H5Screate_simple(1, &size, nullptr), H5Sclose, "the columns");
  const Hdf5Handle timeless = file.own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "the columns");
  H5Pset_obj_track_times(timeless.id(), false);  // the same rows are the same file
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string what = "column '" + columns_[i].name + "'";
    const Hdf5Handle data = file.own(H5Dcreate2(file.id(), columns_[i].name.c_str(), H5T_IEEE_F64LE, space.id(),
                                                H5P_DEFAULT, timeless.id(), H5P_DEFAULT),
                                     H5Dclose, what);
    file.put_text_attribute(data.id(), "unit", columns_[i].unit);
    file.check(H5Dwrite(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values_[i].data()), what);
  }
  replace_file(path_, file.image(), failure);
}

}  // namespace toile::result
