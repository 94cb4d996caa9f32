#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lists.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using test::input_error;
using test::reals;
using ::testing::HasSubstr;

/// A rectangle of 100 x 80 mm, meshed freely, with its wale at 30 degrees.
Teuchos::ParameterList rectangle(const std::string& elements) {
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& panel = panels.sublist("front");
  panel.set("material", std::string("knit"));
  panel.set("shape", std::string("rectangle"));
  panel.set("width", 100.0);
  panel.set("height", 80.0);
  panel.set("mesher", std::string("free"));
  panel.set("element size", 9.0);
  panel.set("elements", elements);
  panel.set("wale angle", 30.0);
  return panels;
}

Teuchos::ParameterList& zone(Teuchos::ParameterList& panels, const std::string& name) {
  return panels.sublist("front").sublist("Zones").sublist(name);
}

std::vector<Panel> build(const Teuchos::ParameterList& panels) {
  return build_panels(base::validate(panels, panels_spec(), "scene.xml"), nullptr);
}

double area_of(const Panel& panel, const std::string& zone) {
  double twice = 0.0;
  for (const mesh::PanelPart& part : panel.mesh.parts) {
    if (part.zone != zone) continue;
    const std::size_t per = static_cast<std::size_t>(part.nodes_per_element);
    for (std::size_t k = 0; k < part.connectivity.size(); ++k) {
      const std::size_t next = k % per + 1 == per ? k + 1 - per : k + 1;
      const mesh::Vec2 &a = panel.mesh.nodes[static_cast<std::size_t>(part.connectivity[k])],
                       &b = panel.mesh.nodes[static_cast<std::size_t>(part.connectivity[next])];
      twice += a.x() * b.y() - a.y() * b.x();
    }
  }
  return 0.5 * twice;
}

class ZonesOf : public ::testing::TestWithParam<const char*> {};

// Elements follow the border of a band and of a patch: the zones have exactly the areas that were drawn. What a zone
// leaves out it has from the panel.
TEST_P(ZonesOf, HaveTheAreasThatWereDrawn) {
  Teuchos::ParameterList panels = rectangle(GetParam());
  zone(panels, "band").set("band", reals({50.0, 73.0}));
  zone(panels, "band").set("material", std::string("firm"));
  zone(panels, "patch").set("border", reals({31.0, 12.0, 67.0, 12.0, 49.0, 41.0}));
  zone(panels, "patch").set("wale angle", 45.0);
  const Panel panel = build(panels).front();
  EXPECT_NEAR(area_of(panel, "band"), 2300.0, 1e-6);
  EXPECT_NEAR(area_of(panel, "patch"), 0.5 * 36.0 * 29.0, 1e-6);
  EXPECT_NEAR(area_of(panel, ""), 8000.0 - 2300.0 - 522.0, 1e-6);
  EXPECT_EQ(panel.fabrics.at("band").material, "firm");
  EXPECT_NEAR(panel.fabrics.at("band").wale_angle, M_PI / 6.0, 1e-12);
  EXPECT_EQ(panel.fabrics.at("patch").material, "knit");
  EXPECT_NEAR(panel.fabrics.at("patch").wale_angle, M_PI / 4.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ZonesOf, ::testing::Values("quadrilateral", "triangle"),
                         [](const auto& instance) { return std::string(instance.param); });

// A zone and a panel whose parts would have one name in the results are refused, both named.
TEST(Zones, NamesOfPartsDiffer) {
  Teuchos::ParameterList panels = rectangle("quadrilateral");
  zone(panels, "z").set("band", reals({10.0, 20.0}));
  panels.set("front-z", rectangle("quadrilateral").sublist("front"));
  EXPECT_THAT(input_error([&] { cut_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr); }),
              HasSubstr("zone \"z\" of panel \"front\" and panel \"front-z\" would both be named \"front-z\""));
}

// A zone that cannot be is refused with its name and what is allowed.
TEST(Zones, BadOnesAreRefused) {
  const auto message = [](const std::function<void(Teuchos::ParameterList&)>& change) {
    Teuchos::ParameterList panels = rectangle("quadrilateral");
    change(panels);
    return input_error([&] { build(panels); });
  };
  EXPECT_THAT(message([](auto& panels) { zone(panels, "a").set("material", std::string("firm")); }),
              HasSubstr("a zone needs exactly one of the three"));
  EXPECT_THAT(message([](auto& panels) {
                zone(panels, "a").set("band", reals({10.0, 20.0}));
                zone(panels, "a").set("point", reals({10.0, 20.0}));
              }),
              HasSubstr("a zone needs exactly one of the three"));
  EXPECT_THAT(message([](auto& panels) {
                zone(panels, "a").set("band", reals({20.0, 10.0}));
              }),
              HasSubstr("the lowest y of the zone and the highest"));
  EXPECT_THAT(message([](auto& panels) {
                zone(panels, "a").set("border", reals({20.0, 10.0, 3.0}));
              }),
              HasSubstr("at least three of them"));
  EXPECT_THAT(message([](auto& panels) {
                zone(panels, "a").set("band", reals({100.0, 120.0}));
              }),
              HasSubstr("holds no fabric of panel \"front\", which has x from 0 to 100, y from 0 to 80 mm"));
  EXPECT_THAT(message([](auto& panels) {
                Teuchos::ParameterList& panel = panels.sublist("front");
                panel.remove("element size");
                panel.set("mesher", std::string("structured"));
                panel.set("elements across", 4);
                panel.set("elements along", 4);
                zone(panels, "a").set("band", reals({10.0, 20.0}));
              }),
              HasSubstr("need \"free\""));
}

}  // namespace
}  // namespace toile::garment
