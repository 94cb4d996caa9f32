// Panels that several tests share.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <string>

#include "toile/base/error.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::pattern::test {

/// A square of 100 mm with the edges bottom, right, top, left.
inline Panel square() {
  Panel panel;
  panel.name = "square";
  panel.outline = {{"bottom", Curve::line({0.0, 0.0}, {100.0, 0.0})},
                   {"right", Curve::line({100.0, 0.0}, {100.0, 100.0})},
                   {"top", Curve::line({100.0, 100.0}, {0.0, 100.0})},
                   {"left", Curve::line({0.0, 100.0}, {0.0, 0.0})}};
  return panel;
}

/// Clockwise.
inline Loop round_hole(const Vec2& centre, double radius, const std::string& name) {
  return {{name, Curve::circular(centre, radius, 2.0 * M_PI, 0.0)}};
}

/// Two panels with everything that a file can hold: curves of all kinds, a hole, lines, notches, grain, placement,
/// stitches of whole edges and of parts.
inline Pattern everything() {
  Panel front = square();
  front.name = "front";
  front.outline[1].curve = Curve::spline({{100.0, 0.0}, {90.0, 30.0}, {104.0, 70.0}, {100.0, 100.0}});
  front.outline[2].curve = Curve::joined({Curve::line({100.0, 100.0}, {70.0, 100.0}),
                                          Curve::circular({70.0, 100.0}, {30.0, 100.0}, 25.0, false, false),
                                          Curve::line({30.0, 100.0}, {0.0, 100.0})});
  front.outline[3].curve = Curve::cubic({0.0, 100.0}, {-20.0, 60.0}, {15.0, 40.0}, {0.0, 0.0});
  front.holes = {round_hole({40.0, 50.0}, 8.0, "buttonhole")};
  front.lines = {{"dart", Curve::polyline({{60.0, 20.0}, {65.0, 60.0}, {70.0, 20.0}})},
                 {"pocket", Curve::quadratic({20.0, 20.0}, {30.0, 35.0}, {50.0, 20.0})}};
  front.notches = {{"n1", "right", 0.4}, {"n2", "bottom", 0.25}};
  front.grain = Grain{{50.0, 30.0}, {50.0, 80.0}};
  front.placement = Placement{Eigen::AngleAxisd(0.4, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix(),
                              {10.0, -20.0, 300.0}};
  Panel back = square();
  back.name = "back & side";
  back.placement = Placement{};
  return {{front, back},
          {{"side seam", "front.right[n1:end]", "back & side.left[0.5:1]", true},
           {"shoulder", "front.top", "back & side.top", false}}};
}

/// Message of the InputError that something ends in.
inline std::string message(const std::function<void()>& work) {
  try {
    work();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Largest distance between points of the same relative arc length of two curves.
inline double distance(const Curve& a, const Curve& b) {
  double most = 0.0;
  for (int k = 0; k <= 100; ++k) most = std::max(most, (a.at(k / 100.0) - b.at(k / 100.0)).norm());
  return most;
}

/// Two panels agree: names and curves of edges, holes and lines, notches and grain.
inline void expect_same(const Panel& a, const Panel& b, double tolerance) {
  const auto same_loop = [&](const Loop& x, const Loop& y) {
    ASSERT_EQ(x.size(), y.size()) << a.name;
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_EQ(x[k].name, y[k].name);
      EXPECT_LT(distance(x[k].curve, y[k].curve), tolerance) << x[k].name;
    }
  };
  EXPECT_EQ(a.name, b.name);
  same_loop(a.outline, b.outline);
  ASSERT_EQ(a.holes.size(), b.holes.size());
  for (std::size_t h = 0; h < a.holes.size(); ++h) same_loop(a.holes[h], b.holes[h]);
  ASSERT_EQ(a.lines.size(), b.lines.size());
  for (std::size_t k = 0; k < a.lines.size(); ++k) {
    EXPECT_EQ(a.lines[k].name, b.lines[k].name);
    EXPECT_LT(distance(a.lines[k].curve, b.lines[k].curve), tolerance) << a.lines[k].name;
  }
  ASSERT_EQ(a.notches.size(), b.notches.size());
  for (std::size_t k = 0; k < a.notches.size(); ++k) {
    EXPECT_EQ(a.notches[k].name, b.notches[k].name);
    EXPECT_EQ(a.notches[k].edge, b.notches[k].edge);
    EXPECT_NEAR(a.notches[k].at, b.notches[k].at, tolerance / a.edge(a.notches[k].edge)->curve.length());
  }
  ASSERT_EQ(a.grain.has_value(), b.grain.has_value());
  if (a.grain) {
    EXPECT_LT((a.grain->from - b.grain->from).norm() + (a.grain->to - b.grain->to).norm(), tolerance);
  }
}

inline void expect_same_placement(const Panel& a, const Panel& b, double tolerance) {
  ASSERT_TRUE(a.placement && b.placement);
  EXPECT_LT((a.placement->rotation - b.placement->rotation).norm(), 1e-9);
  EXPECT_LT((a.placement->translation - b.placement->translation).norm(), tolerance);
}

inline void expect_same_stitches(const Pattern& a, const Pattern& b) {
  ASSERT_EQ(a.stitches.size(), b.stitches.size());
  for (std::size_t k = 0; k < a.stitches.size(); ++k) {
    EXPECT_EQ(a.stitches[k].name, b.stitches[k].name);
    EXPECT_EQ(a.stitches[k].first, b.stitches[k].first);
    EXPECT_EQ(a.stitches[k].second, b.stitches[k].second);
    EXPECT_EQ(a.stitches[k].reversed, b.stitches[k].reversed);
  }
}

}  // namespace toile::pattern::test
