#include "toile/run/pierced.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "toile/body/analytic.hpp"

namespace toile::test {
namespace {

using ::testing::DoubleNear;

constexpr double side = 10.0;  // mm

/// A flat element, its middle at the origin, or two triangles in its place; `body`: about the z axis moved by (x, y).
class Flat {
 public:
  Flat(body::SurfacePtr body, int nodes_per_element, double x = 0.0, double y = 0.0, double z = 0.0)
      : body_(std::move(body)) {
    const double h = 0.5 * side;
    for (const auto& [u, v] : {std::pair{-h, -h}, {h, -h}, {h, h}, {-h, h}}) {
      fields_.position.emplace_back(u - x, v - y, z);
      fields_.gap.push_back(body_->closest(fields_.position.back()).gap);
    }
    mesh_.placed = fields_.position;
    mesh_.blocks.emplace_back();
    mesh_.blocks.back().nodes_per_element = nodes_per_element;
    mesh_.blocks.back().connectivity =
        nodes_per_element == 4 ? std::vector<int>{0, 1, 2, 3} : std::vector<int>{0, 1, 2, 0, 2, 3};
    problem_.mesh = &mesh_;
    problem_.surface = body_.get();
  }
  Flat(const Flat&) = delete;

  /// At this height, right over or under where it is.
  Flat& placed_at(double z) {
    mesh_.placed = fields_.position;
    for (auto& x : mesh_.placed) x.z() = z;
    return *this;
  }

  run::Pierced pierced() const { return run::pierced_elements(problem_, fields_); }

 private:
  body::SurfacePtr body_;
  mesh::Mesh mesh_;
  solve::Problem problem_;
  solve::Fields fields_;
};

/// A cone of this half angle, whose tip is `height` above the plane of the element.
body::SurfacePtr cone(double degrees, double height) {
  const double slope = std::tan(degrees * M_PI / 180.0);
  return body::revolution(body::linear_profile(height * slope, -slope), {-100.0, height}, "cone");
}

// A tip sticks out by its height over the element, wherever in it and however slender it is.
TEST(Pierced, HeightIsThatOfTheTip) {
  for (const double degrees : {5.0, 15.0, 45.0})
    for (const int nodes : {3, 4})
      for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.3, 0.1}, {2.7, 1.4}, {-3.1, 3.9}}) {
        SCOPED_TRACE(std::to_string(degrees) + " degrees, " + std::to_string(nodes) + " nodes, at " +
                     std::to_string(x) + ", " + std::to_string(y));
        const double height = 0.8 / std::tan(degrees * M_PI / 180.0);  // of a tip with a radius of 0.8 mm in the plane
        const run::Pierced pierced = Flat(cone(degrees, height), nodes, x, y).pierced();
        if (height < 0.2 * side) {
          EXPECT_EQ(pierced.elements, 0);
          continue;
        }
        EXPECT_GE(pierced.elements, 1);
        EXPECT_THAT(pierced.height, DoubleNear(std::min(height, side), 0.1 * height));
        EXPECT_NEAR(pierced.share, pierced.height / side, 1e-12);
        EXPECT_EQ(pierced.unseen(), pierced.share > 0.5);
      }
}

/// A flat body with a slender cone of 12 mm, as a file of a body may have it, about the z axis.
class Needle : public body::Surface {
 public:
  body::SurfacePoint closest(const body::Vec3& x) const override {
    const body::SurfacePoint tip = cone_->closest(x);
    if (tip.gap < x.z()) return tip;
    return {x.z(), body::Vec3::UnitZ(), body::Mat3::Zero(), {x.x(), x.y(), 0.0}, true};
  }
  double range() const override { return 100.0; }
  body::TriangleMesh triangles(double) const override {
    body::TriangleMesh mesh{{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}, {0, 0, 12}}, {}};
    for (int i = 0; i < 4; ++i) mesh.triangles.push_back({i, (i + 1) % 4, 4});
    return mesh;
  }
  std::string summary() const override { return {}; }

 private:
  body::SurfacePtr cone_ = cone(5.0, 12.0);
};

// A needle at a quarter of an element that lies flat on the body beside it is found, although the body there is as near
// and as flat as under any element.
TEST(Pierced, NeedlesBesideWhatIsLookedAt) {
  for (const auto& [x, y] : {std::pair{2.5, 2.5}, {-2.5, 1.2}, {3.6, -3.9}}) {
    SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(y));
    const run::Pierced pierced = Flat(std::make_shared<Needle>(), 4, x, y).pierced();
    EXPECT_EQ(pierced.elements, 1);
    EXPECT_EQ(pierced.share, 1.0);
  }
}

// Elements that are beyond the body, seen from where they were placed, are told of a garment that presses nowhere.
TEST(Pierced, WhatHasPassedTheBody) {
  EXPECT_EQ(Flat(body::ellipsoid(2.0, 2.0), 4, 0.0, 0.0, -8.0).placed_at(8.0).pierced().passed, 1);
  EXPECT_EQ(Flat(body::ellipsoid(2.0, 2.0), 4, 0.0, 0.0, 4.0).placed_at(8.0).pierced().passed, 0);
  EXPECT_EQ(Flat(body::ellipsoid(2.0, 2.0), 4, 20.0, 0.0, -8.0).placed_at(8.0).pierced().passed, 0);
}

// A ball on which the sides of the element turn by 40 degrees goes through none; one that is smaller does.
TEST(Pierced, RoundBodiesAreSeen) {
  for (const auto& [radius, elements] : {std::pair{1.46 * side, 0}, {0.75 * side, 1}}) {
    SCOPED_TRACE(radius);
    const double level = std::sqrt(radius * radius - 0.5 * side * side);  // the nodes touch
    EXPECT_EQ(Flat(body::ellipsoid(radius, radius), 4, 0.0, 0.0, level).pierced().elements, elements);
  }
}

// A body beside the element, below it or far away sticks out of nothing.
TEST(Pierced, OnlyByWhatIsInside) {
  EXPECT_EQ(Flat(cone(15.0, 5.0), 4, 9.0, 0.0).pierced().elements, 0);
  EXPECT_EQ(Flat(cone(15.0, -0.1), 4, 1.0, 2.0).pierced().elements, 0);
  EXPECT_EQ(Flat(cone(15.0, -50.0), 4).pierced().elements, 0);
}

}  // namespace
}  // namespace toile::test
