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
    mesh_.blocks.emplace_back();
    mesh_.blocks.back().nodes_per_element = nodes_per_element;
    mesh_.blocks.back().connectivity =
        nodes_per_element == 4 ? std::vector<int>{0, 1, 2, 3} : std::vector<int>{0, 1, 2, 0, 2, 3};
    problem_.mesh = &mesh_;
    problem_.surface = body_.get();
  }
  Flat(const Flat&) = delete;

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
        const double longest = nodes == 4 ? side : std::sqrt(2.0) * side;
        if (height < 0.2 * longest) {
          EXPECT_EQ(pierced.elements, 0);
          continue;
        }
        EXPECT_GE(pierced.elements, 1);
        EXPECT_THAT(pierced.height, DoubleNear(std::min(height, longest), 0.1 * height));
        EXPECT_NEAR(pierced.share, pierced.height / longest, 1e-12);
        EXPECT_EQ(pierced.unseen(), pierced.share > 0.5);
      }
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
