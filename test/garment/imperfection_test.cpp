#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "lists.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;
using test::input_error;
using test::reals;
using ::testing::HasSubstr;

mesh::Mesh build(const Teuchos::ParameterList& panels) {
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, nullptr).mesh;
}

/// A flat panel of 40 x 20 mm with 8 x 4 elements and an imperfection of 0.1 mm.
Teuchos::ParameterList imperfect() {
  Teuchos::ParameterList panels;
  test::add_rectangle(panels, "front", 40.0, 20.0, 8, 4).sublist("Imperfection").set("amplitude", 0.1);
  return panels;
}

Teuchos::ParameterList& list_of(Teuchos::ParameterList& panels) {
  return panels.sublist("front").sublist("Imperfection");
}

Teuchos::ParameterList waves(double across, double along) {
  Teuchos::ParameterList panels = imperfect();
  list_of(panels).set("type", std::string("waves"));
  list_of(panels).set("half-waves", reals({across, along}));
  return panels;
}

// A random imperfection moves the inner nodes along the normal within its amplitude, and no node on an edge.
TEST(Imperfection, MovesInnerNodesOnly) {
  const mesh::Mesh mesh = build(imperfect());
  std::set<int> rim;
  for (const auto& [name, nodes] : mesh.edges) rim.insert(nodes.begin(), nodes.end());
  double largest = 0.0;
  for (int node = 0; node < mesh.nodes(); ++node) {
    const Vec3& at = mesh.placed[node];
    EXPECT_EQ(at.head<2>(), mesh.pattern[node]);
    EXPECT_EQ(at.z() == 0.0, rim.count(node) == 1);
    EXPECT_EQ(mesh.normal[node], Vec3(0.0, 0.0, 1.0));
    largest = std::max(largest, std::abs(at.z()));
  }
  EXPECT_LE(largest, 0.1);
  EXPECT_GT(largest, 0.05);
}

// The same seed gives the same offsets on every platform; another seed gives others.
TEST(Imperfection, IsDeterministic) {
  Teuchos::ParameterList panels = imperfect();
  const double first = build(panels).placed[10].z();
  EXPECT_EQ(build(panels).placed[10].z(), first);
  list_of(panels).set("seed", 5489);
  // The first number that the generator makes from its standard seed, by the language standard's reference engine.
  EXPECT_DOUBLE_EQ(build(panels).placed[10].z(),
                   0.1 * (2.0 * (14514284786278117030ull / 18446744073709551616.0) - 1.0));
  EXPECT_NE(build(panels).placed[10].z(), first);
}

// On a curved start the offset is along the normal of the surface.
TEST(Imperfection, FollowsTheNormal) {
  Teuchos::ParameterList panels = imperfect();
  Teuchos::ParameterList& placement = panels.sublist("front").sublist("Placement");
  placement.set("type", std::string("sphere"));
  placement.set("radius", 50.0);
  const mesh::Mesh mesh = build(panels);
  for (int node = 0; node < mesh.nodes(); ++node) {
    EXPECT_NEAR(mesh.placed[node].normalized().dot(mesh.normal[node]), 1.0, 1e-14);
    EXPECT_LE(std::abs(mesh.placed[node].norm() - 50.0), 0.1 + 1e-12);
  }
  EXPECT_GT(std::abs(mesh.placed[10].norm() - 50.0), 1e-4);
}

// Waves are a product of sines with the stated number of half-waves, whatever the grading.
TEST(Imperfection, Waves) {
  Teuchos::ParameterList panels = waves(3.0, 1.0);
  panels.sublist("front").set("grading across", 2.0);
  const mesh::Mesh mesh = build(panels);
  for (int node = 0; node < mesh.nodes(); ++node) {
    const double x = mesh.pattern[node].x() / 40.0, y = mesh.pattern[node].y() / 20.0;
    EXPECT_NEAR(mesh.placed[node].z(), 0.1 * std::sin(3.0 * M_PI * x) * std::sin(M_PI * y), 1e-14);
  }
}

// Bad numbers of half-waves, a seed where nothing is random, and a panel without inner nodes are refused.
TEST(Imperfection, BadInputIsRefused) {
  const auto message = [](const Teuchos::ParameterList& panels) { return input_error([&panels] { build(panels); }); };
  EXPECT_THAT(message(waves(1.5, 1.0)), HasSubstr("needs two whole numbers"));
  EXPECT_THAT(message(waves(0.0, 1.0)), HasSubstr("is out of range: 0, allowed: >= 1"));
  EXPECT_THAT(message(waves(5.0, 1.0)), HasSubstr("the mesh cannot show so many"));
  Teuchos::ParameterList seeded = waves(1.0, 1.0);
  list_of(seeded).set("seed", 3);
  EXPECT_THAT(message(seeded), HasSubstr("unknown parameter \"seed\""));
  Teuchos::ParameterList narrow = imperfect();
  narrow.sublist("front").set("elements along", 1);
  EXPECT_THAT(message(narrow), HasSubstr("the panel has no inner nodes to move"));
}

}  // namespace
}  // namespace toile::garment
