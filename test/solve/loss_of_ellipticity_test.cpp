// Fabric that is no stable material where a stage ends or fails: the run finds it and says where and in which state.
#include "toile/solve/loss_of_ellipticity.hpp"

#include <gmock/gmock.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// The sheared, compressed state in which the published Itskov fabric is known to lose ellipticity: F = (u, v).
const solve::Vec3 sheared_u(0.95, 0.0, 0.0), sheared_v(2.3, 1.15, 0.0);

const material::LawV1& itskov_law() {
  return *material::find("itskov");
}

std::vector<double> pantyhose_values(const material::LawV1& law) {
  return {law.sets[0].values, law.sets[0].values + law.n_params};
}

std::shared_ptr<material::Material> itskov() {
  return std::make_shared<material::Material>(itskov_law(), pantyhose_values(itskov_law()), 1.0);
}

std::shared_ptr<material::Material> relaxed_itskov(material::Relaxation relaxation) {
  return std::make_shared<material::Material>(
      itskov_law(), pantyhose_values(itskov_law()), 1.0,
      std::make_shared<material::RelaxedResponse>(itskov_law(), relaxation, 1e-4));
}

/// The hosiery fabric with its polynomials taken beyond their calibrated range.
std::shared_ptr<material::Material> literal_rebar() {
  const material::LawV1& rebar = *material::find("rebar");
  std::vector<double> values = pantyhose_values(rebar);
  for (int p = 0; p < rebar.n_params; ++p)
    if (std::string(rebar.info[p].name) == "calibrated strain") values[p] = 5.0;
  return std::make_shared<material::Material>(rebar, values, 1.0);
}

/// One panel with a homogeneous deformation, held along its outline.
Panels homogeneous(std::shared_ptr<material::Material> fabric, const solve::Vec3& u, const solve::Vec3& v) {
  Panels panels(std::move(fabric));
  panels.add(solve::Vec3::Zero(), u, v, 0);
  panels.hold_outline(0);
  return panels;
}

solve::LossOfEllipticity loss_of(const Panels& panels) {
  return find_loss_of_ellipticity(panels.problem, placed_state(panels.problem));
}

// Of two panels the one that is sheared into the bad state is named, with the number of its points, an element of it
// and where that is, the state there, and the eigenvalue and direction of that state.
TEST(LossOfEllipticity, NamesPanelPlaceAndState) {
  Panels panels(itskov());
  panels.add(solve::Vec3::Zero(), 1.1 * solve::Vec3::UnitX(), 1.1 * solve::Vec3::UnitY(), 0);
  panels.add(solve::Vec3(0.0, 100.0, 0.0), sheared_u, sheared_v, 0);
  const solve::LossOfEllipticity loss = loss_of(panels);
  ASSERT_EQ(loss.panels.size(), 1u);
  EXPECT_EQ(loss.panels[0].name, "panel1");
  EXPECT_EQ(loss.panels[0].points, 4 * Panels::across * Panels::along);
  EXPECT_EQ(loss.panels[0].of, 4 * Panels::across * Panels::along);
  EXPECT_EQ(loss.panel, "panel1");
  ASSERT_GE(loss.element, 1);
  ASSERT_LE(loss.element, Panels::across * Panels::along);
  const double i = (loss.element - 1) % Panels::across + 0.5, j = (loss.element - 1) / Panels::across + 0.5;
  EXPECT_NEAR(loss.pattern[0], Panels::size * i, 1e-12);
  EXPECT_NEAR(loss.pattern[1], Panels::size * j, 1e-12);
  const solve::Vec3 place = solve::Vec3(0.0, 100.0, 0.0) + Panels::size * (i * sheared_u + j * sheared_v);
  EXPECT_LT((loss.position - place).norm(), 1e-10);

  const std::array<double, 3> C = {sheared_u.squaredNorm(), sheared_v.squaredNorm(), sheared_u.dot(sheared_v)};
  std::array<double, 3> S;
  std::array<double, 6> D;
  double W, stretch;
  std::uint8_t status;
  const material::PlainResponse response(itskov_law());
  const std::vector<double> values = pantyhose_values(itskov_law());
  response.evaluate(1, C.data(), values.data(), 0, &W, S.data(), D.data(), &stretch, &status);
  const material::Ellipticity expected = material::ellipticity(C, S, D);
  for (size_t a = 0; a < 3; ++a) EXPECT_NEAR(loss.C[a], C[a], 1e-12) << a;
  EXPECT_NEAR(loss.value.smallest, expected.smallest, 1e-9 * expected.largest);
  EXPECT_NEAR(loss.shear_modulus, 0.0303, 1e-4);
  EXPECT_THAT(loss.text(),
              AllOf(HasSubstr("48 of 48 points of panel \"panel1\""), HasSubstr("worst in panel \"panel1\", element "),
                    HasSubstr("stretch 0.95 along the wale and 2.57 along the course"), HasSubstr("tension field")));
}

// A run that ends in the bad state warns of it; one whose fabric is healthy does not.
TEST(LossOfEllipticity, IsAWarningOfARunThatConverges) {
  const Panels bad = homogeneous(itskov(), sheared_u, sheared_v);
  Recorded run(bad.problem);
  run.simulation.run(stage("settle"));
  EXPECT_THAT(run.simulation.warnings(),
              Contains(HasSubstr("stage \"stage\": in its final state the fabric loses strong ellipticity")));
  const Panels good = homogeneous(itskov(), 1.2 * solve::Vec3::UnitX(), solve::Vec3(0.3, 1.1, 0.0));
  Recorded healthy(good.problem);
  healthy.simulation.run(stage("settle"));
  EXPECT_THAT(healthy.simulation.warnings(), IsEmpty());
}

// Fabric that softens in tension is told from fabric that is compressed: the literal hosiery law beyond a course
// stretch of 3.4, while at 3.2 it is elliptic.
TEST(LossOfEllipticity, SofteningInTension) {
  const solve::Vec3 u(0.6, 0.0, 0.0);
  EXPECT_FALSE(loss_of(homogeneous(literal_rebar(), u, 3.2 * solve::Vec3::UnitY())).found());
  const solve::LossOfEllipticity loss = loss_of(homogeneous(literal_rebar(), u, 3.8 * solve::Vec3::UnitY()));
  ASSERT_TRUE(loss.found());
  EXPECT_THAT(loss.text(), AllOf(HasSubstr("softens in tension"), Not(HasSubstr("tension field"))));
  EXPECT_NEAR(std::abs(loss.value.direction[1]), 1.0, 1e-6);
}

// A stage that fails because its fabric softens says so: the literal hosiery fabric pulled along the course.
TEST(LossOfEllipticity, IsPartOfTheMessageOfAStageThatFails) {
  Panels strip(literal_rebar());
  strip.add(solve::Vec3::Zero(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
  for (const int j : {0, Panels::along}) {
    std::vector<int> nodes;
    for (int i = 0; i <= Panels::across; ++i) nodes.push_back(Panels::node(0, i, j));
    strip.hold_nodes(nodes, {true, true, true});
  }
  strip.problem.supports.back().displacement = solve::Vec3(0.0, 3.5 * Panels::size * Panels::along, 0.0);
  std::vector<int> all;
  for (int n = 0; n < Panels::nodes(); ++n) all.push_back(n);
  strip.hold_nodes(all, {false, false, true});
  Recorded run(strip.problem);
  EXPECT_THAT(failure_of(run.simulation, stage("load")),
              AllOf(HasSubstr("could not reach its end"), HasSubstr("the fabric loses strong ellipticity"),
                    HasSubstr("of panel \"panel0\"")));
}

// A tension field keeps a wrinkled, compressed fabric elliptic; slack fibres do not: they
// still carry shear where they carry no tension.
TEST(LossOfEllipticity, TensionFieldKeepsIt) {
  for (const auto& [u, v] : {std::pair<solve::Vec3, solve::Vec3>(sheared_u, sheared_v),
                             {solve::Vec3(1.4, 0.0, 0.0), solve::Vec3(0.3, 0.4, 0.0)},
                             {solve::Vec3(0.7, 0.0, 0.0), solve::Vec3(0.1, 0.8, 0.0)}})
    EXPECT_FALSE(loss_of(homogeneous(relaxed_itskov(material::Relaxation::tension_field), u, v)).found());
  const Panels slack = homogeneous(relaxed_itskov(material::Relaxation::slack_fibres), solve::Vec3(0.7, 0.0, 0.0),
                                   solve::Vec3(0.2, 0.8, 0.0));
  EXPECT_TRUE(loss_of(slack).found());
}

// Shells are looked at too, at their mid-surface.
TEST(LossOfEllipticity, OfShells) {
  Panels panels = homogeneous(itskov(), sheared_u, sheared_v);
  panels.make_shells(0.01);
  const solve::LossOfEllipticity loss = loss_of(panels);
  ASSERT_TRUE(loss.found());
  EXPECT_EQ(loss.panels[0].points, 4 * Panels::across * Panels::along);
}

// Graduated fabric has the law and the modulus of its place: a compressed sheet of Saint Venant-Kirchhoff fabric (nu =
// 0.3, stretch l in every direction) whose modulus doubles along it has everywhere the eigenvalue (2 l^2 - 1 - nu)/(1 -
// nu) times its own shear modulus.
TEST(LossOfEllipticity, OfGraduatedFabric) {
  const double nu = 0.3, l = 0.7;
  Teuchos::ParameterList list("fabric");
  list.set("type", "isotropic-elastic");
  list.set("Poisson's ratio", nu);
  Teuchos::ParameterList& table = list.sublist("Young's modulus");
  table.set("position", Teuchos::Array<double>(std::vector<double>{0.0, 1.0}));
  table.set("value", Teuchos::Array<double>(std::vector<double>{0.1, 0.2}));
  const auto fabric =
      std::make_shared<material::Material>(base::validate(list, material::material_spec(), "fabric.xml"));
  const solve::LossOfEllipticity loss =
      loss_of(homogeneous(fabric, l * solve::Vec3::UnitX(), l * solve::Vec3::UnitY()));
  ASSERT_TRUE(loss.found());
  EXPECT_EQ(loss.panels[0].points, loss.panels[0].of);
  EXPECT_NEAR(loss.value.smallest / loss.shear_modulus, (2.0 * l * l - 1.0 - nu) / (1.0 - nu), 1e-10);
  const double position = ((loss.element - 1) / Panels::across + 0.5) / Panels::along;
  EXPECT_NEAR(loss.shear_modulus, 0.1 * (1.0 + position) / (2.0 * (1.0 + nu)), 1e-12);
}

}  // namespace
}  // namespace toile::test
