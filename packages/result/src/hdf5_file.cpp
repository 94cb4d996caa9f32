#include "hdf5_file.hpp"

#include <algorithm>
#include <utility>

#include "toile/base/error.hpp"

namespace toile::result {
namespace {

/// HDF5 prints a stack for each failing call unless it is told not to; our errors are exceptions.
void print_no_stacks() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace

Hdf5Handle::~Hdf5Handle() {
  if (id_ >= 0) {
    closer_(id_);
  }
}

Hdf5File Hdf5File::in_memory(const std::string& failure) {
  constexpr std::size_t growth = 1U << 16U;
  print_no_stacks();
  const Hdf5Handle driver(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(driver.id(), growth, false);
  Hdf5Handle handle(H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, driver.id()), H5Fclose);
  if (!handle.valid()) {
    throw base::InputError(failure + "HDF5 could not create it");
  }
  return {std::move(handle), failure};
}

Hdf5File Hdf5File::of_image(const std::string& bytes, const std::string& failure) {
  constexpr std::size_t growth = 1U << 16U;
  print_no_stacks();
  const Hdf5Handle driver(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(driver.id(), growth, false);
  std::string copy = bytes;  // HDF5 asks for one that it could change
  H5Pset_file_image(driver.id(), copy.data(), copy.size());
  Hdf5Handle handle(H5Fopen("memory", H5F_ACC_RDONLY, driver.id()), H5Fclose);
  if (!handle.valid()) {
    throw base::InputError(failure + "it is not a complete HDF5 file");
  }
  return {std::move(handle), failure};
}

Hdf5Handle Hdf5File::own(hid_t id, herr_t (*closer)(hid_t), const std::string& what) const {
  check(id < 0 ? -1 : 0, what);
  return {id, closer};
}

void Hdf5File::check(herr_t status, const std::string& what) const {
  if (status < 0) {
    throw base::InputError(failure_ + "HDF5 failed at " + what);
  }
}

std::string Hdf5File::image() const {
  check(H5Fflush(id(), H5F_SCOPE_GLOBAL), "laying it out");
  const ssize_t size = H5Fget_file_image(id(), nullptr, 0);
  check(size < 0 ? -1 : 0, "laying it out");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(id(), bytes.data(), bytes.size()) < 0 ? -1 : 0, "laying it out");
  return bytes;
}

void Hdf5File::put_text_attribute(hid_t object, const char* name, const std::string& value) const {
  const Hdf5Handle type = own(text_type(value.size()), H5Tclose, name);
  const Hdf5Handle space = own(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Hdf5Handle attribute =
      own(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  check(H5Awrite(attribute.id(), type.id(), value.c_str()), name);
}

std::vector<std::string> Hdf5File::names(hid_t group) const {
  H5G_info_t info{};
  check(H5Gget_info(group, &info), "reading the names");
  std::vector<std::string> result;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto get = [&](char* text, std::size_t size) {
      return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size, H5P_DEFAULT);
    };
    std::string name(static_cast<std::size_t>(std::max<ssize_t>(get(nullptr, 0), 0)), ' ');
    check(get(name.data(), name.size() + 1) < 0 ? -1 : 0, "reading the names");
    result.push_back(std::move(name));
  }
  return result;
}

hid_t text_type(std::size_t length) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, std::max<std::size_t>(length, 1));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

}  // namespace toile::result
