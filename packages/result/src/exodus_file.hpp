#pragma once

#include <exodusII.h>

#include <string>
#include <vector>

namespace toile::result {

/// An open Exodus file, closed at the end of the scope. Every failing call throws InputError with path and reason.
class ExodusFile {
 public:
  static ExodusFile create(const std::string& path);
  static ExodusFile open(const std::string& path);
  ExodusFile(ExodusFile&& other) noexcept;
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;
  ~ExodusFile();

  int id() const { return id_; }
  /// `status`: return value of an Exodus function.
  void check(int status, const char* action) const;
  void put_variable_names(ex_entity_type type, const std::vector<std::string>& names) const;
  /// `index` counts from 1.
  void put_variable(int step, ex_entity_type type, int index, int object, const std::vector<double>& values) const;
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
