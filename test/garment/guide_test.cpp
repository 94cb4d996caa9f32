// Panels placed along a line on the body.
#include <gmock/gmock.h>

#include <cmath>

#include "lists.hpp"
#include "surfaces.hpp"
#include "toile/base/error.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;
using test::reals;

constexpr double radius = 40.0;

/// A panel 60 x 100 mm, its middle line on the guide.
Teuchos::ParameterList along(const std::vector<double>& guide) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& panel = test::add_panel(panels, "front", "rectangle", 12, 20);
  panel.set("width", 60.0).set("height", 100.0);
  Teuchos::ParameterList& placement = panel.sublist("Placement");
  placement.set("type", std::string("along guide")).set("guide", reals(guide)).set("centre", 30.0);
  return panels;
}

mesh::Mesh build(const Teuchos::ParameterList& panels, const body::Surface* body) {
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, body).mesh;
}

// Along the axis of a cylinder the panel is rolled onto it, also beyond the line's ends: x to the right seen from
// outside.
TEST(AlongGuide, IsRolledRoundACylinder) {
  const test::EllipticCylinder cylinder(radius, radius);
  const mesh::Mesh mesh = build(along({41.0, 0.0, 10.0, 39.0, 0.0, 70.0}), &cylinder);
  for (int n = 0; n < mesh.nodes(); ++n) {
    const double angle = (mesh.pattern[n].x() - 30.0) / radius;
    const Vec3 wanted(radius * std::cos(angle), radius * std::sin(angle), 10.0 + mesh.pattern[n].y());
    EXPECT_LT((mesh.placed[n] - wanted).norm(), 5e-3) << n;
    EXPECT_LT((mesh.normal[n] - Vec3(std::cos(angle), std::sin(angle), 0.0)).norm(), 2e-4) << n;
  }
}

// Along a helix, which is straight on a cylinder, no side of an element changes its length.
TEST(AlongGuide, IsNotStretchedAlongAHelix) {
  const test::EllipticCylinder cylinder(radius, radius);
  std::vector<double> helix;
  for (int k = 0; k <= 40; ++k)
    helix.insert(helix.end(), {radius * std::cos(0.05 * k), radius * std::sin(0.05 * k), 1.5 * k});
  const mesh::Mesh mesh = build(along(helix), &cylinder);
  const std::vector<int>& nodes = mesh.blocks[0].connectivity;
  const double chord = 5.0 * 5.0 / (24.0 * radius * radius);  // a side is a chord of the surface
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int a = nodes[k], b = nodes[k % 4 == 3 ? k - 3 : k + 1];
    const double length = (mesh.placed[a] - mesh.placed[b]).norm();
    EXPECT_NEAR(length / (mesh.pattern[a] - mesh.pattern[b]).norm(), 1.0, chord + 1e-3);
  }
}

// A line that leaves the body, or is none, is an error that says where and what.
TEST(AlongGuide, RefusesALineOffTheBody) {
  const test::Sphere sphere(radius, 5.0);
  const auto message = [&](const std::vector<double>& guide, const body::Surface* body) {
    try {
      build(along(guide), body);
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using testing::HasSubstr;
  EXPECT_THAT(message({60.0, 0.0, 0.0, 60.0, 0.0, 20.0}, &sphere), HasSubstr("the panel would lie off the body"));
  EXPECT_THAT(message({40.0, 0.0, 0.0, 1.0}, &sphere), HasSubstr("has 4 numbers"));
  EXPECT_THAT(message({40.0, 0.0, 0.0, 40.0, 0.0, 0.0}, &sphere), HasSubstr("has no length on the body"));
  EXPECT_THAT(message({40.0, 0.0, 0.0, 40.0, 0.0, 9.0}, nullptr), HasSubstr("needs a body"));
}

}  // namespace
}  // namespace toile::garment
