#include <gmock/gmock.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include "evaluation.hpp"
#include "toile/base/error.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::material::test {
namespace {

Material make(const Teuchos::ParameterList& list) {
  return Material(base::validate(list, material_spec(), "fabric.xml"));
}

Teuchos::ParameterList entry(const std::string& type, const std::string& set) {
  Teuchos::ParameterList list;
  list.set("type", type);
  list.set("set", set);
  return list;
}

Teuchos::Array<double> array(const std::vector<double>& values) {
  return Teuchos::Array<double>(values);
}

std::string refusal(const Teuchos::ParameterList& list) {
  try {
    make(list);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

double value(const Material& material, const std::string& name, double position = 0.0) {
  return material.params_at(position)[index_of(material.law(), name)];
}

// The registry lists what is built in, in alphabetical order, and finds each by its name.
TEST(Registry, lists_and_finds) {
  ASSERT_EQ(registry().size(), 5u);
  EXPECT_STREQ(registry()[0]->name, "hencky");
  EXPECT_STREQ(registry()[1]->name, "isotropic-elastic");
  EXPECT_STREQ(registry()[2]->name, "itskov");
  EXPECT_STREQ(registry()[3]->name, "neo-hookean");
  EXPECT_STREQ(registry()[4]->name, "rebar");
  for (const LawV1* material : registry()) {
    EXPECT_EQ(find(material->name), material);
    EXPECT_EQ(material->abi, material_abi);
  }
  EXPECT_EQ(find("rubber"), nullptr);
}

// Values in the file override the published set, words become their index, and the thickness is 1 mm by default.
TEST(Material, set_and_overrides) {
  auto list = entry("rebar", "pantyhose");
  list.set("c1", 0.2);
  list.set("strain", "green");
  list.set("fibres in compression", "on");
  const Material material = make(list);
  EXPECT_EQ(value(material, "C10"), 8.4667e-3);
  EXPECT_EQ(value(material, "c1"), 0.2);
  EXPECT_EQ(value(material, "c2"), -2.225);
  EXPECT_EQ(value(material, "strain"), 2.0);
  EXPECT_EQ(value(material, "fibres in compression"), 1.0);
  EXPECT_EQ(material.thickness(), 1.0);
  EXPECT_FALSE(material.graduated());
  EXPECT_EQ(material.params_at(0.3), material.params());
}

// Without a set, what has no default must be given; higher coefficients of the rebar model are zero by default.
TEST(Material, defaults_and_missing_parameters) {
  Teuchos::ParameterList list;
  list.set("type", "rebar");
  list.set("C10", 0.01);
  list.set("c0", 0.1);
  EXPECT_EQ(
      refusal(list),
      "fabric.xml: material: missing parameter \"d0\" of material \"rebar\", expected a double in MPa: "
      "Coefficient of e^0 in the course modulus. Or fill all parameters with \"set\" = \"pantyhose\" or \"t-shirt\"");
  list.set("d0", 0.05);
  const Material material = make(list);
  EXPECT_EQ(value(material, "d0"), 0.05);
  EXPECT_EQ(value(material, "c1"), 0.0);
  EXPECT_EQ(value(material, "calibrated strain"), 1.0);
}

// A law without published sets needs all its parameters, as numbers or tables.
TEST(Material, law_without_sets) {
  Teuchos::ParameterList list;
  list.set("type", std::string("isotropic-elastic"));
  list.set("Young's modulus", 3.0);
  EXPECT_THAT(refusal(list), testing::HasSubstr("missing parameter \"Poisson's ratio\""));
  auto& table = list.sublist("Poisson's ratio");
  table.set("position", array({0.0, 1.0}));
  table.set("value", array({0.1, 0.3}));
  EXPECT_NEAR(value(make(list), "Poisson's ratio", 0.5), 0.2, 1e-15);
  EXPECT_EQ(value(make(list), "Young's modulus", 0.5), 3.0);
}

// A parameter may be a table along the panel: linear between its rows, constant beyond its ends.
TEST(Material, graduated) {
  auto list = entry("neo-hookean", "none");
  auto& table = list.sublist("C10");
  table.set("position", array({0.2, 0.6, 1.0}));
  table.set("value", array({1.0, 3.0, 2.0}));
  const Material material = make(list);
  EXPECT_TRUE(material.graduated());
  const std::vector<std::pair<double, double>> expected = {{0.0, 1.0}, {0.2, 1.0}, {0.3, 1.5},
                                                           {0.6, 3.0}, {0.8, 2.5}, {1.0, 2.0}};
  for (const auto& [position, c10] : expected) EXPECT_NEAR(value(material, "C10", position), c10, 1e-15) << position;
}

// The published T-shirt weights as printed are refused; the shipped T-shirt set and the same with the flag are
// accepted.
TEST(Material, weights_as_printed) {
  auto list = entry("itskov", "t-shirt as printed");
  EXPECT_EQ(
      refusal(list),
      "fabric.xml: material: parameter \"set\" = \"t-shirt as printed\": parameter \"w2_2\": the weights of term 2 "
      "add up to 1.02, so w_3 = 1 - w_1 - w_2 = -0.02 is negative: J can turn negative and the energy is not "
      "polyconvex; set \"normalise weights\" to true to divide the weights by their sum");
  list.set("normalise weights", true);
  EXPECT_EQ(make(list).params(), make(entry("itskov", "t-shirt")).params());
}

// A graduated set is refused where a row of a table violates a condition, with the parameter's name.
TEST(Material, condition_along_the_panel) {
  auto list = entry("itskov", "pantyhose");
  auto& table = list.sublist("w2_1");
  table.set("position", array({0.0, 1.0}));
  table.set("value", array({0.1, 0.3}));
  EXPECT_THAT(refusal(list), testing::HasSubstr("parameter \"w2_1\" = table: the weights of term 1 add up to 1.071"));
}

// Values that are out of range or no choice of the material are refused by the validation, a choice cannot be a table.
TEST(Material, bad_values) {
  auto list = entry("itskov", "pantyhose");
  list.set("mu1", -1.0);
  EXPECT_THAT(refusal(list), testing::HasSubstr("\"mu1\" is out of range: -1 MPa, allowed: > 0"));
  list = entry("rebar", "pantyhose");
  list.set("strain", "engineerin");
  EXPECT_THAT(refusal(list), testing::HasSubstr("\"strain\" has the unknown value \"engineerin\""));
  list = entry("rebar", "pantyhose");
  list.sublist("modulus");
  EXPECT_THAT(refusal(list), testing::HasSubstr("\"modulus\" is a list"));
  EXPECT_THAT(refusal(entry("rebar", "jeans")), testing::HasSubstr("\"set\" has the unknown value \"jeans\""));
}

/// Energy of fabric whose wale is stretched and whose course is compressed.
double compressed_energy(const Material& material) {
  return evaluate(material.response(), material.params(), {1.5, 0.3, 0.2}).W;
}

// "compression" picks what elements are told: the law, or its relaxation; the residual stiffness is for the solver.
TEST(Material, compression) {
  auto list = entry("itskov", "pantyhose");
  const double full = compressed_energy(make(list));
  EXPECT_FALSE(make(list).response().relaxes());
  const Material material = make(list);
  list.set("compression", "tension field");
  EXPECT_TRUE(make(list).response().relaxes());
  const RelaxedResponse relaxed(material.law(), Relaxation::tension_field, 1e-4);
  EXPECT_EQ(compressed_energy(make(list)), evaluate(relaxed, material.params(), {1.5, 0.3, 0.2}).W);
  EXPECT_EQ(make(list).response().residual_stiffness(), 1e-4);
  list.set("residual stiffness", 0.05);
  EXPECT_EQ(make(list).response().residual_stiffness(), 0.05);
  const double field = compressed_energy(make(list));
  list.set("compression", "slack fibres");
  const double fibres = compressed_energy(make(list));
  EXPECT_LT(field, fibres);
  EXPECT_LT(fibres, full);
}

// Slack fibres of a law that has fibres are its own, which carry no compression by default; a scene that turns them on
// contradicts itself.
TEST(Material, slack_fibres_of_a_law_with_fibres) {
  auto list = entry("rebar", "pantyhose");
  const double full = compressed_energy(make(list));
  list.set("compression", "slack fibres");
  EXPECT_FALSE(make(list).response().relaxes());
  EXPECT_EQ(compressed_energy(make(list)), full);
  list.set("fibres in compression", "on");
  EXPECT_EQ(
      refusal(list),
      "fabric.xml: material: parameter \"compression\" = \"slack fibres\": contradicts \"fibres in compression\" = "
      "\"on\": slack fibres carry no compression; set that to off, or \"compression\" to full or tension field");
  list.set("compression", "tension field");
  EXPECT_TRUE(make(list).response().relaxes());
}

// A residual stiffness where nothing is relaxed is refused.
TEST(Material, residual_stiffness_without_relaxation) {
  auto list = entry("rebar", "pantyhose");
  list.set("residual stiffness", 1e-3);
  EXPECT_THAT(refusal(list), testing::HasSubstr("\"residual stiffness\" = 0.001: nothing is relaxed"));
  list.set("compression", "slack fibres");
  EXPECT_THAT(refusal(list), testing::HasSubstr("\"residual stiffness\" = 0.001: nothing is relaxed"));
}

// Values that do not come from a file are checked as well.
TEST(Material, from_values) {
  const Material material(law("rebar"), values("rebar", "t-shirt"), 0.7);
  EXPECT_EQ(material.thickness(), 0.7);
  EXPECT_EQ(material.name(), "rebar");
  try {
    const Material negative(law("neo-hookean"), {-1.0});
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(), "Material \"neo-hookean\", parameter \"C10\": -1 is out of range: allowed is > 0");
  }
  try {
    const Material two(law("neo-hookean"), {1.0, 2.0});
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(), "Material \"neo-hookean\" has 1 parameters, not 2");
  }
}

}  // namespace
}  // namespace toile::material::test
