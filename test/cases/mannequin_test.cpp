#include <cmath>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class Mannequin : public ProgramTest {
 protected:
  /// Number behind the name at the start of a line of a table; nan if there is none.
  static double in_table(const std::string& table, const std::string& name, int column) {
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(name + "  ", 0) == 0) {
        std::istringstream cells(line.substr(name.size()));
        double value = std::nan("");
        for (int i = 0; i <= column; ++i) cells >> value;
        return value;
      }
    return std::nan("");
  }
  /// Makes a mannequin, and expects the girths (cm) that `body landmarks` finds on its file within 1 %.
  void expect_girths(const std::string& options, const std::vector<std::pair<std::string, double>>& girths) {
    const Outcome made = toile("body make --output body.obj --edge 14 " + options);
    ASSERT_EQ(made.status, 0) << made.err;
    const Outcome found = toile("body landmarks body.obj");
    ASSERT_EQ(found.status, 0) << found.err;
    for (const auto& [name, girth] : girths) {
      SCOPED_TRACE(options + ": " + name);
      EXPECT_NEAR(in_table(found.out, name, 4) / girth, 1.0, 0.01);
    }
  }
};

// Without a measurement it is the default body: closed, one piece, and every girth within 1 %.
TEST_F(Mannequin, Default) {
  expect_girths("", {{"neck", 31.0},
                     {"bust", 83.0},
                     {"underbust", 71.5},
                     {"waist", 64.0},
                     {"hip", 90.0},
                     {"left thigh", 52.0},
                     {"right thigh", 52.0},
                     {"left knee", 33.0},
                     {"left calf", 34.0},
                     {"right calf", 34.0},
                     {"left ankle", 20.5},
                     {"left upper arm", 25.5},
                     {"right wrist", 15.0}});
  const Outcome measured = toile("body measure body.obj --length 'left shoulder' 'right shoulder'");
  EXPECT_EQ(measured.status, 0) << measured.err;
  EXPECT_EQ(measured.err, "");  // nothing had to be repaired, no facets intersect
  EXPECT_THAT(measured.out, HasSubstr("pieces     1\n"));
  EXPECT_NEAR(in_table(measured.out, "left shoulder to right shoulder", 1) / 37.0, 1.0, 0.01);
}

// Other sizes are reached as well, and what is not given follows what is.
TEST_F(Mannequin, OtherSizes) {
  expect_girths("--bust 100 --waist 84 --hip 108", {{"bust", 100.0},
                                                    {"underbust", 71.5 / 83.0 * 100.0},
                                                    {"waist", 84.0},
                                                    {"hip", 108.0},
                                                    {"left thigh", 52.0 * 1.2}});
  expect_girths("--height 148 --bust 76 --waist 58 --hip 82", {{"bust", 76.0}, {"waist", 58.0}, {"hip", 82.0}});
  expect_girths("--height 172 --bust 92 --waist 70 --hip 98 --knee 35 --wrist 16",
                {{"bust", 92.0}, {"waist", 70.0}, {"hip", 98.0}, {"left knee", 35.0}, {"left wrist", 16.0}});
}

// Arms are turned to the angle that is asked for, and the girths are reached there too.
TEST_F(Mannequin, Arms) {
  expect_girths("--arms 30", {{"bust", 83.0}, {"waist", 64.0}, {"left upper arm", 25.5}, {"right upper arm", 25.5}});
  const Outcome found = toile("body landmarks body.obj");
  const double x = in_table(found.out, "left elbow", 0) - in_table(found.out, "left upper arm", 0);
  const double z = in_table(found.out, "left elbow", 2) - in_table(found.out, "left upper arm", 2);
  EXPECT_NEAR(std::atan2(-z, x) * 180.0 / M_PI, 30.0, 3.0);
}

// Measurements that no body has, or that contradict each other, and arms that would touch are refused with the reason,
// and nothing is written.
TEST_F(Mannequin, Refusals) {
  const auto expect = [this](const std::string& options, const std::string& message) {
    const Outcome outcome = toile("body make --edge 14 " + options);
    EXPECT_EQ(outcome.status, 2) << options;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_FALSE(exists("mannequin.obj"));
  };
  expect("--waist 200 --hip 60", "waist 200 cm (given): no body of 158 cm has it; allowed are 32 cm to 140.8 cm");
  expect("--waist 100",
         "waist 100 cm and hip 90 cm contradict each other: the waist is the smallest girth between hip "
         "and armpits; with this hip the waist is at most 88.2 cm");
  expect("--thigh 70", "thigh 70 cm and hip 90 cm contradict each other: two thighs have to fit below the hip");
  expect("--height 15.8", "height 15.8 cm: allowed are 100 cm to 230 cm");
  expect("--bust nan", "bust");
  expect("--arms 2", "the arms cannot be held 2 degrees below the level");
  expect("--arms 84", "the surface would pass through itself");
  expect("--output body.stl", "the file is written as OBJ, so its name ends in .obj");
  expect("--wiast 60", "unknown option of \"toile body make\" \"--wiast\"; did you mean \"--waist\"?");
}

}  // namespace
}  // namespace toile::test
