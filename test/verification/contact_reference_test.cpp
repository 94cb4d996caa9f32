#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>

#include "verification/contact_reference.hpp"
#include "verification/print.hpp"

namespace toile::test {
namespace {

constexpr int levels = 3;

/// Relative root mean square of the pressure's error, without the end rings and the coarsest mesh's row beside them.
double pressure_error(const Sleeve& sleeve, const ContactReference& reference) {
  const int skip = sleeve.along / 8;
  double error = 0.0, scale = 0.0;
  for (int j = skip; j <= sleeve.along - skip; ++j)
    for (int i = 0; i < sleeve.around; ++i) {
      const double exact = reference.at("z", sleeve.position(i, j).z(), "p");
      error += std::pow(sleeve.pressure(i, j) - exact, 2);
      scale += exact * exact;
    }
  return std::sqrt(error / scale);
}

SleeveOptions options_of(const ContactReference& reference, int level) {
  const bool free = reference.part(2) == "free";
  SleeveOptions o;
  o.body = body_of(reference);
  o.material = material_of(reference.part(3));
  o.r0 = reference.header("R0");
  o.l0 = reference.header("L0");
  o.to = reference.header("z_end") * (free ? 0.98 : 1.0);
  // The reference holds the end on the body; held along z alone, tension would pull it off where the body narrows.
  o.hold_top = free ? "" : "xyz";
  o.around = 24 << level;
  o.along = 8 << level;
  return o;
}

class SleeveOfRevolution : public testing::TestWithParam<std::string> {};

// The pressure of a sleeve on a body of revolution converges with second order to the semi-analytic one and is within
// 0.2 % of it; the written field is in balance, and the spin that nothing resists is found.
TEST_P(SleeveOfRevolution, PressureConvergesWithSecondOrder) {
  const ContactReference reference("contact_" + GetParam());
  std::array<double, levels> error{};
  for (int level = 0; level < levels; ++level) {
    const SleeveOptions options = options_of(reference, level);
    const Sleeve sleeve = settle(options);
    expect_balanced(sleeve);
    EXPECT_EQ(sleeve.notes.size(), options.hold_top == "xyz" ? 0u : 1u);
    error[level] = pressure_error(sleeve, reference);
    const double rate = level > 0 ? std::log2(error[level - 1] / error[level]) : NAN;
    print("%-20s %3d x %2d  error %.4f %%  rate %.3f  balance %.1e  gap %.1e mm\n", GetParam().c_str(), sleeve.around,
          sleeve.along, 100.0 * error[level], rate, sleeve.imbalance(), sleeve.largest_gap());
    // With eight elements along, parts of the error of opposite signs cancel on cones.
    if (level > 0) {
      EXPECT_GE(rate, level > 1 ? 1.9 : 1.5);
    }
  }
  EXPECT_LE(error.back(), 0.002);
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Contact, SleeveOfRevolution,
                         testing::Values("cyl_free_nh", "cyl_free_rebar", "cyl_free_itskov", "cyl_ax1.1_nh",
                                         "cyl_ax1.1_rebar", "cyl_ax1.1_itskov", "cone_fix_nh", "cone_fix_rebar",
                                         "cone_fix_itskov", "cone_free_nh", "cone_free_rebar", "cone_free_itskov",
                                         "ellipsoid_fix_nh", "ellipsoid_fix_rebar", "ellipsoid_fix_itskov",
                                         "leg_fix_nh", "leg_fix_rebar", "leg_fix_itskov", "sphere_free_nh",
                                         "sphere_free_rebar", "sphere_free_itskov"),
                         test_name);

// Nodes that a support holds in every direction off the body carry no pressure and do not stop the solution.
TEST(HeldEnd, CarriesNoPressureOffTheBody) {
  SleeveOptions o;
  o.body = body_list("cylinder").set("radius", 60.0);
  o.to = 110.0;
  o.offset = 0.5;
  o.hold_bottom = o.hold_top = "xyz";
  const Sleeve sleeve = settle(o);
  expect_balanced(sleeve);
  for (int i = 0; i < o.around; ++i) {
    EXPECT_EQ(sleeve.pressure(i, 0), 0.0);
    EXPECT_NEAR(sleeve.position(i, 0).head<2>().norm(), 60.5, 1e-6);
    EXPECT_GT(sleeve.pressure(i, o.along / 2), 0.0);
  }
}

}  // namespace
}  // namespace toile::test
