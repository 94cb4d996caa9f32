// To be loaded before the C library (LD_PRELOAD): a disk on which files below a folder "out" find TOILE_DISK_BYTES of
// space.
#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" ssize_t write(int file, const void* data, size_t size) {
  using Write = ssize_t (*)(int, const void*, size_t);
  static const auto next = reinterpret_cast<Write>(dlsym(RTLD_NEXT, "write"));
  static size_t used = 0;
  const char* space = std::getenv("TOILE_DISK_BYTES");
  char link[64], path[4096] = {};
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  if (space != nullptr && readlink(link, path, sizeof path - 1) > 0 && std::strstr(path, "/out/") != nullptr) {
    used += size;
    if (used > std::strtoull(space, nullptr, 10)) {
      errno = ENOSPC;
      return -1;
    }
  }
  return next(file, data, size);
}
