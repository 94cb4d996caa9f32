#pragma once

#include <functional>
#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"
#include "toile/result/garment_fields.hpp"
#include "toile/result/plot.hpp"

namespace toile::result {

/// Point of an axis and its direction there, a unit vector.
struct AxisPlace {
  mesh::Vec3 point;
  mesh::Vec3 direction;
};

/// Line along which heights are measured.
struct Axis {
  mesh::Vec3 point = mesh::Vec3::Zero();       ///< height 0 of a straight axis
  mesh::Vec3 direction = mesh::Vec3::UnitZ();  ///< of a straight axis; any length but zero
  /// Of the axis of a bent limb: where it is at a height (mm along it, 0 to `length`; it goes on beyond). Empty: the
  /// axis is straight.
  std::function<AxisPlace(double)> bent = {};
  double length = 0.0;  ///< of the bent part, mm
};

/// A named height along the axis, for instance the hosiery levels B, B1, C, D, F, G.
struct Level {
  std::string name;
  double height = 0.0;  ///< mm
};

/// One section of the garment by the plane at one height, or several that lie over each other. Means are weighted by
/// length. A value that does not exist is NaN: all of them if the plane misses the garment.
struct LevelRow {
  std::string name;
  std::string section;          ///< number among the sections of that height, "1+2" for the sum of layers; one: empty
  std::string panels;           ///< that it cuts
  double height = 0.0;          ///< mm
  bool closed = false;          ///< the section runs round; an open one has no radius
  bool mirrored = false;        ///< it does so with its mirror image in a plane of symmetry, which the girth holds
  double girth = 0.0;           ///< length of the section, mm
  double pressure_mean = 0.0;   ///< MPa; of layers: what they press on the body together
  double pressure_min = 0.0;    ///< MPa
  double pressure_max = 0.0;    ///< MPa
  double pressure_error = 0.0;  ///< estimate of the error of the mean, MPa: the root of the sum of squares of its parts
  /// [part of GarmentFields::pressure_errors] MPa
  std::vector<double> error_parts = {};
  double radius = 0.0;           ///< girth / 2 pi, mm: the mean curvature of a closed section is its inverse
  double hoop_tension = 0.0;     ///< mean tension T along the section, t.N.t with its tangent t, N/mm
  double laplace = 0.0;          ///< T / radius, MPa: Laplace's law for a tube without curvature along it
  double smallest_stress = 0.0;  ///< smallest value that the section meets, MPa
  bool at_support = false;       ///< the section meets an element where a support ends: its pressure tells nothing

  bool reached() const { return !panels.empty(); }
  /// Name with the section's number: "C", "C (2)".
  std::string title() const { return section.empty() ? name : name + " (" + section + ")"; }
};

/// The sections at each level, in their order: a row each, in the order of the panels in the scene, and one for the sum
/// of those that lie over each other. Along a bent axis only those that surround it.
std::vector<LevelRow> levels(const GarmentFields& garment, const Axis& axis, const std::vector<Level>& levels);

/// The closed sections at `stations` (>= 2) evenly spaced heights from the garment's lower to its upper end, without
/// names.
std::vector<LevelRow> pressure_curve(const GarmentFields& garment, const Axis& axis, int stations);

/// What a reader of the rows should know: levels that are not reached, and those whose section is open.
std::vector<std::string> level_warnings(const GarmentFields& garment, const Axis& axis,
                                        const std::vector<LevelRow>& rows);

/// The rows as CSV, pressures in kPa and mmHg; a value that does not exist is an empty cell. `error_parts`: their
/// names; empty: they are not written. Throws InputError.
void write_pressure_csv(const std::string& path, const std::vector<LevelRow>& rows,
                        const std::vector<std::string>& error_parts = {});

/// Mean pressure (left out at supports) and Laplace's T/r along the axis in kPa, with mmHg on the right, and a marker
/// at each level that the garment reaches.
Plot pressure_plot(const std::string& title, const std::vector<LevelRow>& curve, const std::vector<LevelRow>& levels);

}  // namespace toile::result
