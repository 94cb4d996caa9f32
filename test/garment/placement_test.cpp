#include "toile/garment/garment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "lists.hpp"
#include "surfaces.hpp"
#include "toile/body/analytic.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;
using test::EllipticCylinder;
using test::input_error;
using test::reals;
using ::testing::HasSubstr;

mesh::Mesh build(const Teuchos::ParameterList& panels, const body::Surface* body = nullptr) {
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, body).mesh;
}

/// A rectangular panel round the z axis.
Teuchos::ParameterList wrapped(const std::string& type, double width, double height, int across, int along) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& placement =
      test::add_rectangle(panels, "front", width, height, across, along).sublist("Placement");
  placement.set("type", type);
  placement.set("axis bottom", reals({0.0, 0.0, 0.0}));
  placement.set("axis top", reals({0.0, 0.0, 500.0}));
  placement.set("from", 100.0);
  placement.set("to", 100.0 + height);
  return panels;
}

Teuchos::ParameterList& placement_of(Teuchos::ParameterList& panels) {
  return panels.sublist("front").sublist("Placement");
}

/// Largest relative change of length from pattern to space of the element sides.
double largest_strain(const mesh::Mesh& mesh) {
  double worst = 0.0;
  for (const mesh::Block& block : mesh.blocks) {
    for (std::size_t k = 0; k < block.connectivity.size(); ++k) {
      const std::size_t next = k % 4 == 3 ? k - 3 : k + 1;
      const int a = block.connectivity[k], b = block.connectivity[next];
      const double before = (mesh.pattern[a] - mesh.pattern[b]).norm();
      worst = std::max(worst, std::abs((mesh.placed[a] - mesh.placed[b]).norm() / before - 1.0));
    }
  }
  return worst;
}

// Without a placement the pattern lies in the x-y plane of space.
TEST(Placement, DefaultIsThePlane) {
  Teuchos::ParameterList panels;
  test::add_rectangle(panels, "front", 30.0, 20.0, 3, 2);
  const mesh::Mesh mesh = build(panels);
  for (int node = 0; node < mesh.nodes(); ++node) {
    EXPECT_EQ(mesh.placed[node], Vec3(mesh.pattern[node].x(), mesh.pattern[node].y(), 0.0));
  }
}

// A flat placement moves and turns the pattern without stretching it, whatever the length of the directions.
TEST(Placement, FlatMovesAndTurns) {
  Teuchos::ParameterList panels;
  test::add_rectangle(panels, "front", 30.0, 20.0, 3, 2);
  placement_of(panels).set("origin", reals({1.0, 2.0, 3.0}));
  placement_of(panels).set("x direction", reals({0.0, 2.0, 0.0}));
  placement_of(panels).set("y direction", reals({0.0, 0.0, 5.0}));
  const mesh::Mesh mesh = build(panels);
  EXPECT_NEAR((mesh.placed.back() - Vec3(1.0, 32.0, 23.0)).norm(), 0.0, 1e-12);
  EXPECT_LT(largest_strain(mesh), 1e-14);
}

// Directions that are not perpendicular, zero or no vectors are refused.
TEST(Placement, BadDirectionsAreRefused) {
  Teuchos::ParameterList panels;
  test::add_rectangle(panels, "front", 30.0, 20.0, 3, 2);
  placement_of(panels).set("y direction", reals({1.0, 1.0, 0.0}));
  EXPECT_THAT(input_error([&panels] { build(panels); }), HasSubstr("must be perpendicular to \"x direction\""));
  placement_of(panels).set("y direction", reals({0.0, 0.0, 0.0}));
  EXPECT_THAT(input_error([&panels] { build(panels); }), HasSubstr("must not be zero"));
  placement_of(panels).set("y direction", reals({0.0, 1.0}));
  EXPECT_THAT(input_error([&panels] { build(panels); }), HasSubstr("has 2 numbers; a vector in space needs three"));
}

// A panel of natural width on a cylinder is unstretched to second order of the element size.
TEST(Placement, NaturalWrapIsIsometric) {
  const EllipticCylinder body(60.0, 60.0);
  const double coarse = largest_strain(build(wrapped("wrap", 200.0, 100.0, 10, 5), &body));
  const double fine = largest_strain(build(wrapped("wrap", 200.0, 100.0, 20, 10), &body));
  EXPECT_LT(fine, 2e-3);
  EXPECT_GT(coarse, 0.0);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}

// The panel's right side faces outwards, its centre line lies at the angle, its ends at the stated heights.
TEST(Placement, WrapLiesOutsideAtItsAngleAndHeight) {
  const EllipticCylinder body(60.0, 60.0);
  Teuchos::ParameterList panels = wrapped("wrap", 100.0, 50.0, 4, 5);
  placement_of(panels).set("angle", 90.0);
  placement_of(panels).set("offset", 3.0);
  const mesh::Mesh mesh = build(panels, &body);
  EXPECT_NEAR((mesh.placed[mesh.edges.at("front.bottom")[2]] - Vec3(0.0, 63.0, 100.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((mesh.placed[mesh.edges.at("front.top")[2]] - Vec3(0.0, 63.0, 150.0)).norm(), 0.0, 1e-6);
  for (std::size_t e = 0; e < mesh.blocks[0].connectivity.size(); e += 4) {
    const int* id = &mesh.blocks[0].connectivity[e];
    const Vec3 normal = (mesh.placed[id[2]] - mesh.placed[id[0]]).cross(mesh.placed[id[3]] - mesh.placed[id[1]]);
    const Vec3 at = mesh.placed[id[0]];
    EXPECT_GT(normal.dot(Vec3(at.x(), at.y(), 0.0)), 0.0);
  }
}

// Coverage stretches the panel uniformly round a section that is not circular.
TEST(Placement, CoverageStretchesUniformly) {
  const EllipticCylinder body(80.0, 50.0);
  Teuchos::ParameterList panels = wrapped("wrap", 100.0, 50.0, 400, 1);
  placement_of(panels).set("coverage", 0.5);
  const mesh::Mesh mesh = build(panels, &body);
  const double girth = 4.0 * 80.0 * std::comp_ellint_2(std::sqrt(1.0 - 2500.0 / 6400.0));
  const std::vector<int>& bottom = mesh.edges.at("front.bottom");
  for (int i = 0; i < 400; ++i) {
    EXPECT_NEAR((mesh.placed[bottom[i + 1]] - mesh.placed[bottom[i]]).norm(), 0.5 * girth / 400, 1e-4 * girth / 400);
  }
}

// Two half panels at 0 and 180 degrees meet on a section that is neither circular nor centred on the axis.
TEST(Placement, HalvesMeet) {
  const EllipticCylinder body(80.0, 50.0);
  Teuchos::ParameterList panels = wrapped("wrap", 100.0, 50.0, 8, 3);
  placement_of(panels).set("axis bottom", reals({20.0, 10.0, 0.0}));
  placement_of(panels).set("axis top", reals({20.0, 10.0, 1.0}));
  placement_of(panels).set("coverage", 0.5);
  panels.sublist("back") = panels.sublist("front");
  panels.sublist("back").sublist("Placement").set("angle", 180.0);
  const mesh::Mesh mesh = build(panels, &body);
  for (int j = 0; j <= 3; ++j) {
    const auto gap = [&mesh, j](const char* a, const char* b) {
      return (mesh.placed[mesh.edges.at(a)[j]] - mesh.placed[mesh.edges.at(b)[j]]).norm();
    };
    EXPECT_NEAR(gap("front.right", "back.left"), 0.0, 1e-6);
    EXPECT_NEAR(gap("front.left", "back.right"), 0.0, 1e-6);
  }
}

// A free wrap lies exactly on its cone, with a hoop stretch that follows the coverage.
TEST(Placement, FreeWrapLiesOnCone) {
  Teuchos::ParameterList panels = wrapped("free wrap", 100.0, 50.0, 6, 5);
  placement_of(panels).set("around", reals({40.0, 60.0}));
  placement_of(panels).set("coverage", 1.0);
  const mesh::Mesh mesh = build(panels);
  for (const Vec3& at : mesh.placed) {
    EXPECT_NEAR(std::hypot(at.x(), at.y()), 40.0 + 20.0 * (at.z() - 100.0) / 50.0, 1e-9);
  }
  const Vec3 left = mesh.placed[mesh.edges.at("front.left")[3]], right = mesh.placed[mesh.edges.at("front.right")[3]];
  EXPECT_NEAR((left - right).norm(), 0.0, 1e-9);
  EXPECT_NEAR(left.x(), -std::hypot(left.x(), left.y()), 1e-9);
}

// A free wrap rolls a rectangle without strain: a quarter of a cylinder and a shallow roof have every node at its arc
// length round the axis and its height, exactly.
TEST(Placement, FreeWrapRollsWithoutStrain) {
  for (const auto& [radius, half_angle, height] :
       {std::array{100.0, M_PI / 4, 100.0}, std::array{2540.0, 0.1, 508.0}}) {
    Teuchos::ParameterList panels = wrapped("free wrap", 2.0 * radius * half_angle, height, 8, 4);
    placement_of(panels).set("around", reals({radius, radius}));
    const mesh::Mesh mesh = build(panels);
    for (int node = 0; node < mesh.nodes(); ++node) {
      const double angle = mesh.pattern[node].x() / radius - half_angle;
      const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);
      const Vec3 wanted = radius * outwards + Vec3(0.0, 0.0, 100.0 + mesh.pattern[node].y());
      EXPECT_NEAR((mesh.placed[node] - wanted).norm(), 0.0, 1e-12 * radius);
      EXPECT_NEAR((mesh.normal[node] - outwards).norm(), 0.0, 1e-12);
    }
  }
}

// So does a free mesh, whatever round-off the nodes of its straight hems have.
TEST(Placement, FreeWrapOfAFreeMeshRollsWithoutStrain) {
  for (const auto& [width, height] :
       {std::array{254.0, 254.0}, std::array{100.0 * M_PI / 2, 100.0}, std::array{0.3, 0.7}, std::array{97.3, 311.9}}) {
    const double radius = 2.0 * width;
    Teuchos::ParameterList panels = wrapped("free wrap", width, height, 8, 4);
    Teuchos::ParameterList& panel = panels.sublist("front");
    panel.remove("elements across");
    panel.remove("elements along");
    panel.set("mesher", std::string("free")).set("element size", 0.1 * width);
    placement_of(panels).set("around", reals({radius, radius}));
    const mesh::Mesh mesh = build(panels);
    double worst = 0.0;
    for (int node = 0; node < mesh.nodes(); ++node) {
      const double angle = (mesh.pattern[node].x() - 0.5 * width) / radius;
      const Vec3 wanted(radius * std::cos(angle), radius * std::sin(angle), 100.0 + mesh.pattern[node].y());
      worst = std::max(worst, (mesh.placed[node] - wanted).norm());
    }
    EXPECT_LT(worst, 1e-9 * width) << width << " x " << height;
  }
}

Teuchos::ParameterList hemisphere(double width, double height) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& placement = test::add_rectangle(panels, "front", width, height, 8, 6).sublist("Placement");
  placement.set("type", std::string("sphere"));
  placement.set("radius", 10.0);
  return panels;
}

// On a sphere the pattern's coordinates are arc lengths along equator and meridian, and normals point outwards.
TEST(Placement, SphereByLongitudeAndLatitude) {
  const mesh::Mesh mesh = build(hemisphere(5.0 * M_PI, 4.0 * M_PI));
  for (int node = 0; node < mesh.nodes(); ++node) {
    const double longitude = mesh.pattern[node].x() / 10.0, latitude = mesh.pattern[node].y() / 10.0;
    const Vec3 outwards(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                        std::sin(latitude));
    EXPECT_NEAR((mesh.placed[node] - 10.0 * outwards).norm(), 0.0, 1e-13);
    EXPECT_NEAR((mesh.normal[node] - outwards).norm(), 0.0, 1e-14);
  }
  // The hole of 18 degrees round the pole.
  EXPECT_NEAR(mesh.placed.back().z(), 10.0 * std::cos(M_PI / 10), 1e-13);
}

// Centre, polar axis and zero direction move and turn the sphere.
TEST(Placement, SphereIsMovedAndTurned) {
  Teuchos::ParameterList panels = hemisphere(5.0 * M_PI, 4.0 * M_PI);
  placement_of(panels).set("centre", reals({1.0, 2.0, 3.0}));
  placement_of(panels).set("polar axis", reals({2.0, 0.0, 0.0}));
  placement_of(panels).set("zero direction", reals({1.0, 1.0, 0.0}));
  const mesh::Mesh mesh = build(panels);
  EXPECT_NEAR((mesh.placed[mesh.edges.at("front.bottom").front()] - Vec3(1.0, 12.0, 3.0)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((mesh.placed[mesh.edges.at("front.bottom").back()] - Vec3(1.0, 2.0, 13.0)).norm(), 0.0, 1e-13);
}

// A pattern that reaches the pole or overlaps itself is refused, and a zero direction along the axis.
TEST(Placement, BadSpheresAreRefused) {
  EXPECT_THAT(input_error([] { build(hemisphere(10.0, 5.0 * M_PI)); }),
              HasSubstr("the pattern reaches the latitude 90 degrees; it must end before the pole at 90 degrees"));
  EXPECT_THAT(input_error([] { build(hemisphere(22.0 * M_PI, 10.0)); }),
              HasSubstr("the pattern is 396 degrees long round the equator; it must not overlap itself"));
  Teuchos::ParameterList panels = hemisphere(10.0, 10.0);
  placement_of(panels).set("polar axis", reals({1.0, 0.0, 0.0}));
  EXPECT_THAT(input_error([&panels] { build(panels); }), HasSubstr("must not be parallel to the axis"));
}

// Each mistake in a wrapped placement has its message.
TEST(Placement, BadWrapsAreRefused) {
  const EllipticCylinder body(60.0, 60.0);
  const auto message = [&body](const std::function<void(Teuchos::ParameterList&)>& spoil, double width = 100.0) {
    Teuchos::ParameterList panels = wrapped("wrap", width, 50.0, 4, 5);
    spoil(placement_of(panels));
    return input_error([&] { build(panels, &body); });
  };
  using List = Teuchos::ParameterList;
  EXPECT_THAT(message([](List& list) { list.set("to", 100.0); }), HasSubstr("must be above \"from\""));
  EXPECT_THAT(message([](List& list) {
                list.set("axis top", reals({0.0, 0.0, 0.0}));
              }),
              HasSubstr("must differ from \"axis bottom\""));
  EXPECT_THAT(message([](List& list) {
                list.set("zero direction", reals({0.0, 0.0, 1.0}));
              }),
              HasSubstr("must not be parallel to the axis"));
  EXPECT_THAT(message([](List& list) {
                list.set("axis bottom", reals({70.0, 0.0, 0.0}));
                list.set("axis top", reals({70.0, 0.0, 1.0}));
              }),
              HasSubstr("the axis is not inside the body at the height 100 mm"));
  EXPECT_THAT(message([](List&) {}, 400.0),
              HasSubstr("the pattern is 400 mm wide at the height 100 mm, but the girth there is 376.991 mm"));
}

// A panel that is wrapped beyond an end of its body is refused with that end and its own heights.
TEST(Placement, BodyThatEnds) {
  const auto body = body::ellipsoid(60.0, 130.0);
  const auto message = [&body](double from, double to) {
    Teuchos::ParameterList panels = wrapped("wrap", 100.0, 50.0, 4, 5);
    placement_of(panels).set("from", from);
    placement_of(panels).set("to", to);
    return input_error([&] { build(panels, body.get()); });
  };
  EXPECT_THAT(message(40.0, 300.0), HasSubstr("parameter \"to\" = 300: the body ends at 130 mm along the axis, but the "
                                              "panel is wrapped from 40 to 300 mm"));
  EXPECT_THAT(message(-200.0, 0.0), HasSubstr("parameter \"from\" = -200: the body ends at -130 mm along the axis"));
}

// A wrapped panel needs a body, a free one its two radii.
TEST(Placement, MissingBodyIsRefused) {
  const Teuchos::ParameterList on_body = wrapped("wrap", 100.0, 50.0, 4, 5);
  EXPECT_THAT(input_error([&on_body] { build(on_body); }), HasSubstr("\"wrap\" needs a body, and the scene has none"));
  Teuchos::ParameterList free = wrapped("free wrap", 100.0, 50.0, 4, 5);
  placement_of(free).set("around", reals({40.0}));
  EXPECT_THAT(input_error([&free] { build(free); }), HasSubstr("needs two radii"));
}

// A pattern whose rows do not rise cannot be wrapped level by level.
TEST(Placement, RowsMustRise) {
  Teuchos::ParameterList panels = wrapped("free wrap", 100.0, 50.0, 4, 5);
  placement_of(panels).set("around", reals({40.0, 40.0}));
  Teuchos::ParameterList& panel = panels.sublist("front");
  panel.set("shape", std::string("four-sided"));
  panel.remove("width");
  panel.remove("height");
  panel.set("bottom", reals({0, 0, 0, 40}));
  panel.set("right", reals({0, 40, -100, 40}));
  panel.set("top", reals({-100, 0, -100, 40}));
  panel.set("left", reals({0, 0, -100, 0}));
  EXPECT_THAT(input_error([&panels] { build(panels); }),
              HasSubstr("the rows of the pattern must rise along its y axis"));
}

}  // namespace
}  // namespace toile::garment
