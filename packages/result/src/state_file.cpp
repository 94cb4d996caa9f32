#include "toile/result/state_file.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "file_access.hpp"
#include "hdf5_file.hpp"
#include "toile/base/error.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::result {
namespace {

constexpr int format_version = 2;

/// How one kind of value is stored.
struct Kind {
  const char* group;
  hid_t stored;
  hid_t memory;
};

Kind kind_of(double) {
  return {"reals", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE};
}
Kind kind_of(int) {
  return {"integers", H5T_STD_I32LE, H5T_NATIVE_INT};
}

Hdf5Handle create_group(const Hdf5File& file, const char* name) {
  return file.own(H5Gcreate2(file.id(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name);
}

Hdf5Handle open_group(const Hdf5File& file, const char* name) {
  return file.own(H5Gopen2(file.id(), name, H5P_DEFAULT), H5Gclose, name);
}

Hdf5Handle create_dataset(const Hdf5File& file, hid_t group, const std::string& name, hid_t type, hid_t space) {
  if (name.empty() || name.find('/') != std::string::npos) {
    throw base::Error(base::ExitCode::internal_error, "'" + name + "' cannot be the name of an array of a state");
  }
  return file.own(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose, name);
}

template <class T>
void put_arrays(const Hdf5File& file, const std::map<std::string, std::vector<T>>& arrays) {
  const Kind kind = kind_of(T());
  const Hdf5Handle group = create_group(file, kind.group);
  for (const auto& [name, values] : arrays) {
    const hsize_t size = values.size();
    const Hdf5Handle space = file.own(H5Screate_simple(1, &size, nullptr), H5Sclose, name);
    const Hdf5Handle data = create_dataset(file, group.id(), name, kind.stored, space.id());
    file.check(H5Dwrite(data.id(), kind.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  }
}

template <class T>
std::map<std::string, std::vector<T>> get_arrays(const Hdf5File& file) {
  const Kind kind = kind_of(T());
  const Hdf5Handle group = open_group(file, kind.group);
  std::map<std::string, std::vector<T>> arrays;
  for (const std::string& name : file.names(group.id())) {
    const Hdf5Handle data = file.own(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, name);
    const Hdf5Handle space = file.own(H5Dget_space(data.id()), H5Sclose, name);
    std::vector<T>& values = arrays[name];
    values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    file.check(H5Dread(data.id(), kind.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
  }
  return arrays;
}

void put_metadata(const Hdf5File& file, const std::map<std::string, std::string>& metadata) {
  const Hdf5Handle group = create_group(file, "metadata");
  const Hdf5Handle space = file.own(H5Screate(H5S_SCALAR), H5Sclose, "metadata");
  for (const auto& [name, text] : metadata) {
    const Hdf5Handle type = file.own(text_type(text.size()), H5Tclose, name);
    const Hdf5Handle data = create_dataset(file, group.id(), name, type.id(), space.id());
    file.check(H5Dwrite(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), name);
  }
}

std::map<std::string, std::string> get_metadata(const Hdf5File& file) {
  const Hdf5Handle group = open_group(file, "metadata");
  std::map<std::string, std::string> metadata;
  for (const std::string& name : file.names(group.id())) {
    const Hdf5Handle data = file.own(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, name);
    const Hdf5Handle type = file.own(H5Dget_type(data.id()), H5Tclose, name);
    std::string text(H5Tget_size(type.id()), '\0');
    file.check(H5Dread(data.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), name);
    metadata[name] = text.substr(0, text.find_last_not_of('\0') + 1);
  }
  return metadata;
}

/// The first bytes of the file, before those of HDF5, which skips them: kind, version, and what proves the rest whole.
constexpr std::size_t seal_size = 512;
constexpr const char* seal_start = "Toile state ";

std::string checksum(const std::string& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  std::ostringstream out;
  out << std::hex << std::setw(8) << std::setfill('0') << crc.checksum();
  return out.str();
}

std::string sealed(const std::string& image) {
  std::string seal = seal_start + std::to_string(format_version) + " bytes " + std::to_string(image.size()) +
                     " CRC-32 " + checksum(image) + "\n";
  seal.resize(seal_size, ' ');
  seal.back() = '\n';
  return seal + image;
}

std::string content_of(const std::string& path, const std::string& failure) {
  check_access(path, failure);
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The bytes of HDF5, if they are those that were written.
std::string unsealed(const std::string& content, const std::string& failure) {
  std::istringstream seal(content.substr(0, std::min(seal_size, content.size())));
  std::string word, sum;
  int version = 0;
  std::size_t size = 0;
  seal >> word >> word >> version;
  if (content.compare(0, std::strlen(seal_start), seal_start) != 0 || !seal)
    throw base::InputError(failure + "it is not a state that Toile wrote");
  if (version != format_version)
    throw base::InputError(failure + "its format is version " + std::to_string(version) + ", this program reads " +
                           std::to_string(format_version));
  seal >> word >> size >> word >> sum;
  const std::size_t found = content.size() - std::min(seal_size, content.size());
  if (!seal || found < size)
    throw base::InputError(failure + "it was cut off: " + std::to_string(found) + " of " + std::to_string(size) +
                           " bytes are there");
  std::string image = content.substr(seal_size);
  if (found > size || checksum(image) != sum)
    throw base::InputError(failure + "it is damaged: its bytes do not have the checksum with which they were written");
  return image;
}

}  // namespace

void write_state(const std::string& path, const StateData& state) {
  const std::string failure = "cannot write the state file '" + path + "': ";
  const Hdf5File file = Hdf5File::in_memory(failure);
  put_arrays(file, state.reals);
  put_arrays(file, state.integers);
  put_metadata(file, state.metadata);
  replace_file(path, sealed(file.image()), failure);
}

StateData read_state(const std::string& path) {
  const std::string failure = "cannot read the state file '" + path + "': ";
  const Hdf5File file = Hdf5File::of_image(unsealed(content_of(path, failure), failure), failure);
  StateData state;
  state.reals = get_arrays<double>(file);
  state.integers = get_arrays<int>(file);
  state.metadata = get_metadata(file);
  return state;
}

}  // namespace toile::result
