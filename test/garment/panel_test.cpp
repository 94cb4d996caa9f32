#include "toile/garment/panel.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lists.hpp"

namespace toile::garment {
namespace {

using test::input_error;
using test::reals;
using ::testing::HasSubstr;

Panel build(const Teuchos::ParameterList& panels) {
  return build_panels(base::validate(panels, panels_spec(), "scene.xml"), nullptr).front();
}

/// A four-sided panel "front" with straight sides.
Teuchos::ParameterList quadrangle(const std::vector<double>& bottom, const std::vector<double>& right,
                                  const std::vector<double>& top, const std::vector<double>& left) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& panel = panels.sublist("front");
  panel.set("material", std::string("knit"));
  panel.set("shape", std::string("four-sided"));
  panel.set("elements across", 4);
  panel.set("elements along", 5);
  panel.set("bottom", reals(bottom));
  panel.set("right", reals(right));
  panel.set("top", reals(top));
  panel.set("left", reals(left));
  return panels;
}

Teuchos::ParameterList leg(const std::vector<double>& levels, const std::vector<double>& widths) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& panel = panels.sublist("leg");
  panel.set("material", std::string("knit"));
  panel.set("shape", std::string("profile"));
  panel.set("elements across", 8);
  panel.set("elements along", 40);
  panel.set("levels", reals(levels));
  panel.set("widths", reals(widths));
  return panels;
}

// A rectangle has the stated size, elements, material and wale direction; wale runs along y by default.
TEST(Panel, Rectangle) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& entry = test::add_rectangle(panels, "front", 150.0, 50.0, 6, 4);
  const Panel panel = build(panels);
  EXPECT_EQ(panel.name, "front");
  EXPECT_EQ(panel.fabrics.at("").material, "knit");
  EXPECT_DOUBLE_EQ(panel.fabrics.at("").wale_angle, M_PI / 2.0);
  EXPECT_EQ(panel.mesh.parts.front().connectivity.size(), 4u * 24u);
  EXPECT_NEAR((panel.mesh.nodes.back() - mesh::Vec2(150.0, 50.0)).norm(), 0.0, 1e-12);
  entry.set("wale angle", 45.0);
  entry.set("elements", std::string("triangle"));
  entry.set("grading across", 2.0);
  const Panel other = build(panels);
  EXPECT_DOUBLE_EQ(other.fabrics.at("").wale_angle, M_PI / 4.0);
  EXPECT_EQ(other.mesh.parts.front().connectivity.size(), 3u * 48u);
  EXPECT_NEAR(other.mesh.nodes[1].x(), 150.0 * 0.5 / 9.0, 1e-12);
}

// A four-sided panel has its nodes on the given sides, curved ones included.
TEST(Panel, FourSided) {
  const Panel panel =
      build(quadrangle({0, 0, 50, -10, 100, 0}, {100, 0, 90, 120}, {10, 120, 90, 120}, {0, 0, 10, 120}));
  EXPECT_NEAR((panel.mesh.nodes[panel.mesh.node(2, 0)] - mesh::Vec2(50.0, -10.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((panel.mesh.nodes[panel.mesh.node(4, 5)] - mesh::Vec2(90.0, 120.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((panel.mesh.nodes[panel.mesh.node(0, 1)] - mesh::Vec2(2.0, 24.0)).norm(), 0.0, 1e-12);
}

// A side of straight lines keeps its kink.
TEST(Panel, PolylineSide) {
  Teuchos::ParameterList panels =
      quadrangle({0, 0, 50, 0, 100, 0}, {100, 0, 100, 100}, {0, 100, 100, 100}, {0, 0, -30, 40, 0, 100});
  panels.sublist("front").set("sides", std::string("polyline"));
  panels.sublist("front").set("elements along", 50);
  const Panel panel = build(panels);
  for (int j = 0; j <= 20; ++j) {
    const mesh::Vec2 node = panel.mesh.nodes[panel.mesh.node(0, j)];
    EXPECT_NEAR(4.0 * node.x() + 3.0 * node.y(), 0.0, 1e-9);
  }
}

// A profile is symmetric, has level rows and the stated widths.
TEST(Panel, ProfileHasItsWidths) {
  const Panel panel = build(leg({0.0, 100.0, 250.0, 400.0}, {100.0, 170.0, 150.0, 260.0}));
  const mesh::PanelMesh& grid = panel.mesh;
  for (int j = 0; j < grid.rows(); ++j) {
    const mesh::Vec2 left = grid.nodes[grid.node(0, j)], right = grid.nodes[grid.node(8, j)];
    EXPECT_NEAR(left.x(), -right.x(), 1e-9);
    EXPECT_NEAR((grid.nodes[grid.node(2, j)] - (0.75 * left + 0.25 * right)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(left.y(), right.y(), 1e-9);
  }
  EXPECT_NEAR(grid.nodes[grid.node(8, 0)].x(), 50.0, 1e-12);
  EXPECT_NEAR(grid.nodes[grid.node(8, 40)].x(), 130.0, 1e-12);
  EXPECT_NEAR(grid.nodes[grid.node(8, 40)].y(), 400.0, 1e-12);
}

// An outline that crosses itself is refused with the panel's name and the crossing.
TEST(Panel, CrossingOutlineIsRefused) {
  const auto panels = quadrangle({0, 0, 100, 0}, {100, 0, 20, 100}, {80, 100, 20, 100}, {0, 0, 80, 100});
  const std::string message = input_error([&panels] { build(panels); });
  EXPECT_THAT(message,
              HasSubstr("panel \"front\": it overlaps itself near (50, 62.5) mm of its pattern; its outline must "
                        "not cross or touch itself"));
  EXPECT_THAT(message, HasSubstr("scene.xml"));
}

// Sides that do not meet are refused with both ends.
TEST(Panel, OpenOutlineIsRefused) {
  const auto panels = quadrangle({0, 0, 100, 0}, {100, 0, 100, 90}, {0, 100, 100, 100}, {0, 0, 0, 100});
  EXPECT_THAT(
      input_error([&panels] { build(panels); }),
      HasSubstr("the outline of panel \"front\" is not closed: the end of right at (100, 90) and the end of top "
                "at (100, 100) must be the same point"));
}

// A panel that is given mirrored is refused with the order that is expected.
TEST(Panel, ClockwiseOutlineIsRefused) {
  const auto panels = quadrangle({100, 0, 0, 0}, {0, 0, 0, 100}, {100, 100, 0, 100}, {100, 0, 100, 100});
  EXPECT_THAT(
      input_error([&panels] { build(panels); }),
      HasSubstr("panel \"front\": the outline must run counter-clockwise and holes clockwise, seen from the right "
                "side of the fabric"));
}

// A simple outline whose inside folds over is refused with the place.
TEST(Panel, FoldedInsideIsRefused) {
  const auto panels = quadrangle({0, 0, 100, 0}, {100, 0, 20, 20}, {0, 100, 20, 20}, {0, 0, 0, 100});
  EXPECT_THAT(input_error([&panels] { build(panels); }),
              ::testing::AllOf(HasSubstr("panel \"front\" overlaps itself near ("), HasSubstr("scene.xml"),
                               HasSubstr("an element is turned over there")));
}

// Points of a side must come in pairs that differ.
TEST(Panel, BadPointsAreRefused) {
  const auto odd = quadrangle({0, 0, 100}, {100, 0, 100, 100}, {0, 100, 100, 100}, {0, 0, 0, 100});
  EXPECT_THAT(input_error([&odd] { build(odd); }), HasSubstr("has 3 numbers; allowed are pairs x, y"));
  const auto twice = quadrangle({0, 0, 0, 0, 100, 0}, {100, 0, 100, 100}, {0, 100, 100, 100}, {0, 0, 0, 100});
  EXPECT_THAT(input_error([&twice] { build(twice); }), HasSubstr("repeats its point number 1"));
}

// A profile needs as many widths as levels, and levels that increase.
TEST(Panel, BadProfileIsRefused) {
  EXPECT_THAT(input_error([] { build(leg({0.0}, {100.0})); }), HasSubstr("has fewer than two values"));
  EXPECT_THAT(input_error([] {
                build(leg({0.0, 100.0, 200.0}, {100.0, 120.0}));
              }),
              HasSubstr("has 2 values, but \"levels\" has 3; there must be one width for each level"));
  EXPECT_THAT(input_error([] {
                build(leg({0.0, 100.0, 100.0}, {100.0, 120.0, 130.0}));
              }),
              HasSubstr("must increase strictly, but value number 3 does not"));
}

// A sector has its outer arc as bottom and its sides at the two angles; a full turn is allowed.
TEST(Panel, Sector) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& entry = test::add_sector(panels, 120.0, 6, 4);
  entry.set("from angle", 30.0);
  const mesh::PanelMesh grid = build(panels).mesh;
  EXPECT_NEAR((grid.nodes[grid.node(4, 0)] - 10.0 * mesh::Vec2(0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((grid.nodes[grid.node(4, 4)] - 6.0 * mesh::Vec2(0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((grid.nodes[grid.node(0, 1)] - 9.0 * mesh::Vec2(std::cos(M_PI / 6), 0.5)).norm(), 0.0, 1e-12);
  entry.set("to angle", 390.0);
  const mesh::PanelMesh ring = build(panels).mesh;
  EXPECT_NEAR((ring.nodes[ring.node(6, 2)] - ring.nodes[ring.node(0, 2)]).norm(), 0.0, 1e-12);
}

// A sector needs radii and angles that increase, and at most one turn.
TEST(Panel, BadSectorIsRefused) {
  const auto message = [](const std::string& name, double value) {
    Teuchos::ParameterList panels;
    test::add_sector(panels, 90.0, 6, 4).set(name, value);
    return input_error([&panels] { build(panels); });
  };
  EXPECT_THAT(message("inner radius", 10.0),
              HasSubstr("parameter \"inner radius\" = 10: must be smaller than \"outer radius\""));
  EXPECT_THAT(message("inner radius", 0.0),
              HasSubstr("parameter \"inner radius\" is out of range: 0 mm, allowed: > 0"));
  for (const double angle : {0.0, -20.0, 361.0}) {
    EXPECT_THAT(message("to angle", angle),
                HasSubstr("must lie beyond \"from angle\" by more than 0 and at most 360 degrees"));
  }
}

// A disc has its rim on all sides, a quarter disc on its right and top.
TEST(Panel, Discs) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& entry = test::add_panel(panels, "drum", "disc", 4, 4);
  entry.set("radius", 20.0);
  const mesh::PanelMesh whole = build(panels).mesh;
  for (const int id : whole.edges.at("left")) EXPECT_NEAR(whole.nodes[id].norm(), 20.0, 1e-12);
  EXPECT_NEAR((whole.nodes[whole.node(2, 0)] - mesh::Vec2(0.0, -20.0)).norm(), 0.0, 1e-12);
  entry.set("shape", std::string("quarter disc"));
  const mesh::PanelMesh quarter = build(panels).mesh;
  EXPECT_NEAR(quarter.nodes[0].norm(), 0.0, 1e-12);
  EXPECT_NEAR((quarter.nodes[quarter.node(4, 0)] - mesh::Vec2(20.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((quarter.nodes[quarter.node(0, 4)] - mesh::Vec2(0.0, 20.0)).norm(), 0.0, 1e-12);
}

// Without a list "Shell" a panel is a membrane; with an empty one it is a shell with the defaults.
TEST(Panel, ShellHasDefaults) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& entry = test::add_rectangle(panels, "front", 30.0, 20.0, 3, 2);
  EXPECT_FALSE(build(panels).shell);
  entry.sublist("Shell");
  const auto shell = build(panels).shell;
  ASSERT_TRUE(shell);
  EXPECT_FALSE(shell->reduced);
  EXPECT_EQ(shell->layers, 3);
  EXPECT_FALSE(shell->shear_modulus);
  EXPECT_DOUBLE_EQ(shell->shear_correction, 5.0 / 6.0);
  EXPECT_FALSE(shell->placed_is_stress_free);
}

// Every option of a shell is read.
TEST(Panel, ShellIsRead) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& list = test::add_rectangle(panels, "front", 30.0, 20.0, 3, 2).sublist("Shell");
  list.set("integration", std::string("reduced"));
  list.set("layers", 5);
  list.set("shear modulus", 0.2);
  list.set("shear correction", 1.0);
  list.set("stress-free", std::string("placed"));
  const auto shell = build(panels).shell;
  ASSERT_TRUE(shell);
  EXPECT_TRUE(shell->reduced);
  EXPECT_EQ(shell->layers, 5);
  EXPECT_DOUBLE_EQ(shell->shear_modulus.value_or(0.0), 0.2);
  EXPECT_DOUBLE_EQ(shell->shear_correction, 1.0);
  EXPECT_TRUE(shell->placed_is_stress_free);
}

// A shell has an odd number of layers up to 7, positive shear stiffness, and no reduced triangles.
TEST(Panel, BadShellIsRefused) {
  const auto message = [](const auto& spoil) {
    Teuchos::ParameterList panels;
    spoil(test::add_rectangle(panels, "front", 30.0, 20.0, 3, 2));
    return input_error([&panels] { build(panels); });
  };
  using List = Teuchos::ParameterList;
  for (const int layers : {2, 4, 9}) {
    EXPECT_THAT(message([layers](List& panel) { panel.sublist("Shell").set("layers", layers); }),
                HasSubstr("scene.xml: Panels > front > Shell: parameter \"layers\" = " + std::to_string(layers) +
                          ": allowed are 1, 3, 5 and 7"));
  }
  EXPECT_THAT(message([](List& panel) { panel.sublist("Shell").set("shear modulus", 0.0); }),
              HasSubstr("parameter \"shear modulus\" is out of range: 0 MPa, allowed: > 0"));
  EXPECT_THAT(message([](List& panel) { panel.sublist("Shell").set("shear correction", 1.2); }),
              HasSubstr("parameter \"shear correction\" is out of range: 1.2"));
  EXPECT_THAT(message([](List& panel) { panel.sublist("Shell").set("integration", std::string("reducd")); }),
              HasSubstr("did you mean \"reduced\"?"));
  EXPECT_THAT(message([](List& panel) {
                panel.set("elements", std::string("triangle"));
                panel.sublist("Shell").set("integration", std::string("reduced"));
              }),
              HasSubstr("the panel has triangles, which have one rule only"));
}

}  // namespace
}  // namespace toile::garment
