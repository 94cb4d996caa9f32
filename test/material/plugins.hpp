#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "toile/material/plugin_files.hpp"

namespace toile::material::test {

/// A folder that is removed with this.
class Folder {
 public:
  Folder() : path_((std::filesystem::temp_directory_path() / "toile-plugin-XXXXXX").string()) {
    if (mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }

 private:
  std::string path_;
};

/// The law of input/fabrics/<name>.cpp, compiled once a process.
inline Laws::Law shipped_law(const std::string& name) {
  const Folder folder;
  const PlugInBuild build =
      build_plugin(TOILE_SOURCE_DIR "/input/fabrics/" + name + ".cpp", folder.file(name + ".so"), true);
  if (!build.good) throw std::runtime_error(build.command + "\n" + build.messages);
  return load_plugin(folder.file(name + ".so"));
}

}  // namespace toile::material::test
