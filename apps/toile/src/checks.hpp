#pragma once

#include <string>
#include <vector>

#include "pressure_report.hpp"
#include "summary.hpp"
#include "toile/scene/scene.hpp"

namespace toile::app {

/// One message for each check of the scene that does not hold, or whose quantity does not exist.
std::vector<std::string> failed_checks(const scene::Scene& scene, const Figures& figures,
                                       const PressureReport& pressure);

}  // namespace toile::app
