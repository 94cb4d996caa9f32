#include "toile/mesh/free_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "toile/base/error.hpp"
#include "toile/mesh/quality.hpp"
#include "toile/mesh/zones.hpp"

namespace toile::mesh {
namespace {

using ::testing::HasSubstr;

/// Points of a circle and the loop through them.
std::vector<int> add_circle(FreeMeshInput& input, const Vec2& centre, double radius, int count, bool clockwise) {
  std::vector<int> loop;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * M_PI * k / count * (clockwise ? -1.0 : 1.0);
    loop.push_back(static_cast<int>(input.points.size()));
    input.points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return loop;
}

/// A disc of 100 mm with a hole of 20 mm and a straight line inside.
FreeMeshInput holed_disc(double size, bool triangles) {
  FreeMeshInput input;
  input.size = size;
  input.triangles = triangles;
  const auto even = [size](double length) { return 2 * static_cast<int>(std::ceil(length / (2.0 * size))); };
  input.loops.push_back(add_circle(input, Vec2::Zero(), 100.0, even(200.0 * M_PI), false));
  input.loops.push_back(add_circle(input, Vec2(40.0, 0.0), 20.0, even(40.0 * M_PI), true));
  std::vector<int> line;
  const int sides = even(80.0);
  for (int k = 0; k <= sides; ++k) {
    line.push_back(static_cast<int>(input.points.size()));
    input.points.emplace_back(-60.0, -40.0 + 80.0 * k / sides);
  }
  input.lines.push_back(line);
  return input;
}

PanelMesh panel_of(const FreeMesh& mesh) {
  PanelMesh panel;
  panel.nodes = mesh.nodes;
  PanelPart four{"", 4, {}}, three{"", 3, {}};
  for (const auto& e : mesh.quadrilaterals) four.connectivity.insert(four.connectivity.end(), e.begin(), e.end());
  for (const auto& e : mesh.triangles) three.connectivity.insert(three.connectivity.end(), e.begin(), e.end());
  for (const PanelPart& part : {four, three})
    if (!part.connectivity.empty()) panel.parts.push_back(part);
  return panel;
}

double area_of(const PanelMesh& panel) {
  double twice = 0.0;
  for (const PanelPart& part : panel.parts)
    for (std::size_t k = 0; k < part.connectivity.size(); ++k) {
      const auto per = static_cast<std::size_t>(part.nodes_per_element);
      const Vec2& a = panel.nodes[part.connectivity[k]];
      const Vec2& b = panel.nodes[part.connectivity[k - k % per + (k + 1) % per]];
      twice += a.x() * b.y() - a.y() * b.x();
    }
  return 0.5 * twice;
}

double area_of(const FreeMeshInput& input) {
  double twice = 0.0;
  for (const std::vector<int>& loop : input.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec2 &a = input.points[loop[k]], &b = input.points[loop[(k + 1) % loop.size()]];
      twice += a.x() * b.y() - a.y() * b.x();
    }
  return 0.5 * twice;
}

/// How many elements share each side.
std::map<std::pair<int, int>, int> sides_of(const PanelMesh& panel) {
  std::map<std::pair<int, int>, int> count;
  for (const PanelPart& part : panel.parts)
    for (std::size_t k = 0; k < part.connectivity.size(); ++k) {
      const auto per = static_cast<std::size_t>(part.nodes_per_element);
      const int a = part.connectivity[k], b = part.connectivity[k - k % per + (k + 1) % per];
      ++count[{std::min(a, b), std::max(a, b)}];
    }
  return count;
}

class FreeMeshOf : public ::testing::TestWithParam<bool> {};

// The elements fill the area once, round its hole; sides of elements lie on the loops and the line, which keep their
// points; no angle is below 25 degrees.
TEST_P(FreeMeshOf, FillsTheAreaAndKeepsItsPoints) {
  const FreeMeshInput input = holed_disc(6.0, GetParam());
  const FreeMesh mesh = mesh_freely(input);
  EXPECT_EQ(mesh.quadrilaterals.empty(), GetParam());
  EXPECT_EQ(mesh.triangles.empty(), !GetParam());
  const PanelMesh panel = panel_of(mesh);
  EXPECT_NEAR(area_of(panel), area_of(input), 1e-9 * area_of(input));
  std::map<std::pair<int, int>, int> sides = sides_of(panel);
  for (std::size_t n = 0; n < input.points.size(); ++n) EXPECT_EQ(mesh.nodes[n], input.points[n]);
  for (const std::vector<int>& loop : input.loops)
    for (std::size_t k = 0; k < loop.size(); ++k)
      EXPECT_EQ((sides[std::minmax(loop[k], loop[(k + 1) % loop.size()])]), 1);
  for (std::size_t k = 1; k < input.lines[0].size(); ++k)
    EXPECT_EQ((sides[std::minmax(input.lines[0][k - 1], input.lines[0][k])]), 2);
  const Quality quality = quality_of(panel);
  EXPECT_GT(quality.smallest_angle, 25.0);
  EXPECT_GT(quality.smallest_jacobian, 0.15);
  EXPECT_LT(quality.largest_aspect, 4.0);
}

// The same input gives the same mesh, bit for bit.
TEST_P(FreeMeshOf, IsTheSameEachTime) {
  const FreeMesh first = mesh_freely(holed_disc(8.0, GetParam())), second = mesh_freely(holed_disc(8.0, GetParam()));
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.quadrilaterals, second.quadrilaterals);
  EXPECT_EQ(first.triangles, second.triangles);
}

// Sides have the wanted length on average, and a third of it where the mesh is refined.
TEST_P(FreeMeshOf, HasTheWantedSize) {
  double near = 0.0, far = 0.0;
  int near_count = 0, far_count = 0;
  for (const Vec2& place : {Vec2(-20.0, 60.0), Vec2(-17.0, 58.6), Vec2(-14.0, 57.2), Vec2(-11.0, 55.8)}) {
    FreeMeshInput input = holed_disc(6.0, GetParam());
    input.refinements.push_back({{place}, 2.0, 30.0});
    const FreeMesh mesh = mesh_freely(input);
    for (const auto& [side, count] : sides_of(panel_of(mesh))) {
      const Vec2 &a = mesh.nodes[side.first], &b = mesh.nodes[side.second];
      const double distance = (0.5 * (a + b) - place).norm();
      if (distance < 4.0) near += (a - b).norm(), ++near_count;
      if (distance > 50.0) far += (a - b).norm(), ++far_count;
    }
  }
  EXPECT_NEAR(near / near_count, 2.0, 0.5);
  EXPECT_NEAR(far / far_count, 6.0, 0.9);
}

INSTANTIATE_TEST_SUITE_P(Kinds, FreeMeshOf, ::testing::Bool(),
                         [](const auto& instance) { return instance.param ? "triangles" : "quadrilaterals"; });

// What Gmsh cannot mesh is an error of the input, and so is a mesher that does not end in time.
TEST(FreeMesh, FailuresAreInputErrors) {
  FreeMeshInput crossed;
  crossed.size = 1.0;
  crossed.triangles = true;
  crossed.points = {{0.0, 0.0}, {10.0, 0.0}, {0.0, 10.0}, {10.0, 10.0}};
  crossed.loops = {{0, 1, 2, 3}};
  EXPECT_THROW(mesh_freely(crossed), base::InputError);
  FreeMeshInput odd = holed_disc(20.0, false);
  odd.loops[0].pop_back();
  EXPECT_THROW(mesh_freely(odd), base::InputError);
  try {
    mesh_freely(holed_disc(0.7, false), 0.01);
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did not end within 0.01 s"));
  }
}

// A line from edge to edge divides a panel into two zones with all of its elements.
TEST(Zones, LiesOnBothSidesOfALine) {
  FreeMeshInput input;
  input.size = 2.0;
  input.points = {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {8, 0}, {8, 2}, {8, 4},
                  {6, 4}, {4, 4}, {2, 4}, {0, 4}, {0, 2}, {4, 2}};
  input.loops = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}};
  input.lines = {{2, 12, 8}};
  PanelMesh panel = panel_of(mesh_freely(input));
  PanelMesh whole = panel;
  divide_into_zones(panel, input.lines, {{{"band", {6.5, 1.5}}}, {}});
  ASSERT_EQ(panel.parts.size(), 2u);
  EXPECT_EQ(panel.parts[0].zone, "");
  EXPECT_EQ(panel.parts[1].zone, "band");
  EXPECT_NEAR(area_of(panel), 32.0, 1e-12);
  for (const int node : panel.parts[1].connectivity) EXPECT_GE(panel.nodes[node].x(), 4.0 - 1e-12);
  EXPECT_THROW(divide_into_zones(whole, input.lines, {{{"out", {9.0, 1.0}}}, {}}), base::InputError);
  EXPECT_THROW(divide_into_zones(whole, input.lines, {{{"a", {5.0, 1.0}}, {"b", {7.0, 3.0}}}, {}}), base::InputError);
}

// A parallelogram has its angles and the Jacobian 1; a kite's corner is told.
TEST(Quality, IsThatOfTheWorstElement) {
  PanelMesh panel;
  panel.nodes = {{0.0, 0.0}, {4.0, 0.0}, {5.0, 1.0}, {1.0, 1.0}};
  panel.parts = {{"", 4, {0, 1, 2, 3}}};
  const Quality quality = quality_of(panel);
  EXPECT_NEAR(quality.smallest_angle, 45.0, 1e-12);
  EXPECT_NEAR(quality.largest_angle, 135.0, 1e-12);
  EXPECT_NEAR(quality.smallest_jacobian, 1.0, 1e-12);
  EXPECT_NEAR(quality.largest_aspect, 4.0 / std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace toile::mesh
