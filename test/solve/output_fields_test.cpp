// What is written of a state: a sleeve as it is placed, with stretches and forces that are known.
#include "toile/solve/output_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "stages.hpp"

namespace toile::test {
namespace {

std::set<std::string> names_of(const std::vector<solve::NamedField>& fields) {
  std::set<std::string> names;
  for (const solve::NamedField& field : fields) names.insert(field.name);
  return names;
}

// Each field of nodes and elements that is declared is written with a value a node or element of all panels, once, with
// its unit; those of wrinkles only where fabric wrinkles, that of crossings only if they are looked for.
TEST(OutputFields, EveryDeclaredFieldIsWritten) {
  Sleeve sleeve(options(), neo_hookean());
  sleeve.add_copy(200.0);
  const solve::State placed = solve::placed_state(sleeve.problem);
  EXPECT_EQ(names_of(solve::element_fields(solve::compute_fields(sleeve.problem, placed))).count("crossing"), 0U);
  sleeve.problem.crossings = true;
  const solve::Fields fields = solve::compute_fields(sleeve.problem, placed);
  const auto nodal = solve::nodal_fields(sleeve.problem, fields);
  const auto element = solve::element_fields(fields);
  EXPECT_EQ(names_of(nodal).size(), nodal.size());
  EXPECT_EQ(names_of(element).size(), element.size());
  for (const auto& field : nodal) EXPECT_EQ(field.values.size(), static_cast<size_t>(sleeve.mesh.nodes()));
  for (const auto& field : element) EXPECT_EQ(field.values.size(), static_cast<size_t>(sleeve.mesh.elements()));
  for (const solve::OutputField& declared : solve::output_fields()) {
    EXPECT_FALSE(declared.text.empty()) << declared.name;
    if (declared.place == solve::FieldPlace::global) continue;
    const auto& written = declared.place == solve::FieldPlace::node ? nodal : element;
    const bool of_wrinkles = declared.name.find("wrinkle") == 0;
    EXPECT_EQ(names_of(written).count(declared.name), of_wrinkles ? 0U : 1U) << declared.name;
    if (of_wrinkles) continue;
    EXPECT_EQ(solve::named(written, declared.name).unit, declared.unit);
  }
}

// Element means are the stretches of the placement: chord over pattern around, 1.1 along.
TEST(OutputFields, StretchesAreThoseOfThePlacement) {
  const Sleeve::Options o = options();
  Sleeve sleeve(o, neo_hookean());
  const solve::Fields fields = solve::compute_fields(sleeve.problem, solve::placed_state(sleeve.problem));
  const auto element = solve::element_fields(fields);
  const double chord = 2.0 * o.radius * std::sin(M_PI / o.around) / (2.0 * M_PI * o.r0 / o.around);
  for (const double value : solve::named(element, "stretch_course").values) EXPECT_NEAR(value, chord, 1e-12);
  for (const double value : solve::named(element, "stretch_wale").values) EXPECT_NEAR(value, o.axial, 1e-12);
  for (const double value : solve::named(element, "stretch_major").values) EXPECT_NEAR(value, chord, 1e-12);
}

// The contact forces of nodes that a seam ties add up to the force of the seam's point.
TEST(OutputFields, ContactForcesAddUp) {
  Sleeve sleeve(options(), neo_hookean());
  solve::State state = solve::placed_state(sleeve.problem);
  std::iota(state.contact_force.begin(), state.contact_force.end(), 1.0);
  const solve::Fields fields = solve::compute_fields(sleeve.problem, state);
  const auto force = solve::named(solve::nodal_fields(sleeve.problem, fields), "contact_force").values;
  EXPECT_NEAR(std::accumulate(force.begin(), force.end(), 0.0),
              std::accumulate(state.contact_force.begin(), state.contact_force.end(), 0.0), 1e-8);
}

}  // namespace
}  // namespace toile::test
