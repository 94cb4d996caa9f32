#include <gtest/gtest.h>

#include <cmath>

#include "lists.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment::test {
namespace {

Teuchos::ParameterList& add_wrapped(Teuchos::ParameterList& panels, const std::string& name, double from, double to) {
  Teuchos::ParameterList& placement = add_rectangle(panels, name, 100.0, 100.0, 4, 4).sublist("Placement");
  placement.set("type", std::string("wrap"));
  placement.set("axis bottom", reals({10, 0, 5})).set("axis top", reals({10, 3, 9}));
  placement.set("from", from).set("to", to);
  return placement;
}

std::optional<body::Region> reach(const Teuchos::ParameterList& panels) {
  return reach_of(base::validate(panels, panels_spec(), "scene.xml"));
}

// Panels round one axis reach from the lowest to the highest of them along it, with a margin and a seed on the axis.
TEST(Reach, SpansThePanelsOfOneAxis) {
  Teuchos::ParameterList panels("Panels");
  add_wrapped(panels, "lower", 20.0, 80.0);
  add_wrapped(panels, "upper", 70.0, 150.0);
  const auto region = reach(panels);
  ASSERT_TRUE(region);
  EXPECT_NEAR((region->direction - body::Vec3(0.0, 0.6, 0.8)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(region->bottom, 24.0, 1e-12);
  EXPECT_NEAR(region->top, 154.0, 1e-12);
  EXPECT_GE(region->margin, 45.0);
  EXPECT_NEAR((*region->seed - body::Vec3(10.0, 30.0, 45.0)).norm(), 0.0, 1e-12);
}

// A flat panel, a panel without a placement and a second axis leave open what is reached.
TEST(Reach, IsUnknownOtherwise) {
  Teuchos::ParameterList flat("Panels");
  add_wrapped(flat, "wrapped", 20.0, 80.0);
  add_rectangle(flat, "flat", 100.0, 100.0, 4, 4).sublist("Placement").set("type", std::string("flat"));
  EXPECT_FALSE(reach(flat));
  Teuchos::ParameterList bare("Panels");
  add_rectangle(bare, "bare", 100.0, 100.0, 4, 4);
  EXPECT_FALSE(reach(bare));
  Teuchos::ParameterList legs("Panels");
  add_wrapped(legs, "left", 20.0, 80.0);
  add_wrapped(legs, "right", 20.0, 80.0).set("axis bottom", reals({-10, 0, 5})).set("axis top", reals({-10, 3, 9}));
  EXPECT_FALSE(reach(legs));
}

}  // namespace
}  // namespace toile::garment::test
