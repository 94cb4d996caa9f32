#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lists.hpp"
#include "surfaces.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;
using test::input_error;
using test::reals;

/// A panel of 60 x 40 mm with `per_side` elements each way.
Teuchos::ParameterList panel(const std::string& type, int per_side) {
  Teuchos::ParameterList panels;
  test::add_rectangle(panels, "front", 60.0, 40.0, per_side, per_side).sublist("Placement").set("type", type);
  return panels;
}

Teuchos::ParameterList& placement_of(Teuchos::ParameterList& panels) {
  return panels.sublist("front").sublist("Placement");
}

Teuchos::ParameterList wrapped(const std::string& type, int per_side) {
  Teuchos::ParameterList panels = panel(type, per_side);
  placement_of(panels).set("axis bottom", reals({0.0, 0.0, 0.0}));
  placement_of(panels).set("axis top", reals({0.0, 3.0, 4.0}));
  placement_of(panels).set("from", 5.0);
  placement_of(panels).set("to", 45.0);
  return panels;
}

Teuchos::ParameterList on_cone(int per_side) {
  Teuchos::ParameterList panels = wrapped("free wrap", per_side);
  placement_of(panels).set("around", reals({40.0, 70.0}));
  return panels;
}

Teuchos::ParameterList on_sphere(int per_side) {
  Teuchos::ParameterList panels = panel("sphere", per_side);
  placement_of(panels).set("radius", 50.0);
  return panels;
}

mesh::Mesh build(const Teuchos::ParameterList& panels, const body::Surface* body = nullptr) {
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, body).mesh;
}

/// Largest cosine between a node's normal and the sides of its elements; every normal must be a unit vector on the
/// right side of the fabric.
double largest_slope(const mesh::Mesh& mesh) {
  double worst = 0.0;
  EXPECT_EQ(mesh.normal.size(), mesh.placed.size());
  for (const Vec3& normal : mesh.normal) EXPECT_NEAR(normal.norm(), 1.0, 1e-14);
  const std::vector<int>& nodes = mesh.blocks[0].connectivity;
  for (std::size_t e = 0; e < nodes.size(); e += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      const int here = nodes[e + k];
      const Vec3 next = (mesh.placed[nodes[e + (k + 1) % 4]] - mesh.placed[here]).normalized();
      const Vec3 last = (mesh.placed[nodes[e + (k + 3) % 4]] - mesh.placed[here]).normalized();
      EXPECT_GT(next.cross(last).dot(mesh.normal[here]), 0.5);
      worst = std::max({worst, std::abs(next.dot(mesh.normal[here])), std::abs(last.dot(mesh.normal[here]))});
    }
  }
  return worst;
}

// A flat panel has the normal of its plane everywhere.
TEST(Normal, FlatPanel) {
  Teuchos::ParameterList panels = panel("flat", 4);
  EXPECT_EQ(build(panels).normal.front(), Vec3(0.0, 0.0, 1.0));
  placement_of(panels).set("x direction", reals({0.0, 2.0, 0.0}));
  placement_of(panels).set("y direction", reals({0.0, 0.0, 5.0}));
  EXPECT_THAT(build(panels).normal, ::testing::AllOf(::testing::SizeIs(25), ::testing::Each(Vec3(1.0, 0.0, 0.0))));
  panels.sublist("front").remove("Placement");
  EXPECT_THAT(build(panels).normal, ::testing::Each(Vec3(0.0, 0.0, 1.0)));
}

// On a cone the normal leans by the taper.
TEST(Normal, ConeLeans) {
  const Vec3 axis(0.0, 0.6, 0.8);
  for (const Vec3& normal : build(on_cone(4)).normal) EXPECT_NEAR(normal.dot(axis), -0.6, 1e-13);
}

// The sides of the elements become perpendicular to the normals of their ends with first order, on every surface: the
// error is the angle between a chord and its tangent.
TEST(Normal, PerpendicularInTheLimit) {
  const test::EllipticCylinder body(80.0, 50.0);
  const auto on_body = [&body](int per_side) {
    Teuchos::ParameterList panels = wrapped("wrap", per_side);
    placement_of(panels).set("offset", 3.0);
    return largest_slope(build(panels, &body));
  };
  EXPECT_NEAR(largest_slope(build(on_cone(16))) / largest_slope(build(on_cone(32))), 2.0, 0.05);
  EXPECT_NEAR(largest_slope(build(on_sphere(16))) / largest_slope(build(on_sphere(32))), 2.0, 0.05);
  EXPECT_NEAR(on_body(16) / on_body(32), 2.0, 0.1);
}

// Panels that meet at a seam keep normals of their own.
TEST(Normal, NotSharedAcrossASeam) {
  Teuchos::ParameterList panels, seams;
  test::add_rectangle(panels, "floor", 20.0, 20.0, 2, 2);
  Teuchos::ParameterList& wall = test::add_rectangle(panels, "wall", 20.0, 20.0, 2, 2).sublist("Placement");
  wall.set("y direction", reals({0.0, 0.0, 1.0}));
  test::add_seam(seams, "corner", "floor.bottom", "wall.bottom");
  const base::List seam_list = base::validate(seams, seams_spec(), "scene.xml");
  const Garment garment = build_garment(base::validate(panels, panels_spec(), "scene.xml"), &seam_list, nullptr);
  for (const auto& [a, b] : garment.seams[0].pairs) {
    EXPECT_EQ(garment.mesh.normal[a], Vec3(0.0, 0.0, 1.0));
    EXPECT_EQ(garment.mesh.normal[b], Vec3(0.0, -1.0, 0.0));
  }
}

/// Elliptic cylinder that gives no answer in a narrow sector, between the rays by which a section is traced.
class BlindSpot : public test::EllipticCylinder {
 public:
  BlindSpot() : EllipticCylinder(80.0, 50.0) {}
  body::SurfacePoint closest(const body::Vec3& point) const override {
    body::SurfacePoint result = EllipticCylinder::closest(point);
    const double angle = std::atan2(point.y(), point.x());
    result.found = angle < 0.01 || angle > 0.04;
    return result;
  }
};

// A panel where the body's surface cannot be asked has no normal, which is said.
TEST(Normal, OutOfReachIsRefused) {
  Teuchos::ParameterList panels = wrapped("wrap", 64);
  placement_of(panels).set("axis top", reals({0.0, 0.0, 1.0}));
  placement_of(panels).set("offset", 3.0);
  EXPECT_THAT(input_error([&panels] {
                const BlindSpot body;
                build(panels, &body);
              }),
              ::testing::HasSubstr("parameter \"offset\" = 3: the body's surface is out of reach from there"));
}

}  // namespace
}  // namespace toile::garment
