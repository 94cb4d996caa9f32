// The tension field of an annulus whose hub is turned, scene input/benchmarks/annulus-torsion.xml, against an
// axisymmetric solution (test/data/plane_stress/annulus_torsion_nh.csv) and Stein and Hedgepeth's closed form.
#include <gtest/gtest.h>

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <optional>

#include "toile/solve/fields.hpp"
#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/ranks.hpp"
#include "verification/shell_scene.hpp"

namespace toile::test {
namespace {

constexpr double hub_radius = 50.0;                 // mm
constexpr double youngs_modulus = 6.0 * 8.4667e-3;  // MPa, of the undeformed fabric

/// What is changed of the shipped scene.
struct Annulus {
  double ratio = 2.0;  ///< of the radii
  int across = 192, along = 32;
  bool relaxed = true;
  double residual = 1e-4;
  double angle = 0.5;  ///< rad
  double step = 0.1;   ///< rad
};

Annulus with_mesh(double ratio, int level) {
  Annulus a;
  a.ratio = ratio;
  a.across = (ratio < 1.5 ? 96 : 48) << level;
  a.along = (ratio < 1.5 ? 4 : 8) << level;
  return a;
}

struct Torsion {
  PlaneRun run;
  double angle;  ///< at load 1, rad

  /// The last one there: of a stage's end its final state.
  size_t step_at(double wanted) const {
    for (size_t k = run.reports.size(); k-- > 0;)
      if (std::abs(run.reports[k].load * angle - wanted) < 1e-9) return k;
    throw std::runtime_error("no step at angle " + std::to_string(wanted));
  }
  /// Torque over thickness and the hub's radius squared, MPa.
  double torque(double wanted) const {
    return run.reports[step_at(wanted)].balance.torque.back() / (hub_radius * hub_radius);
  }
  solve::Fields fields(double wanted) const {
    return compute_fields(run.scene->problem(), run.states[step_at(wanted)]);
  }
};

Torsion turn(const Annulus& a) {
  Teuchos::ParameterList list;
  Teuchos::updateParametersFromXmlFile(TOILE_SOURCE_DIR "/input/benchmarks/annulus-torsion.xml",
                                       Teuchos::inoutArg(list));
  Teuchos::ParameterList& panel = list.sublist("Panels").sublist("sheet");
  panel.set("outer radius", a.ratio * hub_radius).set("elements across", a.across).set("elements along", a.along);
  Teuchos::ParameterList& fabric = list.sublist("Materials").sublist("fabric");
  if (a.relaxed)
    fabric.set("residual stiffness", a.residual);
  else
    fabric.set("compression", std::string("full"));
  list.sublist("Supports").sublist("hub").set("turn by", a.angle * 180.0 / M_PI);
  list.sublist("Stages").sublist("turn").set("first step", a.step / a.angle).set("largest step", a.step / a.angle);
  return {run(list), a.angle};
}

/// Where an element's wrinkles are and what they are.
struct Wrinkles {
  double inner, outer;  ///< radii in the pattern, over the hub's
  double state;         ///< the largest of its points
  double distance;      ///< of the line along its crests from the annulus' centre, over the hub's radius
};

std::vector<Wrinkles> wrinkles(const Torsion& torsion, double angle) {
  const solve::Fields fields = torsion.fields(angle);
  const mesh::Mesh& mesh = torsion.run.scene->garment().mesh;
  const mesh::Block& block = mesh.blocks.at(0);
  const auto field = [&](const std::string& name) -> const std::vector<double>& {
    const auto& all = fields.element.at(0);
    return std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == name; })->values;
  };
  const std::vector<double>&state = field("wrinkle_state"), &x = field("wrinkle_x"), &y = field("wrinkle_y");
  std::vector<Wrinkles> all;
  for (size_t e = 0; e < static_cast<size_t>(block.size()); ++e) {
    Wrinkles w{1e9, 0.0, state[e], 0.0};
    solve::Vec3 centre = solve::Vec3::Zero();
    for (size_t i = 0; i < 4; ++i) {
      const int n = block.connectivity[4 * e + i];
      centre += 0.25 * fields.position[n];
      const double r = mesh.pattern[n].norm() / hub_radius;
      w.inner = std::min(w.inner, r);
      w.outer = std::max(w.outer, r);
    }
    w.distance = std::abs(centre.x() * y[e] - centre.y() * x[e]) / hub_radius;
    all.push_back(w);
  }
  return all;
}

/// Distances of tension lines from the centre, over the hub's radius.
struct Lines {
  double least = 1e9, largest = -1e9;
  double deviation = 0.0;  ///< root mean square of what they differ from their mean
};

/// Those of the elements between two radii of the pattern.
Lines lines(const std::vector<Wrinkles>& all, double from, double to) {
  constexpr double round_off = 1e-9;
  std::vector<double> distances;
  for (const Wrinkles& w : all)
    if (w.inner > from - round_off && w.outer < to + round_off) distances.push_back(w.distance);
  double mean = 0.0, squares = 0.0;
  for (const double d : distances) mean += d / static_cast<double>(distances.size());
  for (const double d : distances) squares += (d - mean) * (d - mean) / static_cast<double>(distances.size());
  return {*std::min_element(distances.begin(), distances.end()), *std::max_element(distances.begin(), distances.end()),
          std::sqrt(squares)};
}

struct ReferenceRow {
  double ratio, angle, relaxed, wrinkled_fraction, unrelaxed;
};

std::vector<ReferenceRow> reference(std::optional<double> ratio = std::nullopt) {
  const auto table = read_table("plane_stress/annulus_torsion_nh.csv");
  std::vector<ReferenceRow> rows;
  for (size_t k = 0; k < table.at("a").size(); ++k)
    if (!ratio || *ratio == table.at("a")[k])
      rows.push_back({table.at("a")[k], table.at("psi_rad")[k], table.at("torque_relaxed")[k],
                      table.at("wrinkled_fraction")[k], table.at("torque_unrelaxed")[k]});
  return rows;
}

class AnnulusTorsion : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Ratios, AnnulusTorsion, testing::Values(1.25, 2.0));

// The torque of the wrinkled sheet, and of a sheet that carries compression, is the reference's at every angle.
TEST_P(AnnulusTorsion, TorqueIsTheReferences) {
  Annulus a = with_mesh(GetParam(), on_one_rank() ? 2 : 1);
  const double allowed = on_one_rank() ? 0.001 : 0.005;
  const std::vector<ReferenceRow> rows = reference(a.ratio);
  a.step = 0.05;
  a.angle = rows.back().angle;
  const Torsion relaxed = turn(a);
  a.relaxed = false;
  const Torsion full = turn(a);
  for (const ReferenceRow& row : rows) {
    const double error = relaxed.torque(row.angle) / row.relaxed - 1.0;
    const double full_error = full.torque(row.angle) / row.unrelaxed - 1.0;
    print("ratio %.2f, %3d x %2d, %.2f rad: error of the torque, tension field %.4f %%, without wrinkles %.4f %%\n",
          a.ratio, a.across, a.along, row.angle, 100.0 * error, 100.0 * full_error);
    EXPECT_LT(std::abs(error), allowed) << row.angle;
    EXPECT_LT(std::abs(full_error), allowed) << row.angle;
  }
  EXPECT_EQ(relaxed.run.reports.back().negative_pivots, 0);
}

// With ever smaller elements the torque converges with second order to the reference, wrinkled or not, although the
// fabric's stiffness jumps where wrinkles end.
TEST_P(AnnulusTorsion, TorqueConvergesWithSecondOrder) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  for (const bool relaxed : {true, false}) {
    const ReferenceRow row = reference(GetParam()).at(3);  // 0.3 rad
    double error[3];
    for (int level = 0; level < 3; ++level) {
      Annulus a = with_mesh(GetParam(), level);
      a.relaxed = relaxed;
      a.residual = 1e-8;  // what it adds to the torque must not be seen beside the error
      a.angle = row.angle;
      error[level] = turn(a).torque(row.angle) / (relaxed ? row.relaxed : row.unrelaxed) - 1.0;
      const double rate = level == 0 ? NAN : std::log2(std::abs(error[level - 1] / error[level]));
      print("ratio %.2f, %3d x %2d, %-17s error of the torque %.5f %%  rate %.2f\n", a.ratio, a.across, a.along,
            relaxed ? "tension field:" : "without wrinkles:", 100.0 * error[level], rate);
      if (level > 0) {
        EXPECT_GE(rate, 0.95 * 2.0) << a.across << " x " << a.along;
      }
    }
  }
}

// A tenth of the residual stiffness changes the torque by less than a tenth of a per mille.
TEST_P(AnnulusTorsion, ResidualStiffnessHardlyChangesTheTorque) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  Annulus a = with_mesh(GetParam(), 1);
  a.angle = 0.1;
  const double torque = turn(a).torque(0.1);
  a.residual *= 0.1;
  const double change = turn(a).torque(0.1) / torque - 1.0;
  print("ratio %.2f: residual stiffness 1e-5 instead of 1e-4 changes the torque by %.5f %%\n", a.ratio, 100.0 * change);
  EXPECT_LT(std::abs(change), 1e-4);
}

// The narrow annulus wrinkles all over; a wide one as far as the reference says, and beyond it is taut; nothing is
// slack.
TEST_P(AnnulusTorsion, WrinklesReachAsFarAsTheReferences) {
  constexpr double resolution = 1.0 / 105.0;  // of the reference, in parts of the width
  Annulus a = with_mesh(GetParam(), 1);
  const std::vector<ReferenceRow> rows = reference(a.ratio);
  a.step = 0.05;
  a.angle = rows.back().angle;
  const Torsion torsion = turn(a);
  for (const ReferenceRow& row : rows) {
    const double end = 1.0 + row.wrinkled_fraction * (a.ratio - 1.0);
    const double width = (a.ratio - 1.0) * (resolution + 1.0 / a.along);
    for (const Wrinkles& w : wrinkles(torsion, row.angle)) {
      const bool within = w.outer <= end - width || row.wrinkled_fraction == 1.0, beyond = w.inner >= end + width;
      if (within || beyond) {
        EXPECT_EQ(w.state, within ? 1.0 : 0.0) << w.inner;
      }
    }
    const double share = torsion.fields(row.angle).wrinkle_shares.at(0)[1];
    const double reached = std::sqrt(1.0 + share * (a.ratio * a.ratio - 1.0));
    print("ratio %.2f, %.2f rad: wrinkles reach to %.4f hub radii (reference %.4f)\n", a.ratio, row.angle, reached,
          end);
    EXPECT_NEAR(reached, end, (a.ratio - 1.0) * (resolution + 0.5 / a.along));
  }
}

// Nothing acts on the lines of tension from the side, so that they are straight in the turned sheet: the crests of all
// wrinkles lie on lines of one distance from the centre, up to the second order of the elements (in the same part of
// the sheet for all meshes, an eighth of its width off the hub: nearer to it the tension rises ever more steeply).
TEST_P(AnnulusTorsion, CrestsRunAlongStraightLines) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  const ReferenceRow row = reference(GetParam()).at(3);  // 0.3 rad
  double deviation[2];
  for (int level = 0; level < 2; ++level) {
    Annulus a = with_mesh(GetParam(), level + 1);
    a.angle = row.angle;
    a.residual = 1e-8;
    const double width = a.ratio - 1.0, to = row.wrinkled_fraction == 1.0 ? 1.0 : 0.5;
    const Lines c = lines(wrinkles(turn(a), row.angle), 1.0 + 0.125 * width, 1.0 + to * width);
    deviation[level] = c.deviation;
    EXPECT_LT(c.largest - c.least, 2e-3 * c.largest);
    print("ratio %.2f, %3d x %2d, %.2f rad: tension lines at %.5f to %.5f hub radii from the centre\n", a.ratio,
          a.across, a.along, row.angle, c.least, c.largest);
  }
  const double rate = std::log2(deviation[0] / deviation[1]);
  print("ratio %.2f: rate of their deviation from one distance %.2f\n", GetParam(), rate);
  EXPECT_GE(rate, 0.95 * 2.0);
}

// At small angles an annulus that wrinkles all over has Stein and Hedgepeth's torque, with straight crests at the
// distance c that makes it largest: 4 pi c^2/ln[(a^2 - c^2)/(b^2 - c^2)] E t angle.
TEST(AnnulusTorsionLimit, IsTheClosedFormOfSmallAngles) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  constexpr double largest = 8.586822593;  // of the closed form at a/b = 1.25, test/data/plane_stress
  const auto closed_form = [](double c) {
    return 4.0 * M_PI * c * c / std::log((1.25 * 1.25 - c * c) / (1.0 - c * c));
  };
  double lower = 0.5, upper = 1.0 - 1e-9;  // it has one maximum
  while (upper - lower > 1e-9) {
    const double third = (upper - lower) / 3.0;
    if (closed_form(lower + third) < closed_form(upper - third))
      lower += third;
    else
      upper -= third;
  }
  const double best = 0.5 * (lower + upper);
  ASSERT_NEAR(closed_form(best), largest, 1e-8);
  Annulus a = with_mesh(1.25, 2);
  a.angle = a.step = 1e-4;
  a.residual = 1e-8;
  const Torsion torsion = turn(a);
  const double torque = torsion.torque(a.angle) / (youngs_modulus * a.angle);
  const Lines c = lines(wrinkles(torsion, a.angle), 1.0, 1.25);
  print("ratio 1.25, 0.0001 rad: torque %.5f E t b^2 angle (closed form %.5f), lines at %.5f to %.5f (%.5f)\n", torque,
        largest, c.least, c.largest, best);
  EXPECT_NEAR(torque, largest, 1e-3 * largest);
  EXPECT_NEAR(c.least, best, 5e-3 * best);
  EXPECT_NEAR(c.largest, best, 5e-3 * best);
}

}  // namespace
}  // namespace toile::test
