#pragma once

#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"
#include "toile/result/plot.hpp"

namespace toile::result {

/// Line along which heights are measured, from `point` (height 0).
struct Axis {
  mesh::Vec3 point = mesh::Vec3::Zero();
  mesh::Vec3 direction = mesh::Vec3::UnitZ();  ///< any length but zero
};

/// A named height along the axis, for instance the hosiery levels B, B1, C, D, F, G.
struct Level {
  std::string name;
  double height = 0.0;  ///< mm
};

/// The deformed garment with the fields that are averaged around its sections.
struct GarmentFields {
  const mesh::Mesh* mesh = nullptr;
  std::vector<mesh::Vec3> position;     ///< [node] mm
  std::vector<double> pressure;         ///< [node] contact pressure, MPa
  std::vector<double> hoop_tension;     ///< [element] force per length across the section, N/mm
  std::vector<double> smallest_stress;  ///< [element] smallest principal Cauchy stress, MPa
  /// [element] true where a support ends: a held node passes the tension on to the body as a line force, so the
  /// pressure there depends on the mesh. Empty: nowhere.
  std::vector<bool> at_support = {};
};

/// The garment cut by the plane at one height. Means are weighted by length. All but name, height, girth and turn are
/// NaN if the plane misses the garment.
struct LevelRow {
  std::string name;
  double height = 0.0;           ///< mm
  double girth = 0.0;            ///< length of the section, mm
  double turn = 0.0;             ///< part of a full turn that the section covers, seen from its centre; 1: closed
  double pressure_mean = 0.0;    ///< MPa
  double pressure_min = 0.0;     ///< MPa
  double pressure_max = 0.0;     ///< MPa
  double radius = 0.0;           ///< girth / 2 pi, mm: the mean curvature of a closed section is its inverse
  double hoop_tension = 0.0;     ///< mean T, N/mm
  double laplace = 0.0;          ///< T / radius, MPa: Laplace's law for a tube without curvature along it
  double smallest_stress = 0.0;  ///< smallest value that the section meets, MPa
  bool at_support = false;       ///< the section meets an element where a support ends: its pressure tells nothing
};

/// One row a level, in their order.
std::vector<LevelRow> levels(const GarmentFields& garment, const Axis& axis, const std::vector<Level>& levels);

/// `stations` (>= 2) evenly spaced rows without names from the garment's lower to its upper end; sections that do not
/// close around the axis (at uneven ends) are left out.
std::vector<LevelRow> pressure_curve(const GarmentFields& garment, const Axis& axis, int stations);

/// The rows as CSV, pressures in kPa and mmHg; a value that does not exist is an empty cell. Throws InputError.
void write_pressure_csv(const std::string& path, const std::vector<LevelRow>& rows);

/// Mean pressure (left out at supports) and Laplace's T/r along the axis in kPa, with mmHg on the right, and a marker
/// at each level that the garment reaches.
Plot pressure_plot(const std::string& title, const std::vector<LevelRow>& curve, const std::vector<LevelRow>& levels);

}  // namespace toile::result
