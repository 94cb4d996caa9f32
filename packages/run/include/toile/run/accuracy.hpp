#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "toile/run/session.hpp"

namespace toile::run {

/// A pressure whose error counts.
struct Counted {
  std::string title;
  double pressure = 0.0, mesh = 0.0, others = 0.0;  ///< MPa; the error's part by the mesh, and that of all others
  /// Of the pressure.
  double error() const;
};

/// The pressures at the levels and points that the scene's list "Accuracy" names; those of places that no fabric
/// presses on do not count.
std::vector<Counted> counted(const Record& record);

/// How much finer the mesh must be for a relative error `wanted` of all of them, since the mesh's part falls with the
/// square of the elements' size, with a tenth in reserve and within 1.2 and 3. Throws base::Error (check_failed) if the
/// other parts alone are larger.
double finer_by(const std::vector<Counted>& pressures, double wanted);

/// Runs a scene with a list "Accuracy" until its error is reached. `start` gives the session of one run, on a mesh that
/// is `finer` by the factor, and `run` runs it. Writes accuracy.csv in `folder` after each run. Throws what they throw,
/// and base::Error (check_failed) if the error is not reached. Collective.
void run_to_accuracy(const std::function<std::unique_ptr<Session>(double finer)>& start,
                     const std::function<void(Session&)>& run, const std::string& folder);

}  // namespace toile::run
