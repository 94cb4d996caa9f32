// Bodies of several closed pieces: which of them are the skin.
#include <algorithm>

#include "cases/sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Puts `piece` behind the others, moved, with its facets turned if wanted.
void add(const Facets& piece, const Point& move, bool turned, Facets* body) {
  const int first = static_cast<int>(body->points.size());
  for (const Point& p : piece.points) body->points.push_back({p[0] + move[0], p[1] + move[1], p[2] + move[2]});
  for (auto facet : piece.facets) {
    for (int& corner : facet) corner += first;
    if (turned) std::reverse(facet.begin(), facet.end());
    body->facets.push_back(facet);
  }
}

struct Second {
  const char* name;
  Facets piece;
  Point move;
  bool turned;  ///< its facets look inwards
};

// A second piece that crosses or touches the first one is refused, whichever comes first and whichever way it looks,
// with the pieces' extents; to turn it is not advised and does not help.
TEST_F(Bodies, PiecesThatCross) {
  const Facets limb = tube(60.0, 20, 20.0);
  const std::vector<Second> seconds{
      {"inside, common end planes", tube(50.0, 20, 20.0), {0, 0, 0}, false},
      {"inside, common end planes, vertices elsewhere", tube(50.0, 20, 20.0, 31), {0, 0, 0}, false},
      {"inside, one common end plane", tube(50.0, 19, 20.0), {0, 0, 0}, false},
      {"just inside, common end planes", tube(59.0, 20, 20.0), {0, 0, 0}, false},
      {"cavity, common end planes", tube(50.0, 20, 20.0), {0, 0, 0}, true},
      {"inside, out at both ends", tube(50.0, 21, 20.0), {0, 0, -10}, false},
      {"beside, through each other", tube(60.0, 20, 20.0), {30, 0, 0}, false},
      {"nearly the same", tube(60.0, 20, 20.0), {1, 0, 0}, false},
      {"ring", tube(66.0, 6, 5.0), {0, 0, 185}, false},
  };
  for (const Second& second : seconds) {
    for (const bool limb_first : {true, false}) {
      SCOPED_TRACE(second.name + std::string(limb_first ? ", behind" : ", before"));
      Facets both;
      if (limb_first) add(limb, {0, 0, 0}, false, &both);
      add(second.piece, second.move, second.turned, &both);
      if (!limb_first) add(limb, {0, 0, 0}, false, &both);
      write("body.obj", obj(both));
      for (const bool repair : {false, true}) {
        write_sleeve({body(flag("repair orientation", repair))});
        const Outcome outcome = toile("check scene.xml");
        EXPECT_EQ(outcome.status, 2);
        EXPECT_THAT(outcome.err,
                    AllOf(HasSubstr("2 of the 2 connected pieces intersect or touch each other: piece 1 ("),
                          HasSubstr(", x -60 to 60, y -60 to 60, z -100 to 300 mm)"),
                          HasSubstr(" pairs of facets of different pieces intersect, one of them near ("),
                          HasSubstr("Join the pieces into one closed surface"), Not(HasSubstr("repair"))));
      }
    }
  }
}

// The same holds for a body that is turned in space, whose end planes coincide up to rounding only.
TEST_F(Bodies, PiecesThatCrossTurned) {
  Facets both;
  add(tube(60.0, 20, 20.0), {0, 0, 0}, false, &both);
  add(tube(50.0, 20, 20.0, 31), {0, 0, 0}, false, &both);
  const double c = std::cos(0.3), s = std::sin(0.3);
  for (Point& p : both.points) p = {c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]};
  write("body.obj", obj(both));
  write_sleeve({{"name=\"axis top\" type=\"Array(double)\" value=\"{0.0, 0.0, 1.0}\"",
                 "name=\"axis top\" type=\"Array(double)\" value=\"{" + std::to_string(s) + ", 0, " +
                     std::to_string(c) + "}\""}});
  expect_refused(HasSubstr("2 of the 2 connected pieces intersect or touch each other"));
}

// Two limbs beside each other and a piece strictly inside one of them give the pressure of the limb.
TEST_F(Bodies, PiecesApart) {
  Facets legs;
  add(tube(60.0, 20, 20.0), {0, 0, 0}, false, &legs);
  add(tube(60.0, 20, 20.0), {150, 0, 0}, false, &legs);
  add(tube(59.0, 19, 20.0), {0, 0, 10}, false, &legs);
  write("body.obj", obj(legs));
  write_sleeve();
  EXPECT_THAT(expect_pressure(pressure_of(250.0), mesh_error), HasSubstr("pieces inside another left out: 1"));
}

// Pieces that cross where the garment cannot reach both of them do not matter.
TEST_F(Bodies, PiecesThatCrossOutOfReach) {
  Facets both;
  add(tube(60.0, 20, 20.0), {0, 0, 0}, false, &both);
  add(tube(30.0, 5, 20.0), {0, 0, 370}, false, &both);
  write("body.obj", obj(both));
  write_sleeve();
  EXPECT_THAT(expect_pressure(pressure_of(250.0), mesh_error), HasSubstr("pairs of facets intersect"));
}

}  // namespace
}  // namespace toile::test
