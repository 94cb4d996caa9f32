// Forces on the garment, from their lists.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>

#include "panels.hpp"
#include "stages.hpp"
#include "toile/base/error.hpp"
#include "toile/solve/spec.hpp"

namespace toile::test {
namespace {

constexpr double density = 150.0, gravity = 9.80665;  // g/m^2, m/s^2

/// Two panels of 30 x 40 mm.
Panels two_panels() {
  Panels panels(neo_hookean());
  panels.add(solve::Vec3::Zero(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
  panels.add(solve::Vec3(0.0, 0.0, 50.0), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
  return panels;
}

solve::Loads weight(const Panels& panels, Teuchos::ParameterList entry = {}) {
  Teuchos::ParameterList list("Loads");
  entry.set("type", "weight").set("area density", density);
  list.sublist("own").setParameters(entry);
  return solve::read_loads(base::validate(list, solve::loads_spec(), "scene.xml"), panels.mesh);
}

solve::Vec3 sum(const solve::NodalLoad& load) {
  double shares = 0.0;
  for (const double share : load.share) shares += share;
  return shares * load.value;
}

// The weight of all panels is their area times area density times 9.80665 m/s^2, downwards.
TEST(Loads, WeightOfAllPanels) {
  const Panels panels = two_panels();
  const double expected = density * 1e-3 * gravity * 2.0 * 30.0 * 40.0 * 1e-6;  // N
  EXPECT_LT((sum(weight(panels).nodal.at(0)) + expected * solve::Vec3::UnitZ()).norm(), 1e-14 * expected);
}

// Of one panel, in another direction, only that panel weighs.
TEST(Loads, WeightOfOnePanelInADirection) {
  const Panels panels = two_panels();
  Teuchos::ParameterList entry;
  entry.set("on", Teuchos::Array<std::string>(1, "panel1"));
  entry.set("direction", Teuchos::Array<double>(std::vector<double>{0.0, 3.0, -4.0}));
  const solve::NodalLoad load = weight(panels, entry).nodal.at(0);
  for (const int node : load.nodes) EXPECT_GE(node, Panels::nodes());
  const double expected = density * 1e-3 * gravity * 30.0 * 40.0 * 1e-6;
  EXPECT_LT((sum(load) - expected * solve::Vec3(0.0, 0.6, -0.8)).norm(), 1e-14 * expected);
}

// Elements of any shape share their weight by their shape functions, so that its moments are those of the area: a panel
// of trapezoids whose width grows evenly, about its lower edge.
TEST(Loads, WeightOfUnevenElements) {
  Panels panels(neo_hookean());
  panels.add(solve::Vec3::Zero(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
  const auto width = [](double y) { return 1.0 + 0.02 * y; };  // over that at y = 0
  for (mesh::Vec2& at : panels.mesh.pattern) at[0] *= width(at[1]);
  const solve::NodalLoad load = weight(panels).nodal.at(0);
  double area = 0.0, moment = 0.0;
  for (size_t i = 0; i < load.nodes.size(); ++i) {
    area += load.share[i];
    moment += load.share[i] * panels.mesh.pattern[load.nodes[i]][1];
  }
  EXPECT_NEAR(area, 30.0 * (40.0 + 0.01 * 1600.0), 1e-10);
  EXPECT_NEAR(moment, 30.0 * (800.0 + 0.02 / 3.0 * 64000.0), 1e-9);
}

// A panel that there is not, and a direction without length, are refused.
TEST(Loads, BadWeight) {
  const Panels panels = two_panels();
  const auto refusal = [&](const Teuchos::ParameterList& entry) -> std::string {
    try {
      weight(panels, entry);
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  Teuchos::ParameterList name, direction;
  name.set("on", Teuchos::Array<std::string>(1, "panel2"));
  direction.set("direction", Teuchos::Array<double>(3, 0.0));
  EXPECT_THAT(refusal(name), testing::HasSubstr("no panel is named \"panel2\""));
  EXPECT_THAT(refusal(direction), testing::HasSubstr("has no length"));
}

}  // namespace
}  // namespace toile::test
