#pragma once

#include <string>
#include <vector>

namespace toile::material {

/// How this Toile was compiled, as CMake knows it (toolchain.cpp.in).
struct Toolchain {
  std::string compiler;
  std::vector<std::string> flags;
  std::vector<std::string> include_folders;
  std::string version;  ///< of Toile, with a hash of the headers that make the interface
};

const Toolchain& toolchain();

}  // namespace toile::material
