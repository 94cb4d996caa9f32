#include "file_access.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "toile/base/error.hpp"

namespace toile::result {

void check_access(const std::string& path, const char* mode, const std::string& failure) {
  std::FILE* probe = std::fopen(path.c_str(), mode);
  if (probe == nullptr) {
    throw base::InputError(failure + std::strerror(errno));
  }
  std::fclose(probe);
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
}

}  // namespace toile::result
