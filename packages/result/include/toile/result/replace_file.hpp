#pragma once

#include <string>

namespace toile::result {

/// A file that is written beside the one whose place it takes, and takes it when it is complete and on disk: whoever
/// looks sees the older file or the new one, after a kill too. Its name is `path` with ".new"; what lies there, a link
/// to another file for instance, is removed and not followed. Every call throws InputError `failure` + reason; the
/// older file is then untouched.
class Replacement {
 public:
  /// Creates it, empty.
  Replacement(const std::string& path, const std::string& failure);
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  /// Removes it unless it took its place.
  ~Replacement();

  /// For libraries that write by a file's name.
  const std::string& path() const { return new_path_; }
  void write(const std::string& content);
  void take_place();

 private:
  std::string path_, new_path_, failure_;
  int descriptor_ = -1;
};

/// Puts `content` in the place of the file `path`, all of it or nothing; see Replacement.
void replace_file(const std::string& path, const std::string& content, const std::string& failure);

/// Throws InputError `failure` + reason if a file `path` could not take the place of what is there now: a folder, or
/// another user's file in a folder where each may remove his own only.
void check_replaceable(const std::string& path, const std::string& failure);

/// Removes a file if it is there; a link, not what it leads to. Throws InputError `failure` + reason.
void remove_file(const std::string& path, const std::string& failure);

}  // namespace toile::result
