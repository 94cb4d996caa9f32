// Wrapped panels whose rows are curved in the pattern.
#include <gtest/gtest.h>

#include <cmath>

#include "lists.hpp"
#include "surfaces.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using mesh::Vec2;
using mesh::Vec3;
using test::reals;

constexpr int across = 40, along = 16;

/// A top with armholes and a neckline (pattern y 65 to 90 mm), wrapped at the height of its pattern.
Teuchos::ParameterList top_of_a_shirt(const std::string& type) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& panel = test::add_panel(panels, "front", "four-sided", across, along);
  panel.set("bottom", reals({-186, 0, 186, 0}));
  panel.set("right", reals({186, 0, 150, 25, 125, 55, 110, 90}));
  panel.set("top", reals({-110, 90, -55, 72, 0, 65, 55, 72, 110, 90}));
  panel.set("left", reals({-186, 0, -150, 25, -125, 55, -110, 90}));
  Teuchos::ParameterList& placement = panel.sublist("Placement");
  placement.set("type", type);
  placement.set("axis bottom", reals({0, 0, 0})).set("axis top", reals({0, 0, 1}));
  placement.set("from", 1142.0).set("to", 1232.0);
  return panels;
}

mesh::Mesh build(const Teuchos::ParameterList& panels, const body::Surface* body) {
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, body).mesh;
}

/// Largest relative change of length from pattern to space of the element sides.
double largest_strain(const mesh::Mesh& mesh) {
  double worst = 0.0;
  const std::vector<int>& nodes = mesh.blocks[0].connectivity;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int a = nodes[k], b = nodes[k % 4 == 3 ? k - 3 : k + 1];
    worst = std::max(
        worst, std::abs((mesh.placed[a] - mesh.placed[b]).norm() / (mesh.pattern[a] - mesh.pattern[b]).norm() - 1.0));
  }
  return worst;
}

// Rolled round a cylinder, a panel with a curved neckline and armholes has every node at its own height and arc length.
TEST(CurvedHem, IsRolledWithoutStrain) {
  Teuchos::ParameterList panels = top_of_a_shirt("free wrap");
  panels.sublist("front").sublist("Placement").set("around", reals({120, 120}));
  const mesh::Mesh mesh = build(panels, nullptr);
  for (int n = 0; n < mesh.nodes(); ++n) {
    const double angle = mesh.pattern[n].x() / 120.0;
    const Vec3 wanted(120.0 * std::cos(angle), 120.0 * std::sin(angle), 1142.0 + mesh.pattern[n].y());
    EXPECT_NEAR((mesh.placed[n] - wanted).norm(), 0.0, 1e-9);
  }
}

// On a body the neckline keeps its height differences, and the panel at its natural width is unstretched (with every
// row level it was stretched to 2.2).
TEST(CurvedHem, KeepsItsHeightsOnABody) {
  const test::EllipticCylinder body(150.0, 110.0);
  const mesh::Mesh mesh = build(top_of_a_shirt("wrap"), &body);
  for (int n = 0; n < mesh.nodes(); ++n) {
    EXPECT_NEAR(mesh.placed[n].z(), 1142.0 + mesh.pattern[n].y(), 1e-9);
    EXPECT_NEAR(body.closest(mesh.placed[n]).gap, 0.0, 5e-5);  // level rows lie on a section of 128 rays, between them
  }
  EXPECT_LT(largest_strain(mesh), 3e-3);
}

// With a coverage the stretch across is the girth of the body over that of the row wherever the body is a cylinder, and
// along it is 1.
TEST(CurvedHem, IsStretchedAcrossOnly) {
  const test::EllipticCylinder body(100.0, 100.0);
  Teuchos::ParameterList panels = top_of_a_shirt("wrap");
  panels.sublist("front").sublist("Placement").set("coverage", 0.5);
  const mesh::Mesh mesh = build(panels, &body);
  for (int j = 0; j <= along; ++j) {
    const int first = j * (across + 1);
    const double width = mesh.pattern[first + across].x() - mesh.pattern[first].x();
    for (int i = 0; i <= across; ++i) {
      const Vec3& x = mesh.placed[first + i];
      EXPECT_NEAR(std::atan2(x.y(), x.x()) / M_PI, mesh.pattern[first + i].x() / width, 1e-6);
      EXPECT_NEAR(x.z(), 1142.0 + mesh.pattern[first + i].y(), 1e-9);
    }
  }
}

// The gore of a flared skirt, whose curved hem is to hang level, is placed row by row when asked for.
TEST(CurvedHem, MayHangLevel) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& panel = test::add_panel(panels, "front", "sector", 12, 6);
  panel.set("inner radius", 300.0).set("outer radius", 500.0).set("from angle", 250.0).set("to angle", 290.0);
  Teuchos::ParameterList& placement = panel.sublist("Placement");
  placement.set("type", std::string("free wrap")).set("rows", std::string("level"));
  placement.set("axis bottom", reals({0, 0, 0})).set("axis top", reals({0, 0, 1}));
  // A cone whose development has the apex at the pattern's origin.
  const double slope = 0.25, rise = 200.0 * std::sqrt(1.0 - slope * slope);
  placement.set("from", 0.0).set("to", rise);
  placement.set("around", reals({500.0 * slope, 300.0 * slope}));
  const mesh::Mesh mesh = build(panels, nullptr);
  for (const int n : mesh.edges.at("front.bottom")) EXPECT_NEAR(mesh.placed[n].z(), 0.0, 1e-9);
  for (const int n : mesh.edges.at("front.top")) EXPECT_NEAR(mesh.placed[n].z(), rise, 1e-9);
  EXPECT_LT(largest_strain(mesh), 0.02);
}

}  // namespace
}  // namespace toile::garment
