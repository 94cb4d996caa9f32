#include "toile/result/history.hpp"

#include "hdf5_file.hpp"
#include "toile/base/error.hpp"

namespace toile::result {

History::History(const std::string& path, const std::vector<FieldName>& columns) : path_(path), columns_(columns) {
  Hdf5File file = Hdf5File::create(path, "cannot create the history file '" + path + "': ");
  const hsize_t none = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const hsize_t chunk = 256;
  const Hdf5Handle space = file.own(H5Screate_simple(1, &none, &unlimited), H5Sclose, "the columns");
  const Hdf5Handle layout = file.own(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "the columns");
  file.check(H5Pset_chunk(layout.id(), 1, &chunk), "the columns");
  for (const FieldName& column : columns) {
    const Hdf5Handle data = file.own(
        H5Dcreate2(file.id(), column.name.c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
        H5Dclose, "column '" + column.name + "'");
    file.put_text_attribute(data.id(), "unit", column.unit);
  }
  file.close();
}

void History::append(const std::vector<double>& row) {
  if (row.size() != columns_.size()) {
    throw base::Error(base::ExitCode::internal_error, "a row of the history file '" + path_ + "' has " +
                                                          std::to_string(row.size()) + " values instead of " +
                                                          std::to_string(columns_.size()));
  }
  Hdf5File file = Hdf5File::open(path_, H5F_ACC_RDWR, "cannot write to the history file '" + path_ + "': ");
  const auto start = static_cast<hsize_t>(rows_);
  const hsize_t one = 1;
  const hsize_t size = start + one;
  const Hdf5Handle value = file.own(H5Screate_simple(1, &one, nullptr), H5Sclose, "a row");
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string what = "column '" + columns_[i].name + "'";
    const Hdf5Handle data = file.own(H5Dopen2(file.id(), columns_[i].name.c_str(), H5P_DEFAULT), H5Dclose, what);
    file.check(H5Dset_extent(data.id(), &size), what);
    const Hdf5Handle place = file.own(H5Dget_space(data.id()), H5Sclose, what);
    file.check(H5Sselect_hyperslab(place.id(), H5S_SELECT_SET, &start, nullptr, &one, nullptr), what);
    file.check(H5Dwrite(data.id(), H5T_NATIVE_DOUBLE, value.id(), place.id(), H5P_DEFAULT, &row[i]), what);
  }
  file.close();
  ++rows_;
}

}  // namespace toile::result
