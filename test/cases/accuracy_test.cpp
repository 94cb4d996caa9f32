// Runs that go on until the error is as small as asked, and meshes on which it cannot be told.
#include "sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string file_body = R"(value="file"/>
    <Parameter name="file" type="string" value="body.obj"/>)",
                  cylinder = R"(value="cylinder"/>
    <Parameter name="radius" type="double" value="60.0"/>)";

class Accuracy : public Bodies {
 protected:
  /// A sleeve of so many elements round a cylinder, whose pressure is 1.0931 kPa.
  void write_cylinder(const std::string& across, const std::string& accuracy = "") const {
    write_sleeve({{file_body, cylinder}, {R"(value="32")", "value=\"" + across + "\""}, with(accuracy)});
  }
  static std::pair<std::string, std::string> with(const std::string& accuracy) {
    const std::string output = "<ParameterList name=\"Output\">";
    if (accuracy.empty()) return {output, output};
    return {output, "<ParameterList name=\"Accuracy\">" + accuracy + "</ParameterList>" + output};
  }
  /// [run] a column of accuracy.csv.
  std::vector<double> reached(size_t column) const {
    std::istringstream rows(read("results/accuracy.csv"));
    std::vector<double> values;
    std::string row, cell;
    for (std::getline(rows, row); std::getline(rows, row);) {
      std::istringstream cells(row);
      for (size_t c = 0; c <= column; ++c) std::getline(cells, cell, ',');
      values.push_back(std::stod(cell));
    }
    return values;
  }
};

// From a mesh that is wrong by 3 % a run finds one that is right within the 0.5 % that it is asked for, and tells what
// each mesh has reached.
TEST_F(Accuracy, IsReachedOnFinerMeshes) {
  write_cylinder("12", real("error", 0.5));
  const Outcome outcome = toile("run scene.xml --output results");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(level_pressure() / 1.0931, 1.0, 0.005);
  const std::vector<double> nodes = reached(1), error = reached(3);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_GT(nodes[1], 3.0 * nodes[0]);
  EXPECT_GT(error[0], 2.0);
  EXPECT_LT(error[1], 0.5);
  EXPECT_THAT(outcome.out, HasSubstr("nodes"));
}

// What no mesh changes is told: a level whose error is the body's, a limit of runs, one of nodes.
TEST_F(Accuracy, TellsWhyItIsNotReached) {
  Facets body = tube(60.0, 40, 10.0);
  for (size_t n = 0; n < body.points.size(); ++n)
    for (size_t d = 0; d < 2; ++d) body.points[n][d] *= 1.0 + 0.01 * std::sin(7.0 * static_cast<double>(n));
  write("body.obj", obj(body));
  write_sleeve({with(real("error", 0.01))});
  Outcome outcome = toile("run scene.xml --output results");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("the parts that no mesh changes, the body's shape above all"));
  write_cylinder("12", real("error", 0.5) + R"(<Parameter name="most nodes" type="int" value="200"/>)");
  outcome = toile("run scene.xml --output results");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("nodes, and 200 are allowed (\"most nodes\")"));
  write_cylinder("12", real("error", 0.5) + R"(<Parameter name="most runs" type="int" value="1"/>)");
  outcome = toile("run scene.xml --output results");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("after 1 runs (\"most runs\")"));
}

// A place that is not there is refused with the nearest that is, and so is a scene that names none.
TEST_F(Accuracy, RefusesUnknownPlaces) {
  write_cylinder("12", real("error", 0.5) + R"x(<Parameter name="at" type="Array(string)" value="{midle}"/>)x");
  expect_refused(HasSubstr("no level, point or body point is named \"midle\"; did you mean \"middle\"?"));
}

// Elements that turn by more than 40 degrees round the body are warned of: of 6 round a cylinder the error is told too
// small, of 12 it is not.
TEST_F(Accuracy, IsNotToldOnElementsThatAreTooLarge) {
  write_cylinder("6");
  EXPECT_THAT(toile("run scene.xml --output results").err, HasSubstr("the elements are too large for the body"));
  write_cylinder("12");
  EXPECT_THAT(toile("run scene.xml --output results").err, Not(HasSubstr("too large")));
}

// A run without an accuracy leaves no table of one that was there before: it would be of another mesh.
TEST_F(Accuracy, OfAnEarlierRunIsTakenAway) {
  write("results/accuracy.csv", "finer,nodes\n1,78\n");
  write_cylinder("12");
  EXPECT_EQ(toile("run scene.xml --output results").status, 0);
  EXPECT_TRUE(read("results/accuracy.csv").empty());
}

}  // namespace
}  // namespace toile::test
