// What a stage promises at its end, and what it says where it cannot.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

solve::StageOptions damped_sewing() {
  solve::StageOptions sew = stage("sew");
  sew.damping.active = true;
  return sew;
}

/// The pressure that the closed sleeve settles to.
double settled_pressure(const Sleeve::Options& o) {
  Sleeve closed(o, neo_hookean());
  Recorded run(closed.problem);
  run.simulation.set_start(closed_start(closed.problem));
  run.simulation.run(stage("settle"));
  return mid_pressure(closed, run.simulation.state(), o.around, o.along);
}

// A kind of stage is found by its word in the input; of an unknown one the nearest is told.
TEST(Stage, KindsAreFoundByName) {
  for (const char* name : {"sew", "load", "settle"}) EXPECT_EQ(solve::stage_kind(name).name(), std::string(name));
  try {
    solve::stage_kind("setle");
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("no kind of stage is named \"setle\""), HasSubstr("\"settle\"")));
  }
}

// A sleeve that starts off the body is held against the motions that the body does not resist yet; once it presses,
// only the spin is left to hold, and the pressure is that of the sleeve that started on the body.
TEST(Stage, PinsOfTheStartAreGoneAtTheEnd) {
  const Sleeve::Options o = options(12, 6);
  Sleeve off(o, neo_hookean());
  open_up(off, o, 63.0);
  Recorded run(off.problem);
  run.simulation.run(damped_sewing());
  EXPECT_THAT(run.simulation.notes(), ElementsAre(HasSubstr("rotation about the axis (0, 0, 1)")));
  EXPECT_LT(run.last().balance.pin_magnitude, 1e-8 * run.last().balance.magnitude);
  EXPECT_GT(run.reports.front().balance.pin_magnitude, 0.0);  // while it sews they do carry something
  const solve::Fields fields = compute_fields(off.problem, run.simulation.state());
  const double expected = settled_pressure(o);
  for (int i = 0; i <= o.around; ++i)
    EXPECT_NEAR(fields.pressure[static_cast<size_t>(o.along / 2 * (o.around + 1) + i)], expected, 1e-6 * expected) << i;
}

// Counting negative pivots at every step of a damped stage changes nothing but the number of factorisations: the steps
// go on with those of the damped tangent.
TEST(Stage, CountingPivotsDoesNotChangeADampedPath) {
  std::vector<solve::SolveStatistics> statistics;
  for (const bool every_step : {false, true}) {
    Panels sheet(neo_hookean());
    sheet.add(solve::Vec3::Zero(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
    sheet.hold(0, 0);
    sheet.hold(0, Panels::across);
    sheet.problem.supports[1].displacement = solve::Vec3(10.0, 0.0, 0.0);
    std::vector<int> all;
    for (int n = 0; n < Panels::nodes(); ++n) all.push_back(n);
    sheet.hold_nodes(all, {false, false, true});
    Recorded run(sheet.problem);
    solve::StageOptions pull = stage("load");
    pull.damping.active = true;
    pull.damping.fraction = 0.1;
    pull.stability_every_step = every_step;
    run.simulation.run(pull);
    for (const solve::StepReport& r : run.reports) EXPECT_EQ(r.negative_pivots >= 0, every_step || r.undamped);
    statistics.push_back(run.simulation.statistics());
  }
  EXPECT_EQ(statistics[1].newton_iterations, statistics[0].newton_iterations);
  EXPECT_EQ(statistics[1].linear_iterations, statistics[0].linear_iterations);
  EXPECT_GT(statistics[1].factorisations, statistics[0].factorisations);
}

// Along the arc no step is recorded beyond the target, and a critical point close to it is noted once: a flat sheet is
// pulled from compression into tension.
TEST(Stage, ArcLengthRecordsNothingBeyondTheTarget) {
  for (const double beyond : {0.02, 0.1, 0.4}) {
    Panels sheet(neo_hookean());
    sheet.add(solve::Vec3::Zero(), solve::Vec3(0.95, 0.0, 0.0), solve::Vec3(0.0, 1.0, 0.0), 0);
    sheet.hold(0, 0);
    sheet.hold(0, Panels::across);
    sheet.problem.supports[1].displacement[0] = 0.05 * Panels::size * Panels::across * (1.0 + beyond);
    Recorded run(sheet.problem);
    solve::StageOptions pull = stage("load");
    pull.arc_length = pull.stability_every_step = true;
    run.simulation.run(pull);
    for (const solve::StepReport& r : run.reports) EXPECT_LE(r.load, 1.0 + 1e-12);
    EXPECT_NEAR(run.last().load, 1.0, 1e-12);
    EXPECT_GT(run.reports.front().negative_pivots, 0);
    EXPECT_EQ(run.last().negative_pivots, 0);
    double before = -1.0;
    for (const std::string& note : run.simulation.notes()) {
      double from = 0.0, to = 0.0;
      ASSERT_EQ(std::sscanf(note.substr(note.find("load ")).c_str(), "load %lf and %lf", &from, &to), 2) << note;
      EXPECT_GE(from, before) << note;
      EXPECT_GT(to, from) << note;
      before = to;
    }
    EXPECT_GE(run.simulation.notes().size(), 1u);
  }
}

// A load along a motion that nothing resists has no equilibrium: the run says so instead of letting a pin carry it.
TEST(Stage, LoadAlongANullMotionHasNoEquilibrium) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.problem.loads.push_back(pull(sleeve.problem.supports[1].nodes, solve::Vec3(0.0, 0.0, 1e-2)));
  sleeve.problem.supports.clear();
  Recorded run(sleeve.problem);
  run.simulation.set_start(closed_start(sleeve.problem));
  EXPECT_THAT(failure_of(run.simulation, stage("load")),
              AllOf(HasSubstr("there is no equilibrium"), HasSubstr("translation along (0, 0, 1)")));
}

// Two sleeves on one body are held against their spins one by one, and their end is stable.
TEST(Stage, SeparateSleevesAreHeldSeparately) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.add_copy(150.0);
  for (size_t s = 0; s < 2; ++s) sleeve.problem.supports[s].held = {false, false, true};
  Recorded run(sleeve.problem);
  run.simulation.set_start(closed_start(sleeve.problem));
  run.simulation.run(stage("settle"));
  EXPECT_EQ(run.simulation.notes().size(), 2u);
  EXPECT_EQ(run.last().negative_pivots, 0);
  EXPECT_THAT(run.simulation.warnings(), IsEmpty());
}

// A flat sheet in compression is in equilibrium and not stable: the run warns.
TEST(Stage, UnstableEndIsAWarning) {
  Panels sheet(neo_hookean());
  sheet.add(solve::Vec3::Zero(), solve::Vec3(0.95, 0.0, 0.0), solve::Vec3(0.0, 1.0, 0.0), 0);
  sheet.hold(0, 0);
  sheet.hold(0, Panels::across);
  Recorded run(sheet.problem);
  run.simulation.run(stage("settle"));
  EXPECT_GT(run.last().negative_pivots, 0);
  EXPECT_THAT(run.simulation.warnings(), ElementsAre(HasSubstr("its final state is not stable (")));
}

// Where the tangent cannot be factorised (the second sheet resists nothing at all) the run warns that it does not know
// whether its end is stable.
TEST(Stage, EndOfUnknownStabilityIsAWarning) {
  Panels sheets(neo_hookean());
  const material::Material limp = limp_fabric();
  for (int p = 0; p < 2; ++p) {
    sheets.add(100.0 * p * solve::Vec3::UnitZ(), 1.1 * solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
    sheets.hold(p, 0);
    sheets.hold(p, Panels::across);
  }
  sheets.problem.models[1].material = &limp;
  Recorded run(sheets.problem);
  run.simulation.run(stage("settle"));
  EXPECT_EQ(run.last().negative_pivots, -1);
  EXPECT_THAT(run.simulation.warnings(), ElementsAre(HasSubstr("it is not known whether its final state is stable")));
}

// Every step of a damped stage dissipates about the set fraction of the strain energy, from the first one on.
TEST(Stage, DissipationOfAStepFollowsTheFraction) {
  for (const double fraction : {2e-4, 2e-2}) {
    const Sleeve::Options o = options(12, 6);
    Sleeve open(o, neo_hookean());
    open_up(open, o, 60.0);
    Recorded run(open.problem);
    solve::StageOptions sew = damped_sewing();
    sew.damping.fraction = fraction;
    sew.first_step = sew.largest_step = 0.2;
    run.simulation.run(sew);
    ASSERT_GT(run.reports.size(), 4u);
    for (size_t k = 1; k + 1 < run.reports.size(); ++k) {
      const double share =
          (run.reports[k].energy.dissipated - run.reports[k - 1].energy.dissipated) / run.reports[k].energy.strain;
      EXPECT_GT(share, 0.4 * fraction) << "step " << k << " of fraction " << fraction;
      EXPECT_LT(share, 2.5 * fraction) << "step " << k << " of fraction " << fraction;
    }
  }
}

// The dissipated energy adds up over the steps; its ratio is that over the largest strain energy so far; above the
// limit the run warns that the path was not quasi-static.
TEST(Stage, DissipationIsAccumulatedAndJudged) {
  const Sleeve::Options o = options(12, 6);
  for (const double limit : {0.05, 1e-6}) {
    Sleeve open(o, neo_hookean());
    open_up(open, o, 60.0);
    Recorded run(open.problem);
    solve::StageOptions sew = damped_sewing();
    sew.damping.limit = limit;
    run.simulation.run(sew);
    double before = 0.0, largest = 0.0;
    for (const solve::StepReport& r : run.reports) {
      largest = std::max(largest, r.energy.strain);
      EXPECT_GE(r.energy.dissipated, before);
      EXPECT_DOUBLE_EQ(r.energy.dissipation_ratio, r.energy.dissipated / largest);
      before = r.energy.dissipated;
    }
    EXPECT_GT(run.last().energy.dissipation_ratio, 0.0);
    EXPECT_EQ(run.simulation.warnings().size(), limit == 0.05 ? 0u : 1u);
    for (const std::string& warning : run.simulation.warnings()) EXPECT_THAT(warning, HasSubstr("not quasi-static"));
  }
}

// A support that is released carries nothing from then on.
TEST(Stage, ReleasedSupportCarriesNothing) {
  const Sleeve::Options o = options(12, 6);
  Sleeve open(o, neo_hookean());
  open_up(open, o, 60.0);
  Recorded run(open.problem);
  run.simulation.run(damped_sewing());
  EXPECT_GT(run.last().balance.support[1][2], 1.0);
  solve::StageOptions settle = stage("settle");
  settle.released = {"top"};
  run.simulation.run(settle);
  EXPECT_EQ(run.last().balance.support[1], solve::Vec3::Zero());
  EXPECT_LT(std::abs(run.last().balance.support[0][2]), 1e-12);
  EXPECT_GT(mid_pressure(open, run.simulation.state(), o.around, o.along), 0.0);
}

// Sewing that has to cut its steps back ends at the same pressure.
TEST(Stage, CutBackWhileSewingReachesTheSamePressure) {
  const Sleeve::Options o = options(12, 6);
  Sleeve open(o, neo_hookean());
  open_up(open, o, 60.0);
  solve::SolverOptions few;
  few.newton.max_iterations = 4;
  Recorded run(open.problem, few);
  solve::StageOptions sew = damped_sewing();
  sew.first_step = sew.largest_step = 1.0;
  run.simulation.run(sew);
  EXPECT_GT(run.simulation.statistics().cut_backs, 0);
  const double expected = settled_pressure(o);
  EXPECT_NEAR(mid_pressure(open, run.simulation.state(), o.around, o.along), expected, 1e-6 * expected);
}

// A seam may have its two sides on different ranks.
TEST(Stage, SeamAcrossRanks) {
  Sleeve::Options o = options(12, 6);
  o.ranks_around = true;
  Sleeve open(o, neo_hookean());
  open_up(open, o, 60.0);
  Recorded run(open.problem);
  run.simulation.run(damped_sewing());
  const double expected = settled_pressure(options(12, 6));
  EXPECT_NEAR(mid_pressure(open, run.simulation.state(), o.around, o.along), expected, 1e-8 * expected);
}

// Three panels, each on a rank of its own if there are three, meet in one seam: it settles where their pulls cancel.
TEST(Stage, ThreePanelsMeetInOneSeam) {
  const double third = 2.0 * std::acos(-1.0) / 3.0;
  const int ranks = Tpetra::getDefaultComm()->getSize();
  Panels star(neo_hookean());
  for (int p = 0; p < 3; ++p) {
    const solve::Vec3 out(std::cos(p * third), std::sin(p * third), 0.0);
    star.add(3.0 * out, 1.1 * out, solve::Vec3::UnitZ(), p * ranks / 3);
    star.hold(p, Panels::across);
  }
  std::vector<std::vector<int>> clusters;
  std::vector<int> owners;
  for (int c = 0; c < 3 * Panels::nodes(); ++c) {
    const bool on_seam = c % (Panels::across + 1) == 0;
    if (on_seam && c >= Panels::nodes()) continue;
    clusters.push_back({c});
    owners.push_back(star.problem.cluster_rank[c]);
    if (on_seam) clusters.back().insert(clusters.back().end(), {c + Panels::nodes(), c + 2 * Panels::nodes()});
  }
  star.problem.clusters = clusters;
  star.problem.cluster_rank = owners;
  Recorded run(star.problem);
  run.simulation.run(stage("sew"));
  for (size_t c = 0; c < clusters.size(); ++c)
    if (clusters[c].size() == 3) {
      EXPECT_LT(run.simulation.state().position[c].head<2>().norm(), 1e-8) << c;
    }
  const solve::ForceBalance& balance = run.last().balance;
  EXPECT_GT(balance.support[0][0], 0.1);
  for (int p = 1; p < 3; ++p) EXPECT_NEAR(balance.support[p].norm(), balance.support[0].norm(), 1e-8);
  EXPECT_LT(balance.sum().norm(), 1e-9);
}

// Every linear solver finds the same pressure.
TEST(Stage, LinearSolversAgree) {
  const Sleeve::Options o = options(12, 6);
  std::vector<double> pressure;
  for (const char* method : {"cg", "gmres", "direct", "klu2"}) {
    Sleeve sleeve(o, neo_hookean());
    solve::SolverOptions solver;
    solver.linear.method = method;
    Recorded run(sleeve.problem, solver);
    run.simulation.set_start(closed_start(sleeve.problem));
    run.simulation.run(stage("settle"));
    pressure.push_back(mid_pressure(sleeve, run.simulation.state(), o.around, o.along));
  }
  EXPECT_GT(pressure[0], 0.0);
  for (const double found : pressure) EXPECT_NEAR(found, pressure[0], 1e-9 * pressure[0]);
}

// A first settle that fails leaves the start as it was, and says that nothing was accepted.
TEST(Stage, FailedSettleAcceptsNothing) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  solve::SolverOptions one;
  one.newton.max_iterations = 1;
  for (const bool damped : {false, true}) {
    Recorded run(sleeve.problem, one);
    solve::State start = closed_start(sleeve.problem);  // rows crowded towards one end
    for (solve::Vec3& p : start.position) p[2] += 12.0 * std::sin(std::acos(-1.0) * p[2] / 110.0);
    run.simulation.set_start(start);
    solve::StageOptions settle = stage("settle");
    settle.damping.active = damped;
    const std::string message = failure_of(run.simulation, settle);
    EXPECT_THAT(message, HasSubstr("no undamped equilibrium was found at its end, and no step of it was accepted."));
    EXPECT_EQ(message.find("give the stage a list \"Damping\"") == std::string::npos, damped) << message;
    EXPECT_THAT(run.reports, IsEmpty());
    EXPECT_EQ(run.simulation.state().position, start.position);
  }
}

// Nodes that press where the body has no smooth surface are counted.
TEST(Stage, ContactOffTheSmoothSurfaceIsCounted) {
  struct Hole : Cylinder {
    using Cylinder::Cylinder;
    body::SurfacePoint closest(const body::Vec3& p) const override {
      body::SurfacePoint s = Cylinder::closest(p);
      s.found = p[2] < 60.0;
      return s;
    }
  };
  Sleeve sleeve(options(12, 6), neo_hookean());
  const Hole hole(60.0);
  sleeve.problem.surface = &hole;
  Recorded run(sleeve.problem);
  run.simulation.set_start(closed_start(sleeve.problem));
  run.simulation.run(stage("settle"));
  EXPECT_EQ(compute_fields(sleeve.problem, run.simulation.state()).contacts_off_surface, 3 * 12);
}

}  // namespace
}  // namespace toile::test
