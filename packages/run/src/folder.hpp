#pragma once

#include <string>
#include <vector>

namespace toile::run {

/// The folder of a run's files. The first rank's alone.
class Folder {
 public:
  /// Makes it. `files`: every one that a run may write. Throws InputError if it cannot be written, or one of them
  /// cannot be replaced. `pictures`: whether plots are drawn in it.
  Folder(std::string path, std::vector<std::string> files, bool pictures = true);

  const std::string& path() const { return path_; }
  bool pictures() const { return pictures_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// A file of this run is in it.
  void add(const std::string& name);
  /// Names of the files of this run, in the order in which they were written.
  const std::vector<std::string>& written() const { return written_; }
  /// Removes what an earlier run left there. Throws InputError.
  void remove_older() const;

 private:
  std::string path_;
  std::vector<std::string> files_, written_;
  bool pictures_;
};

}  // namespace toile::run
