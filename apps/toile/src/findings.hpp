#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pressure_report.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"

namespace toile::app {

/// The largest pressure of the garment where no support ends: there a line force would pass for a pressure.
struct LargestPressure {
  double pressure = 0.0;  ///< MPa
  double error = 0.0;     ///< MPa
  std::string panel;
  solve::Vec3 place = solve::Vec3::Zero();  ///< mm
};
/// Nothing if the garment presses nowhere.
std::optional<LargestPressure> largest_pressure(const scene::Scene& scene, const solve::Fields& fields);

/// What a run is for, as it ends on the terminal: the table of levels, the stretches of each panel, the largest
/// pressure.
std::string findings(const scene::Scene& scene, const solve::Fields& fields, const PressureReport& pressure);

/// Warns of a pressure that no garment has, with the likely cause.
std::optional<std::string> implausible_pressure(const scene::Scene& scene, const solve::Fields& fields);

}  // namespace toile::app
