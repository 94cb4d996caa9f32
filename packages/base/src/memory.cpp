#include "toile/base/memory.hpp"

#include <sys/resource.h>

namespace toile::base {

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;  // Linux counts in KiB
}

}  // namespace toile::base
