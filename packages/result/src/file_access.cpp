#include "file_access.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "toile/base/error.hpp"

namespace toile::result {

void check_access(const std::string& path, const std::string& failure, bool to_write) {
  const int probe = open(path.c_str(), (to_write ? O_RDWR | O_NOFOLLOW : O_RDONLY) | O_NONBLOCK | O_CLOEXEC);
  if (probe < 0) {
    throw base::InputError(failure + std::strerror(errno));
  }
  close(probe);
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);
}

}  // namespace toile::result
