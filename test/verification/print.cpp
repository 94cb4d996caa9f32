#include "verification/print.hpp"

#include <Tpetra_Core.hpp>
#include <cstdarg>
#include <cstdio>

namespace toile::test {

void print(const char* format, ...) {
  if (Tpetra::getDefaultComm()->getRank() != 0) return;
  va_list arguments;
  va_start(arguments, format);
  std::vprintf(format, arguments);
  va_end(arguments);
}

}  // namespace toile::test
