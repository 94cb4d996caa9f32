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

// So is the table of fields in the user guide.
TEST_F(Reference, FieldsAreThoseOfTheProgram) {
  std::ostringstream guide;
  guide << std::ifstream(TOILE_SOURCE_DIR "/doc/user-guide.md").rdbuf();
  const Outcome describe = toile("describe fields --markdown");
  EXPECT_EQ(describe.status, 0);
  EXPECT_TRUE(guide.str().find("\n\n" + describe.out + "\n") != std::string::npos)
      << "put it in doc/user-guide.md: toile describe fields --markdown";
}

}  // namespace
}  // namespace toile::test
