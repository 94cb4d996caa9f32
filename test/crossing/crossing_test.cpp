#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "toile/crossing/crossings.hpp"

namespace toile::crossing {
namespace {

using mesh::Vec3;
using Map = std::function<Vec3(double, double)>;

constexpr double pi = 3.14159265358979323846;

/// Panels of across x along elements each, laid in space by a map of 0..1, 0..1.
struct Garment {
  mesh::Mesh mesh;
  std::vector<std::vector<int>> clusters;
  std::vector<Vec3> position;

  void add(const std::string& name, int across, int along, const Map& map, bool triangles = false) {
    mesh::Block block;
    block.panel = static_cast<int>(mesh.panels.size());
    block.nodes_per_element = triangles ? 3 : 4;
    const int first = static_cast<int>(position.size());
    const auto node = [&](int i, int j) { return first + j * (across + 1) + i; };
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i <= across; ++i) {
        clusters.push_back({static_cast<int>(position.size())});
        position.push_back(map(static_cast<double>(i) / across, static_cast<double>(j) / along));
      }
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < across; ++i) {
        const int a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
        const std::vector<int> corners = triangles ? std::vector{a, b, c, a, c, d} : std::vector{a, b, c, d};
        block.connectivity.insert(block.connectivity.end(), corners.begin(), corners.end());
      }
    mesh.panels.push_back({name, first, static_cast<int>(position.size()) - first, across, {}});
    mesh.blocks.push_back(block);
  }
  /// Ties nodes that are at one place.
  void sew() {
    clusters.clear();
    for (int n = 0; n < static_cast<int>(position.size()); ++n) {
      bool tied = false;
      for (std::vector<int>& cluster : clusters)
        if ((position[cluster.front()] - position[n]).norm() < 1e-6) {
          cluster.push_back(n);
          tied = true;
          break;
        }
      if (!tied) clusters.push_back({n});
    }
  }
  Crossings look() const { return find_crossings(mesh, clusters, position); }
};

/// A rectangle from a corner along two sides.
Map flat(const Vec3& corner, const Vec3& across, const Vec3& along) {
  return [=](double u, double v) { return Vec3(corner + u * across + v * along); };
}

/// Part of a cylinder about z.
Map cylinder(double radius, double height, const Vec3& at, double from = 0.0, double to = 1.0) {
  return [=](double u, double v) {
    const double angle = 2.0 * pi * (from + u * (to - from));
    return Vec3(at + Vec3(radius * std::cos(angle), radius * std::sin(angle), height * v));
  };
}

/// A strip 30 mm wide that stands at an angle in a sheet, `along` elements long.
Garment crossing_strips(double degrees, int along, bool triangles = false) {
  const double angle = degrees * pi / 180.0;
  const Vec3 way(0.0, 60.0 * std::cos(angle), 60.0 * std::sin(angle));
  Garment garment;
  garment.add("sheet", 10, 12, flat({-50, -60, 0}, {100, 0, 0}, {0, 120, 0}), triangles);
  garment.add("strip", 3, along, flat(Vec3(-15, 0, 0) - 0.5 * way, {30, 0, 0}, way), triangles);
  return garment;
}

/// A strip that stands in a sheet crosses it along its width, whatever the angle, the elements and their number.
TEST(Crossings, TwoStripsCrossAlongTheWidth) {
  for (const double degrees : {90.0, 45.0, 7.0})
    for (const bool triangles : {false, true})
      for (const int along : {5, 7}) {
        const Crossings found = crossing_strips(degrees, along, triangles).look();
        ASSERT_EQ(found.panels.size(), 1U) << degrees;
        EXPECT_EQ(found.panels[0].first, 0);
        EXPECT_EQ(found.panels[0].second, 1);
        EXPECT_NEAR(found.panels[0].length, 30.0, 1e-9) << degrees;
        EXPECT_NEAR(found.panels[0].place.z(), 0.0, 1e-9);
        EXPECT_LE(std::abs(found.panels[0].place.x()), 15.0);
      }
}

/// Pairs and depth: a row of three elements of the strip meets the elements of the sheet on either side of a mesh line,
/// two of its columns each; the next mesh lines of the sheet are 10 mm from the strip, nearer than those of the strip
/// are to the sheet.
TEST(Crossings, TellsPairsAndDepth) {
  const PanelCrossing found = crossing_strips(90.0, 5).look().panels.at(0);
  EXPECT_EQ(found.pairs, 2 * 6);
  EXPECT_NEAR(found.depth, 10.0, 1e-9);
}

/// Where mesh lines of both panels lie on the crossing, so that all elements merely touch, it is found all the same,
/// and its length counts once.
TEST(Crossings, MeshLinesOnTheCrossingAreNoWayOut) {
  for (const bool triangles : {false, true}) {
    const Crossings found = crossing_strips(90.0, 6, triangles).look();
    ASSERT_EQ(found.panels.size(), 1U);
    EXPECT_NEAR(found.panels[0].length, 30.0, 1e-9);
    EXPECT_NEAR(found.panels[0].depth, 10.0, 1e-9);
  }
}

/// The field has the length of the line in each element that crosses, and zero elsewhere.
TEST(Crossings, ElementsHaveTheirLengths) {
  const Garment garment = crossing_strips(90.0, 5);
  const Crossings found = garment.look();
  const int sheet = garment.mesh.blocks[0].size();
  double of_strip = 0.0;
  int crossed = 0;
  for (int e = 0; e < garment.mesh.elements(); ++e) {
    if (found.length[e] > 0.0) ++crossed;
    if (e >= sheet) of_strip += found.length[e];
  }
  EXPECT_EQ(crossed, 3 + 2 * 4);
  EXPECT_NEAR(of_strip, 30.0, 1e-9);
}

/// A strip that stands on a sheet, or lies on it, does not cross it.
TEST(Crossings, TouchingIsNoCrossing) {
  Garment standing;
  standing.add("sheet", 10, 10, flat({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}));
  standing.add("strip", 3, 5, flat({-15, 3, 0}, {30, 0, 0}, {0, 0, 50}));
  EXPECT_TRUE(standing.look().panels.empty());
  Garment lying;
  lying.add("sheet", 10, 10, flat({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}));
  lying.add("strip", 3, 5, flat({-15, 3, 0}, {30, 0, 0}, {0, 41, 0}));
  EXPECT_TRUE(lying.look().panels.empty());
}

/// A corner that pokes through a sheet by less than a tenth of an element is fabric on fabric, by more a crossing.
TEST(Crossings, CountsFromATenthOfAnElement) {
  for (const double depth : {0.08, 0.12}) {
    Garment garment;
    garment.add("sheet", 10, 10, flat({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}));
    const Vec3 across = 40.0 * Vec3(1, 0, 1).normalized(), along = 40.0 * Vec3(-1, 0, 1).normalized();
    garment.add("flag", 4, 4, flat({3, 3, -10.0 * depth}, across, along));
    EXPECT_EQ(garment.look().panels.size(), depth > 0.1 ? 1U : 0U) << depth;
  }
}

/// A strip led in a loop through itself: x = t^3 - 3 t, z = t^2 cross at t = +-sqrt(3), along the strip's width.
TEST(Crossings, StripThroughItself) {
  Garment garment;
  garment.add("strip", 4, 61, [](double u, double v) {
    const double t = 5.0 * (v - 0.5);
    return Vec3(10.0 * (t * t * t - 3.0 * t), 40.0 * u, 10.0 * t * t);
  });
  const Crossings found = garment.look();
  ASSERT_EQ(found.panels.size(), 1U);
  EXPECT_EQ(found.panels[0].first, 0);
  EXPECT_EQ(found.panels[0].second, 0);
  EXPECT_NEAR(found.panels[0].length, 40.0, 1e-6);
  EXPECT_NEAR(found.panels[0].place.x(), 0.0, 0.1);
  EXPECT_NEAR(found.panels[0].place.z(), 30.0, 0.5);
  EXPECT_NE(text_of(found, garment.mesh).find("strip x itself"), std::string::npos);
}

/// Front and back that are sewn at both sides do not cross, round or pressed flat; seams do not touch.
TEST(Crossings, SewnTubeDoesNot) {
  for (const double flatness : {1.0, 0.05, 0.0}) {
    Garment tube;
    for (const int half : {0, 1})
      tube.add(half == 0 ? "front" : "back", 12, 10, [&](double u, double v) {
        Vec3 x = cylinder(50.0, 100.0, Vec3::Zero(), 0.5 * half, 0.5 * half + 0.5)(u, v);
        x.y() *= flatness;
        return x;
      });
    tube.sew();
    EXPECT_TRUE(tube.look().panels.empty()) << flatness;
  }
}

/// Two layers on one cylinder, of elements of different sizes, are through each other as far as their elements are
/// flat, and do not cross; neither do they on a saddle.
TEST(Crossings, LayersOnOneBodyDoNot) {
  for (const int across : {17, 24, 31, 40}) {
    Garment garment;
    garment.add("inner", 24, 8, cylinder(50.0, 100.0, Vec3::Zero()));
    garment.add("outer", across, across / 2, cylinder(50.0, 80.0, Vec3(0.0, 0.0, 7.0), 0.013, 1.013));
    EXPECT_TRUE(garment.look().panels.empty()) << across << ": " << text_of(garment.look(), garment.mesh);
  }
  const auto saddle = [](double shift) {
    return [=](double u, double v) {
      const double x = 80.0 * (u - 0.5) + shift, y = 80.0 * (v - 0.5) - shift;
      return Vec3(x, y, (x * x - y * y) / 100.0);
    };
  };
  Garment garment;
  garment.add("inner", 8, 8, saddle(0.0));
  garment.add("outer", 11, 7, saddle(1.7));
  EXPECT_TRUE(garment.look().panels.empty()) << text_of(garment.look(), garment.mesh);
}

/// The same layers, one moved by 30 mm across: two round sections cross at two points, so along two lines.
TEST(Crossings, TubesBesideEachOtherDo) {
  Garment garment;
  garment.add("one", 40, 10, cylinder(50.0, 100.0, Vec3::Zero()));
  garment.add("other", 31, 7, cylinder(50.0, 80.0, Vec3(30.0, 0.0, 7.0), 0.013, 1.013));
  const Crossings found = garment.look();
  ASSERT_EQ(found.panels.size(), 1U);
  EXPECT_NEAR(found.panels[0].length, 2.0 * 80.0, 1e-6);
  EXPECT_NEAR(found.panels[0].place.x(), 15.0, 1.0);
}

}  // namespace
}  // namespace toile::crossing
