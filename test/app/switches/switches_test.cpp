// A program that was built with a package switched off.
#include "app/program.hpp"

namespace toile::test {
namespace {

using Switches = ProgramTest;

// A scene that needs a body is refused by a build without bodies, and solved by one that has them.
TEST_F(Switches, BodyIsRefusedIfItWasLeftOut) {
  write_scene("sleeve");
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, TOILE_HAS_BODY ? 0 : 2) << run.err;
  const char* refusal =
      "scene.xml: scene > Body: parameter \"type\" = \"cylinder\": this build of Toile has no bodies and no contact "
      "(configured with TOILE_ENABLE_BODY=OFF)";
  EXPECT_EQ(run.err.find(refusal) == std::string::npos, TOILE_HAS_BODY) << run.err;
}

// A scene without a body is solved by every build, which says so if it writes tables only.
TEST_F(Switches, TensileSceneIsSolved) {
  write_scene("strip");
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(exists("results/scene/force-curves.csv"));
  EXPECT_EQ(exists("results/scene/results.exo"), TOILE_HAS_RESULT);
  EXPECT_EQ(run.err.find("TOILE_ENABLE_RESULT=OFF") == std::string::npos, TOILE_HAS_RESULT);
}

// A report that cannot be written is refused before anything is solved.
TEST_F(Switches, ReportIsRefusedIfItWasLeftOut) {
  write_scene("strip");
  const bool can = TOILE_HAS_REPORT && TOILE_HAS_RESULT;
  const Outcome run = toile("run scene.xml --report");
  EXPECT_EQ(run.status, can ? 0 : 2) << run.err;
  EXPECT_EQ(exists("results/scene/report.html"), can);
  EXPECT_EQ(exists("results/scene/force-curves.csv"), can);
}

}  // namespace
}  // namespace toile::test
