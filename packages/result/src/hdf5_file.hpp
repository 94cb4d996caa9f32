#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

namespace toile::result {

/// An HDF5 object, released at the end of the scope.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), closer_(other.closer_) { other.id_ = -1; }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle();
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*closer_)(hid_t);
};

/// A file; every failing call throws InputError that starts with `failure`.
class Hdf5File {
 public:
  /// A new file in memory, whose bytes image() gives: HDF5 itself can crash on a full disk, and does not say that it
  /// is.
  static Hdf5File in_memory(const std::string& failure);
  /// Of bytes that image() gave, to read.
  static Hdf5File of_image(const std::string& bytes, const std::string& failure);

  hid_t id() const { return handle_.id(); }
  /// Takes the result of an HDF5 function that opens or creates something.
  Hdf5Handle own(hid_t id, herr_t (*closer)(hid_t), const std::string& what) const;
  void check(herr_t status, const std::string& what) const;
  /// The file as it is to be written to disk.
  std::string image() const;

  void put_text_attribute(hid_t object, const char* name, const std::string& value) const;
  /// Names of the links in a group, in alphabetical order.
  std::vector<std::string> names(hid_t group) const;

 private:
  Hdf5File(Hdf5Handle handle, std::string failure) : handle_(std::move(handle)), failure_(std::move(failure)) {}

  Hdf5Handle handle_;
  std::string failure_;
};

/// Fixed-length text type; at least one character, as HDF5 wants.
hid_t text_type(std::size_t length);

}  // namespace toile::result
