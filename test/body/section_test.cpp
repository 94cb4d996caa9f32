#include "toile/body/section.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "body/figures.hpp"

namespace toile::test {
namespace {

using body::SectionPiece;
using body::Sections;
using body::Vec3;

std::vector<Vec3> ring(double a, double b, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    points.emplace_back(a * std::cos(angle), b * std::sin(angle), 0.0);
  }
  return points;
}

// Girth, perimeter, area and centre of a section of a prism are those of its polygon, to round-off.
TEST(Section, Prism) {
  constexpr int sides = 24;
  constexpr double radius = 60.0;
  const Sections sections(closed_tube(ring(radius, radius, sides), 200.0, Vec3(10.0, -20.0, 5.0)));
  const auto pieces = sections.cut({0.0, 0.0, 77.0}, Vec3::UnitZ());
  ASSERT_EQ(pieces.size(), 1u);
  const SectionPiece& piece = pieces.front();
  const double perimeter = 2.0 * sides * radius * std::sin(M_PI / sides);
  EXPECT_TRUE(piece.closed);
  EXPECT_NEAR(piece.perimeter, perimeter, 1e-9);
  EXPECT_NEAR(piece.tape_girth, perimeter, 1e-9);
  EXPECT_NEAR(piece.area, 0.5 * sides * radius * radius * std::sin(2.0 * M_PI / sides), 1e-8);
  EXPECT_LT((piece.centre - Vec3(10.0, -20.0, 77.0)).norm(), 1e-9);
  EXPECT_TRUE(sections.cut({0.0, 0.0, 300.0}, Vec3::UnitZ()).empty());
}

// The girth of a fine elliptic cylinder is the ellipse's (Ramanujan's second formula errs by 1e-6 here), and that of a
// cylinder across a plane at 60 degrees is the ellipse with twice the axis.
TEST(Section, Ellipses) {
  const auto ellipse = [](double a, double b) {
    const double h = std::pow((a - b) / (a + b), 2);
    return M_PI * (a + b) * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
  };
  const Sections elliptic(closed_tube(ring(80.0, 50.0, 720), 200.0));
  EXPECT_NEAR(elliptic.cut({0.0, 0.0, 100.0}, Vec3::UnitZ()).front().tape_girth / ellipse(80.0, 50.0), 1.0, 1e-5);
  const Sections round(closed_tube(ring(40.0, 40.0, 720), 400.0));
  const auto across = round.cut({0.0, 0.0, 200.0}, {std::sqrt(3.0), 0.0, 1.0});
  ASSERT_EQ(across.size(), 1u);
  EXPECT_NEAR(across.front().tape_girth / ellipse(80.0, 40.0), 1.0, 2e-5);
}

// A tape spans hollows that the perimeter follows: round an L of 30 mm with arms of 10 mm it is 20 root 2 instead of
// 2 x 20 mm long there.
TEST(Section, TapeSpansHollows) {
  const std::vector<Vec3> corner = {{0, 0, 0}, {30, 0, 0}, {30, 10, 0}, {10, 10, 0}, {10, 30, 0}, {0, 30, 0}};
  const Sections sections(closed_tube(corner, 100.0));
  const SectionPiece piece = sections.cut({0.0, 0.0, 50.0}, Vec3::UnitZ()).front();
  EXPECT_NEAR(piece.perimeter, 120.0, 1e-9);
  EXPECT_NEAR(piece.tape_girth, 80.0 + 20.0 * std::sqrt(2.0), 1e-9);
}

// Two legs are two pieces with a girth each.
TEST(Section, TwoLegs) {
  const Sections sections(joined(closed_tube(ring(60.0, 60.0, 24), 200.0, Vec3(100.0, 0.0, 0.0)),
                                 closed_tube(ring(50.0, 50.0, 24), 200.0, Vec3(-100.0, 0.0, 0.0))));
  const auto pieces = sections.cut({0.0, 0.0, 50.0}, Vec3::UnitZ());
  ASSERT_EQ(pieces.size(), 2u);
  const double per_radius = 48.0 * std::sin(M_PI / 24);
  for (const SectionPiece& piece : pieces)
    EXPECT_NEAR(piece.tape_girth, per_radius * (piece.centre.x() > 0.0 ? 60.0 : 50.0), 1e-9);
}

// The shortest way on a prism is a straight line on its faces laid flat, along edges and through vertices too; the
// corners of the way are that long.
TEST(Section, ShortestWays) {
  constexpr int sides = 76;
  const auto angle = [](int i) { return 2.0 * M_PI * i / sides; };
  const double side = 2.0 * 60.0 * std::sin(M_PI / sides);
  const auto corner = [&](int i) { return Vec3(60.0 * std::cos(angle(i)), 60.0 * std::sin(angle(i)), 0.0); };
  body::TriangleMesh tube;  // of regular rows, 5 mm high
  constexpr int rows = 40;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < sides; ++i) tube.vertices.push_back(corner(i) + 5.0 * j * Vec3::UnitZ());
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < sides; ++i) {
      const int a = j * sides + i, b = j * sides + (i + 1) % sides;
      tube.triangles.push_back({a, b, b + sides});
      tube.triangles.push_back({a, b + sides, a + sides});
    }
  const Sections sections(tube);
  const auto at = [&](int face, double share, double z) -> Vec3 {
    return (1.0 - share) * corner(face) + share * corner(face + 1) + z * Vec3::UnitZ();
  };
  for (const double rise : {0.0, 80.0})
    for (const double share : {0.0, 0.25, 0.5}) {
      const Vec3 from = at(0, share, 100.0), to = at(25, 0.0, 100.0 + rise);
      const double exact = std::hypot((25.0 - share) * side, rise);
      EXPECT_NEAR(sections.length_on_surface(from, to), exact, 1e-3) << share;
      const std::vector<Vec3> way = sections.shortest_way(from, to);
      EXPECT_LT((way.front() - from).norm(), 1e-3);
      EXPECT_LT((way.back() - to).norm(), 1e-3);
    }
}

// Volume, area and number of pieces of two prisms.
TEST(Section, Extent) {
  const auto square = [](double a) { return std::vector<Vec3>{{0, 0, 0}, {a, 0, 0}, {a, a, 0}, {0, a, 0}}; };
  const body::Extent extent =
      body::extent_of(joined(closed_tube(square(10.0), 30.0), closed_tube(square(20.0), 40.0, Vec3(100.0, 0.0, 0.0))));
  EXPECT_EQ(extent.pieces, 2);
  EXPECT_NEAR(extent.volume, 3000.0 + 16000.0, 1e-9);
  EXPECT_NEAR(extent.area, 1400.0 + 4000.0, 1e-9);
  EXPECT_LT((extent.upper - Vec3(120.0, 20.0, 40.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace toile::test
