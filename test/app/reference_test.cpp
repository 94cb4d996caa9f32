#include <fstream>
#include <sstream>

#include "program.hpp"

namespace toile::test {
namespace {

using Reference = ProgramTest;

// doc/input-reference.md is what the program prints, so that it cannot drift.
TEST_F(Reference, IsWhatTheProgramPrints) {
  std::ostringstream committed;
  committed << std::ifstream(TOILE_SOURCE_DIR "/doc/input-reference.md").rdbuf();
  const Outcome describe = toile("describe --markdown");
  EXPECT_EQ(describe.status, 0);
  EXPECT_TRUE(committed.str() == describe.out) << "write it anew: toile describe --markdown > doc/input-reference.md";
}

}  // namespace
}  // namespace toile::test
