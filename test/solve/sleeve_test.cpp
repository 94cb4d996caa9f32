#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>
#include <cmath>
#include <cstdio>
#include "sleeve.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::test {
TEST(Sleeve, Try) {
  Sleeve::Options o;
  o.ranks = Tpetra::getDefaultComm()->getSize();
  auto fabric = std::make_shared<material::Material>(*material::find("neo-hookean"), std::vector<double>{8.4667e-3}, 1.0);
  Sleeve sleeve(o, fabric);
  sleeve.problem.contact.offset_by_half_thickness = false;
  solve::Simulation simulation(sleeve.problem, {});
  simulation.observe([&](const solve::StepReport& r, const solve::State&) {
    std::printf("step %d s=%g it=%d res=%g gap=%g E=%.12g neg=%d bal=%g / %g\n", r.step, r.parameter, r.iterations, r.residual, r.gap, r.strain_energy, r.negative_pivots, r.balance.sum().norm(), r.balance.magnitude);
  });
  solve::State start = simulation.state();
  start.seam = 1.0;
  simulation.set_start(start);
  solve::StageOptions stage;
  stage.name = "settle";
  try { simulation.run(stage); } catch (const std::exception& e) { std::puts(e.what()); FAIL(); }
  for (auto& n : simulation.notes()) std::puts(n.c_str());
  double f = 0;
  for (double x : simulation.state().contact_force) f += x;
  std::printf("pressure mean %.10g  (exact 1.8517249566e-4)\n", f / (2 * M_PI * 60 * 110));
}
}
