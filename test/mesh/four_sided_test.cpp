#include "toile/mesh/four_sided.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "toile/base/error.hpp"

namespace toile::mesh {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Curve line(const Vec2& a, const Vec2& b) {
  return Curve::line(a, b);
}

Curve arc(double radius, double from, double to, int points = 65) {
  std::vector<Vec2> at;
  for (int i = 0; i < points; ++i) {
    const double angle = from + (to - from) * i / (points - 1);
    at.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return Curve::spline(at);
}

/// Quarter of a ring between the radii 50 and 100 mm; bottom lies on the x axis.
FourSides quarter_ring() {
  return {line({50.0, 0.0}, {100.0, 0.0}), arc(100.0, 0.0, M_PI / 2), line({0.0, 50.0}, {0.0, 100.0}),
          arc(50.0, 0.0, M_PI / 2)};
}

double area(const Grid& grid) {
  double sum = 0.0;
  for (std::size_t e = 0; e < grid.connectivity.size(); e += grid.nodes_per_element) {
    double one = 0.0;
    for (int k = 0; k < grid.nodes_per_element; ++k) {
      const Vec2& a = grid.nodes[grid.connectivity[e + k]];
      const Vec2& b = grid.nodes[grid.connectivity[e + (k + 1) % grid.nodes_per_element]];
      one += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    EXPECT_GT(one, 0.0);
    sum += one;
  }
  return sum;
}

GridOptions options(int across, int along) {
  GridOptions result;
  result.across = across;
  result.along = along;
  return result;
}

// A rectangle is meshed into equal elements that fill it exactly.
TEST(FourSided, RectangleIsUniform) {
  const Grid grid = mesh_four_sided("front", rectangle(60.0, 40.0), options(6, 8));
  ASSERT_EQ(grid.nodes.size(), 7u * 9u);
  EXPECT_NEAR((grid.nodes[grid.node(2, 3)] - Vec2(20.0, 15.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(area(grid), 2400.0, 1e-9);
}

// The corners and the nodes of the edges lie on the four curves, at equal arc length.
TEST(FourSided, EdgesLieOnTheCurves) {
  const FourSides sides = quarter_ring();
  const Grid grid = mesh_four_sided("front", sides, options(5, 10));
  for (int j = 0; j <= 10; ++j) {
    EXPECT_NEAR((grid.nodes[grid.column(5)[j]] - sides.right.at(j / 10.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(grid.nodes[grid.column(0)[j]].norm(), 50.0, 1e-4);
  }
  for (int i = 0; i <= 5; ++i) EXPECT_NEAR((grid.nodes[grid.row(10)[i]] - sides.top.at(i / 5.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((grid.nodes[grid.node(5, 10)] - Vec2(0.0, 100.0)).norm(), 0.0, 1e-12);
}

// The area of the mesh converges to the area of a curved panel with second order, with elements of either kind.
TEST(FourSided, AreaConvergesWithSecondOrder) {
  const double exact = M_PI / 4.0 * (100.0 * 100.0 - 50.0 * 50.0);
  for (const bool triangles : {false, true}) {
    std::vector<double> errors;
    for (const int n : {4, 8, 16}) {
      GridOptions wanted = options(n, n);
      wanted.triangles = triangles;
      errors.push_back(std::abs(area(mesh_four_sided("front", quarter_ring(), wanted)) - exact));
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.9);
    EXPECT_GT(std::log2(errors[1] / errors[2]), 1.9);
  }
}

// Every quadrilateral becomes two triangles, and the diagonals of neighbours alternate.
TEST(FourSided, TrianglesAlternate) {
  GridOptions wanted = options(4, 4);
  wanted.triangles = true;
  const Grid grid = mesh_four_sided("front", rectangle(40.0, 40.0), wanted);
  ASSERT_EQ(grid.nodes_per_element, 3);
  ASSERT_EQ(grid.connectivity.size(), 3u * 32u);
  EXPECT_NEAR(area(grid), 1600.0, 1e-9);
  std::vector<int> valence(grid.nodes.size(), 0);
  for (const int id : grid.connectivity) ++valence[id];
  EXPECT_EQ(valence[grid.node(1, 1)], 8);
  EXPECT_EQ(valence[grid.node(2, 1)], 4);
}

// A sector is a polar grid: rows on circles, from the outer to the inner radius, columns on rays, whatever its angle.
TEST(FourSided, SectorIsPolar) {
  for (const double turn : {0.5, 2.0, 2.0 * M_PI}) {
    const Grid grid = mesh_four_sided("ring", sector(6.0, 10.0, 0.3, 0.3 + turn), options(12, 4));
    for (int j = 0; j <= 4; ++j) {
      for (int i = 0; i <= 12; ++i) {
        const double angle = 0.3 + turn * i / 12.0;
        const Vec2 wanted = (10.0 - j) * Vec2(std::cos(angle), std::sin(angle));
        EXPECT_NEAR((grid.nodes[grid.node(i, j)] - wanted).norm(), 0.0, 1e-13);
      }
    }
    EXPECT_GT(area(grid), 0.0);
  }
}

/// Least Jacobian at the 2 x 2 Gauss points over the mean of its element.
double worst_jacobian(const Grid& grid) {
  double worst = 1.0;
  for (std::size_t e = 0; e < grid.connectivity.size(); e += 4) {
    const auto at = [&grid, e](int k) { return grid.nodes[grid.connectivity[e + k]]; };
    const auto jacobian = [&at](double p, double q) {
      const Vec2 x = 0.25 * ((1.0 - q) * (at(1) - at(0)) + (1.0 + q) * (at(2) - at(3)));
      const Vec2 y = 0.25 * ((1.0 - p) * (at(3) - at(0)) + (1.0 + p) * (at(2) - at(1)));
      return x.x() * y.y() - x.y() * y.x();
    };
    for (const double p : {-1.0, 1.0}) {
      for (const double q : {-1.0, 1.0}) {
        worst = std::min(worst, jacobian(p / std::sqrt(3.0), q / std::sqrt(3.0)) / jacobian(0.0, 0.0));
      }
    }
  }
  return worst;
}

// The corners of a disc, whose sides are one smooth line there, do not degenerate as the mesh is refined; the rim is
// exact and the area converges with second order.
TEST(FourSided, DiscsStayAdmissible) {
  for (const bool whole : {true, false}) {
    std::vector<double> errors;
    for (const int n : {8, 16, 32}) {
      const Grid grid = mesh_four_sided("disc", whole ? disc(50.0) : quarter_disc(50.0), options(n, n));
      EXPECT_GT(worst_jacobian(grid), 0.64);
      for (const int id : grid.row(n)) EXPECT_NEAR(grid.nodes[id].norm(), 50.0, 1e-12);
      for (const int id : grid.column(n)) EXPECT_NEAR(grid.nodes[id].norm(), 50.0, 1e-12);
      errors.push_back(M_PI * 2500.0 * (whole ? 1.0 : 0.25) - area(grid));
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.95);
    EXPECT_GT(std::log2(errors[1] / errors[2]), 1.95);
  }
}

// The straight sides of a quarter disc lie on the axes, so that symmetry can be held there; a whole disc has a node in
// its centre if its numbers of elements are even.
TEST(FourSided, DiscsLieOnTheAxes) {
  const Grid quarter = mesh_four_sided("disc", quarter_disc(50.0), options(6, 6));
  for (const int id : quarter.row(0)) EXPECT_NEAR(quarter.nodes[id].y(), 0.0, 1e-13);
  for (const int id : quarter.column(0)) EXPECT_NEAR(quarter.nodes[id].x(), 0.0, 1e-13);
  const Grid whole = mesh_four_sided("disc", disc(50.0), options(6, 4));
  EXPECT_NEAR(whole.nodes[whole.node(3, 2)].norm(), 0.0, 1e-12);
}

// Grading moves the nodes towards both ends by the stated power law and stays symmetric.
TEST(FourSided, GradingIsSymmetricPowerLaw) {
  EXPECT_DOUBLE_EQ(graded(0.25, 2.0), 0.125);
  EXPECT_DOUBLE_EQ(graded(0.75, 2.0), 0.875);
  EXPECT_DOUBLE_EQ(graded(0.3, 1.0), 0.3);
  GridOptions wanted = options(4, 8);
  wanted.grading_along = 2.0;
  const Grid grid = mesh_four_sided("front", rectangle(40.0, 80.0), wanted);
  EXPECT_NEAR(grid.nodes[grid.node(0, 1)].y(), 80.0 * 0.5 / 16.0, 1e-12);
  EXPECT_NEAR(grid.nodes[grid.node(1, 1)].x(), 10.0, 1e-12);
}

// Distortion moves inner nodes only, keeps the area, and is the same in every run.
TEST(FourSided, DistortionKeepsTheOutline) {
  GridOptions wanted = options(6, 6);
  const Grid regular = mesh_four_sided("front", rectangle(60.0, 60.0), wanted);
  wanted.distortion = 0.3;
  const Grid distorted = mesh_four_sided("front", rectangle(60.0, 60.0), wanted);
  EXPECT_GT((distorted.nodes[distorted.node(3, 3)] - regular.nodes[regular.node(3, 3)]).norm(), 0.1);
  for (const int id : regular.row(0)) EXPECT_EQ(distorted.nodes[id], regular.nodes[id]);
  for (const int id : regular.column(6)) EXPECT_EQ(distorted.nodes[id], regular.nodes[id]);
  EXPECT_NEAR(area(distorted), 3600.0, 1e-9);
  EXPECT_EQ(mesh_four_sided("front", rectangle(60.0, 60.0), wanted).nodes, distorted.nodes);
}

// A map that folds over is refused with the panel's name and the place.
TEST(FourSided, FoldedMapIsRefused) {
  const Curve deep = Curve::spline({{0.0, 0.0}, {50.0, 95.0}, {100.0, 0.0}});
  const FourSides sides{deep, line({100.0, 0.0}, {100.0, 100.0}),
                        Curve::spline({{0.0, 100.0}, {50.0, 60.0}, {100.0, 100.0}}), line({0.0, 0.0}, {0.0, 100.0})};
  try {
    mesh_four_sided("sleeve", sides, options(8, 8));
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("panel \"sleeve\" overlaps itself near ("),
                                    HasSubstr("an element is turned over there"), HasSubstr("split it")));
  }
}

// Sides that do not meet in a corner are reported with both points.
TEST(FourSided, OpenCornerIsNamed) {
  FourSides sides = rectangle(10.0, 20.0);
  EXPECT_FALSE(sides.open_corner());
  sides.top = line({0.0, 20.0}, {9.0, 20.0});
  EXPECT_EQ(sides.open_corner().value_or(""), "the end of right at (10, 20) and the end of top at (9, 20)");
}

// A panel added to a mesh gets nodes of its own, named ordered edges and relative positions from bottom to top.
TEST(FourSided, PanelsAreAddedOneAfterAnother) {
  Mesh mesh;
  const Grid grid = mesh_four_sided("front", rectangle(20.0, 40.0), options(2, 4));
  const Placed placed{std::vector<Vec3>(grid.nodes.size(), Vec3(1.0, 2.0, 3.0)),
                      std::vector<Vec3>(grid.nodes.size(), Vec3::UnitZ())};
  add_panel(mesh, "front", panel_mesh(grid), placed, {{"", {"knit", M_PI / 2}}});
  add_panel(mesh, "back", panel_mesh(grid), placed, {{"", {"knit", 0.0}}});
  EXPECT_EQ(mesh.nodes(), 30);
  EXPECT_EQ(mesh.elements(), 16);
  EXPECT_THAT(mesh.edges.at("front.bottom"), ::testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.edges.at("front.right"), ::testing::ElementsAre(2, 5, 8, 11, 14));
  EXPECT_THAT(mesh.edges.at("back.left"), ::testing::ElementsAre(15, 18, 21, 24, 27));
  EXPECT_THAT(mesh.edges.at("back.top"), ::testing::ElementsAre(27, 28, 29));
  EXPECT_EQ(mesh.blocks[1].connectivity[0], 15);
  EXPECT_THAT(mesh.placed, ::testing::AllOf(::testing::SizeIs(30), ::testing::Each(Vec3(1.0, 2.0, 3.0))));
  EXPECT_THAT(mesh.normal, ::testing::AllOf(::testing::SizeIs(30), ::testing::Each(Vec3(0.0, 0.0, 1.0))));
  EXPECT_DOUBLE_EQ(mesh.blocks[0].position[0], 0.125);
  EXPECT_DOUBLE_EQ(mesh.blocks[0].position[7], 0.875);
  EXPECT_DOUBLE_EQ(mesh.blocks[0].wale_angle[3], M_PI / 2);
}

}  // namespace
}  // namespace toile::mesh
