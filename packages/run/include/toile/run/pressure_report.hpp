#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/result/body_map.hpp"
#include "toile/result/pressure_lines.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::run {

/// Pressure of the last state at the levels and along the axis, as far as the scene asks for them.
struct PressureReport {
  std::vector<result::LevelRow> levels, curve;
  std::vector<std::string> warnings;  ///< levels that are not reached or not closed
};

PressureReport pressure_report(const scene::Scene& scene, const solve::Fields& fields, const solve::StepReport& report);

/// The section of this title ("C (2)", or "C" if the level has one); null, and the reason, if there is none or more
/// than one.
const result::LevelRow* section(const PressureReport& pressure, const std::string& title, std::string& problem);

/// What fabric presses at a point of its own or on a place of the body.
struct PointPressure {
  double pressure = 0.0, error = 0.0;  ///< MPa; of a place of the body layers are added up
  std::vector<double> error_parts;     ///< [solve::error_parts()] MPa
  std::optional<double> gap;           ///< mm, mean of the layers; none: no fabric is there
};

/// [point] At nodes. One that is free beside nodes that press has their largest pressure as its error.
std::vector<PointPressure> point_pressures(const scene::Scene& scene, const std::vector<scene::Point>& at,
                                           const solve::Fields& fields);

/// [place]
std::vector<PointPressure> body_pressures(const scene::Scene& scene, const std::vector<scene::BodyPoint>& at,
                                          const solve::Fields& fields, const solve::StepReport& report);

/// Names of solve::error_parts().
std::vector<std::string> error_names();

/// [node] the first of the nodes that a closed seam holds together with it. `seam`: 1 if they are closed.
std::vector<int> tied_nodes(const solve::Problem& problem, double seam);

/// The garment of a state, for what is carried from it to the body. `seam`: as above.
result::GarmentOnBody on_body(const solve::Problem& problem, const solve::Fields& fields, double seam);

/// [element] true where some nodes are held by a support, not in a plane of symmetry, and others are not.
std::vector<bool> elements_at_supports(const scene::Scene& scene);

/// [node] number of the plane of symmetry in which a support holds it, and nodes that are sewn to it; -1: in none. A
/// support that holds one of x, y and z across the axis of heights, and whose nodes all lie at one place of it and do
/// not move along it, holds the garment as its own mirror image would.
std::vector<int> mirror_planes(const scene::Scene& scene);

}  // namespace toile::run
