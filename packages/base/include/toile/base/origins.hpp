#pragma once

#include <map>
#include <string>
#include <utility>

namespace toile::base {

/// Which file each list and parameter of the input was written in, by its path ("scene > Panels > front").
class Origins {
 public:
  explicit Origins(std::string file) : file_(std::move(file)) {}

  /// The file that wrote `path`; the scene's own file for what is not noted.
  const std::string& of(const std::string& path) const {
    const auto found = files_.find(path);
    return found == files_.end() ? file_ : found->second;
  }
  void note(const std::string& path, const std::string& file) { files_[path] = file; }

 private:
  std::string file_;
  std::map<std::string, std::string> files_;
};

}  // namespace toile::base
