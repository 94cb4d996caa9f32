#pragma once

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace toile::pattern::test {

/// A file that is removed at the end of the scope.
class Scratch {
 public:
  explicit Scratch(const std::string& ending, const std::string& content = "") {
    static int number = 0;
    path_ = "pattern_test." + std::to_string(getpid()) + "." + std::to_string(number++) + ending;
    std::ofstream(path_) << content;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::remove(path_.c_str()); }

  const std::string& path() const { return path_; }
  std::string content() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }

 private:
  std::string path_;
};

}  // namespace toile::pattern::test
