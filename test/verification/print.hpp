#pragma once

namespace toile::test {

/// printf on the first rank only: the rows of doc/verification.md.
void print(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace toile::test
