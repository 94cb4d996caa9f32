// What the tests of stages have in common: fabrics, sleeves, their starts and their pressure.
#pragma once

#include <Tpetra_Core.hpp>
#include <cmath>

#include "sleeve.hpp"
#include "toile/solve/fields.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::test {

inline std::shared_ptr<material::Material> neo_hookean() {
  return std::make_shared<material::Material>(*material::find("neo-hookean"), std::vector<double>{8.4667e-3}, 1.0);
}

inline std::shared_ptr<material::Material> pantyhose() {
  const material::LawV1& rebar = *material::find("rebar");
  const double* values = rebar.sets[0].values;
  return std::make_shared<material::Material>(rebar, std::vector<double>(values, values + rebar.n_params), 1.0);
}

inline Sleeve::Options options(int around = 24, int along = 8) {
  Sleeve::Options o;
  o.around = around;
  o.along = along;
  o.ranks = Tpetra::getDefaultComm()->getSize();
  return o;
}

inline solve::State closed_start(const solve::Problem& problem) {
  solve::State start = placed_state(problem);
  start.seam = 1.0;
  return start;
}

inline solve::StageOptions stage(const std::string& kind) {
  solve::StageOptions s;
  s.name = "stage";
  s.kind = &solve::stage_kind(kind);
  return s;
}

inline double mid_pressure(const Sleeve& sleeve, const solve::State& state, int around, int along) {
  const solve::Fields fields = compute_fields(sleeve.problem, state);
  return fields.pressure[static_cast<size_t>((along / 2) * (around + 1) + around / 4)];
}

/// Places the sleeve's panel on `radius` with the seam open: it covers 85 % of the girth.
inline void open_up(Sleeve& sleeve, const Sleeve::Options& o, double radius) {
  const double pi = std::acos(-1.0);
  for (int j = 0; j <= o.along; ++j)
    for (int i = 0; i <= o.around; ++i) {
      solve::Vec3& p = sleeve.mesh.placed[static_cast<size_t>(j * (o.around + 1) + i)];
      const double angle = 2.0 * pi * 0.85 * i / o.around;
      p = solve::Vec3(radius * std::cos(angle), radius * std::sin(angle), p[2]);
    }
}

}  // namespace toile::test
