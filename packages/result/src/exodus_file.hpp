#pragma once

#include <exodusII.h>

#include <string>
#include <vector>

namespace toile::result {

/// A new Exodus file, in netCDF's classic format (see ExodusStep). Every failing call throws InputError with path and
/// reason.
class ExodusFile {
 public:
  /// In place of the file that is there.
  static ExodusFile create(const std::string& path);
  ExodusFile(ExodusFile&& other) noexcept;
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;
  ~ExodusFile();

  int id() const { return id_; }
  /// `status`: return value of an Exodus function.
  void check(int status, const char* action) const;
  void put_variable_names(ex_entity_type type, const std::vector<std::string>& names) const;
  /// Closes the file and reports what only then goes wrong (a full disk).
  void close();

 private:
  ExodusFile(std::string path, int id) : path_(std::move(path)), id_(id) {}

  std::string path_;
  int id_;
};

/// Pointers to the texts, for interfaces in C that do not declare them constant.
std::vector<char*> pointers(const std::vector<std::string>& texts);

}  // namespace toile::result
