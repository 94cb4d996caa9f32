// Names, titles and paths that hold what programs stumble over, and the results that bear them.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "app/exodus.hpp"
#include "cases/sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Rows of numbers below the head of a table.
std::vector<std::vector<double>> rows_of(const std::string& table) {
  std::istringstream lines(table);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (rows.emplace_back(); std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// A strip that is pulled and turned, let back, and pulled again: three stages.
class Names : public ProgramTest {
 protected:
  void SetUp() override {
    write_scene("../../data/cases/names/there-and-back");
    const Outcome run = toile("run scene.xml --output out");
    ASSERT_EQ(run.status, 0) << run.err;
  }
};

// The times of the results rise over all stages, though the loads fall, and the strip is where it was at the same load:
// its clamp has turned by -3 degrees about its middle, 10 mm from the corner, and moved by 8 mm.
TEST_F(Names, TimesRiseOverAllStages) {
  const std::vector<double> times = ExodusStep(path("out/results.exo")).times;
  EXPECT_GT(times.size(), 10u);
  for (size_t k = 1; k < times.size(); ++k) EXPECT_GT(times[k], times[k - 1]) << k;
  const auto corner = rows_of(read("out/points.csv"));
  ASSERT_EQ(corner.size(), times.size());
  constexpr double turn = 3.0 * M_PI / 180.0;
  EXPECT_NEAR(corner.back().at(2), 10.0 * (1.0 - std::cos(turn)), 1e-9);
  EXPECT_NEAR(corner.back().at(3), 8.0 + 10.0 * std::sin(turn), 1e-9);
  const auto first = std::find_if(corner.begin(), corner.end(), [](const auto& row) { return row[1] == 1.0; });
  const auto width = rows_of(read("out/distances.csv"));
  EXPECT_NEAR(width.back().at(2), width.at(static_cast<size_t>(first - corner.begin())).at(2), 1e-8);
}

// Two supports whose names agree in 36 characters keep their own fields, with the torques of the table.
TEST_F(Names, ThatBeginAlikeAreKeptApart) {
  const std::string torques = read("out/torques.csv");
  EXPECT_THAT(torques, AllOf(HasSubstr(",clamp at the free end of the specimeone: torque [N mm]"),
                             HasSubstr(",clamp at the free end of the specimetwo: torque [N mm]")));
  const ExodusStep last(path("out/results.exo"));
  const std::vector<double> row = rows_of(torques).back();
  EXPECT_NEAR(last.global("torque_clamp_at_the_free_end_of_the_specimeone"), row.at(3), 1e-12);
  EXPECT_NEAR(last.global("torque_clamp_at_the_free_end_of_the_specimetwo"), row.at(5), 1e-12);
  EXPECT_GT(std::abs(row.at(3) - row.at(5)), 0.1);
}

// A title with a command in it is a text, for gnuplot too; a name with commas and quotes is quoted in the table.
TEST_F(Names, AreTexts) {
  EXPECT_THAT(read("scene.xml"), HasSubstr("`touch executed`"));
  EXPECT_FALSE(exists("executed"));
  EXPECT_FALSE(exists("out/executed"));
  EXPECT_THAT(read("out/distances.csv"), StartsWith("step,load,\"width, \"\"middle\"\" `touch executed` [mm]\"\n"));
}

// Blanks, an apostrophe and accents in the paths of scene, body, results and a fabric's source.
TEST_F(Bodies, InOddPaths) {
  write("corps d'été/jambe gauche.obj", obj(tube(60.0, 20, 20.0)));
  write_sleeve({{"body.obj", "corps d'été/jambe gauche.obj"}});
  write("scène d'essai.xml", read("scene.xml"));
  const Outcome run = toile("run \"scène d'essai.xml\" --output \"résultats à côté\"");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Files in résultats à côté: results.exo"));
  write("results/pressure-levels.csv", read("résultats à côté/pressure-levels.csv"));
  EXPECT_NEAR(level_pressure() / pressure_of(250.0), 1.0, mesh_error);
  write("mon étoffe.cpp", "#include \"toile/material/plugin.hpp\"\n");
  const Outcome build = toile("material build \"mon étoffe.cpp\"");
  EXPECT_EQ(build.status, 2);
  EXPECT_THAT(build.err, HasSubstr("mon étoffe.cpp: error: TOILE_MATERIAL(YourLaw) is missing"));
}

}  // namespace
}  // namespace toile::test
