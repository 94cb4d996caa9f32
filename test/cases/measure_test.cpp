#include <nlohmann/json.hpp>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class Measure : public ProgramTest {
 protected:
  /// A square prism of 100 mm that stands at x = 0, 400 mm high.
  void write_block() {
    write("block.obj",
          "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 0 0 400\nv 100 0 400\nv 100 100 400\nv 0 100 400\n"
          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  }
  const std::string woman_ = "'" TOILE_SOURCE_DIR "/input/bodies/female_body.obj'";
};

// A block's volume, girth and lengths are told in mm and cm, and its sections as a table.
TEST_F(Measure, Block) {
  write_block();
  const Outcome outcome =
      toile("body measure block.obj --at 150 --at 250.5 --length 50,0,100 50,100,100 --csv sections.csv");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("x 0.0 to 100.0, y 0.0 to 100.0, z 0.0 to 400.0 mm\nvolume     4.000 litres"));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("150 +400.0 +40.00 +400.0 +40.00 +100.0 +50.0, 50.0, 150.0\n"));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("50,0,100 to 50,100,100 +100.0 +10.00 +200.0 +20.00\n"));
  EXPECT_THAT(read("sections.csv"), HasSubstr("section,tape girth [mm],perimeter [mm],area [mm^2],x [mm],y [mm],z [mm],"
                                              "closed\n150,400,400,10000,50,50,150,1\n"));
}

// At a landmark the piece that belongs to it is measured; with a plane of one's own too; at a height all pieces are.
TEST_F(Measure, Woman) {
  const Outcome outcome =
      toile("body measure " + woman_ + " --at waist --at 'left thigh' --at 'hip + 20' --at 500 --length neck crotch");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("\nwaist +639.7 +63.97 "));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("\nleft thigh +52[0-9.]+ "));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("\nhip \\+ 20 +8[0-9.]+ "));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("\n500 \\(1\\) +33[0-9.]+ "));
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("\n500 \\(2\\) +33[0-9.]+ "));
}

// The landmarks are printed and written as JSON.
TEST_F(Measure, LandmarksAsJson) {
  const Outcome outcome = toile("body landmarks " + woman_ + " --json marks.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::ContainsRegex("\nwaist +0.0 +-5[0-9.]+ +102[0-9.]+ +639.7 +64.0\n"));
  const auto json = nlohmann::json::parse(read("marks.json"));
  EXPECT_NEAR(json.at("landmarks").at("waist").at("girth").get<double>(), 639.7, 0.5);
  EXPECT_EQ(json.at("landmarks").at("left bust point").at("point").size(), 3u);
  EXPECT_TRUE(json.at("not found").empty());
}

// What cannot be measured is refused with the reason and the nearest name.
TEST_F(Measure, Refusals) {
  write_block();
  const auto expect = [this](const std::string& arguments, const std::string& message) {
    const Outcome outcome = toile("body measure " + arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(message));
  };
  expect("block.obj --at 500", "--at 500: the plane misses the body");
  expect("block.obj --at 1,2", "\"1,2\" has 2 numbers; a place is a height z, a point x,y,z or a landmark");
  expect("block.obj --at weist", "no landmark is named \"weist\"; did you mean \"waist\"?");
  expect("block.obj --at crotch", "the landmark \"crotch\" was not found on the body: no height was found");
  expect("block.obj --length 100 200", "--length: \"100\" is a height; a length is between points");
  expect("block.obj --at 100 --normal 0,0,0", "--normal must not be zero");
  expect("block.obj --csv out.csv", "--csv writes the sections, and --at asks for none");
  expect("none.obj --at 100", "none.obj");
}

}  // namespace
}  // namespace toile::test
