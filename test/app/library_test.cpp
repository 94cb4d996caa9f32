// The example of the library, as its user runs it.
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "program.hpp"

namespace toile::test {
namespace {

class Library : public ProgramTest {
 protected:
  /// Runs the example.
  Outcome example(const std::string& arguments) const {
    const std::string command = "cd '" + path("") + "' && '" TOILE_EXAMPLE "' " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out.txt"), read("err.txt")};
  }
};

// The example's pressure of a tube on a cylinder is that of a membrane, within the error that it tells, which is small.
TEST_F(Library, ExampleReadsAPressure) {
  const Outcome run = example(TOILE_SOURCE_DIR "/examples/tube.xml out");
  EXPECT_EQ(run.status, 0) << run.err;
  double pressure = 0.0, error = 0.0;
  ASSERT_EQ(std::sscanf(run.out.c_str(), "middle: %lf +- %lf kPa", &pressure, &error), 2) << run.out;
  const double stretch = 1.2,
               exact = 1e3 * 2.0 * 0.02 * (stretch * stretch - 1.0 / stretch) / (60.0 * std::sqrt(stretch));
  EXPECT_LE(std::abs(pressure - exact), error);
  EXPECT_LE(error, 0.01 * exact);
  EXPECT_TRUE(exists("out/results.exo"));
}

// The example refuses a scene with the message of the program, and leaves no folder of results.
TEST_F(Library, ExampleRefusesAScene) {
  write("scene.xml", "<ParameterList name=\"scene\"/>");
  const Outcome run = example("scene.xml out");
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ("toile: " + run.err, toile("run scene.xml").err);
  EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace toile::test
