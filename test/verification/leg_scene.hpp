#pragma once

#include <memory>
#include <string>
#include <vector>

#include "toile/run/session.hpp"

namespace toile::test {

/// Mean pressure, Laplace's T/r (kPa), smallest principal stress (MPa) and the estimate of the pressure's error (kPa)
/// at a height.
struct LegLevel {
  double pressure = 0.0, laplace = 0.0, smallest_stress = 0.0, error = 0.0;
};

/// A shipped scene of the pantyhose leg after its last stage.
struct Leg {
  std::unique_ptr<run::Session> session;
  const scene::Scene* scene = nullptr;
  solve::State state;
  solve::Fields fields;
  solve::StepReport report;

  /// The garment cut at the levels of the scene's output: B, B1, C, D, F, G.
  std::vector<LegLevel> levels() const;
  /// Value of an element field (stretch_wale, stretch_course) below which a share of all elements lies.
  double quantile(const std::string& field, double share) const;
  /// Forces of the written pressure field and the supports: their sum over the sum of the magnitudes.
  double imbalance() const;
};

/// The panels "front" and "back", each with `parameters`.
std::string both_panels(const std::string& parameters);

/// Runs input/`name` on a coarse mesh, on all ranks of MPI's world. `more`: lists that go before those of the scene.
Leg run_leg(const std::string& name, const std::string& more = "");

}  // namespace toile::test
