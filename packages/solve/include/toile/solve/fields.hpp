#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "toile/crossing/crossings.hpp"
#include "toile/solve/pressure_errors.hpp"
#include "toile/solve/problem.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::solve {

/// A value a node, an element or a step.
struct NamedField {
  std::string name;
  std::string unit;  ///< empty: dimensionless
  std::vector<double> values;
  bool on_body = false;  ///< nodal: also shown on the body
};

/// What is known of one state; output_fields.hpp makes of it what is written.
struct Fields {
  std::vector<Vec3> position;  ///< [node] mm
  /// [node] MPa: what the fabric's tension presses on the body, recovered from tension and curvature (see
  /// contact::recover), per current area as in ContactOptions; 0 where the fabric does not touch. Nodes that a seam
  /// ties within a panel share one value; panels on either side of a seam have their own.
  std::vector<double> pressure;
  std::vector<double> pressure_error;  ///< [node] MPa: estimate of its size, of all parts; not of the fabric's model
  PressureErrors errors;               ///< the parts
  std::vector<double> body_change;     ///< [node] MPa: that of the body with its sign, see contact::SitePressure
  std::vector<double> contact_force;   ///< [node] N along `normal`: of the solve; a cluster's is shared out by area
  std::vector<double> gap;             ///< [node] mm, of the fabric's contact surface; 0 without a body
  std::vector<double> offset;     ///< [node] mm from there to the mid-surface: see ContactOptions, Problem::beneath
  std::vector<Vec3> normal;       ///< [node] of the body at the closest point
  std::vector<double> area;       ///< [node] current area that belongs to the node alone, mm^2
  crossing::Crossings crossings;  ///< empty if they are not looked for
  /// [block] a value an element; the table is in element_fields.cpp
  std::vector<std::vector<NamedField>> element;
  /// [element] of all blocks: mean over its points of the force per current length in space, symmetric, N/mm
  std::vector<Eigen::Matrix3d> tension;
  /// [block] parts of the pattern's area that are taut, wrinkled and slack (material::WrinkleState).
  std::vector<std::array<double, 3>> wrinkle_shares;
  double smallest_principal_stress = 0.0;  ///< Cauchy, MPa
  int smallest_stress_block = 0;           ///< where it is
  double largest_extrapolation = 0.0;  ///< largest fibre stretch in an element outside the calibrated range; 0: none
  std::string extrapolated_where;      ///< block and element of it
  int isolated_contacts = 0;           ///< clusters in contact whose neighbours are all free
  int contacts_off_surface = 0;        ///< clusters in contact where the body has no smooth surface, only facets
};

/// [node] mm
std::vector<Vec3> node_positions(const Problem& problem, const State& state);

/// Evaluates the whole garment on the calling rank. `accuracy`: of the state, for the errors of the pressure.
Fields compute_fields(const Problem& problem, const State& state, const Accuracy& accuracy = {});

/// Sum over the garment of the nodal contact forces: what the garment feels of the body (N).
Vec3 contact_resultant(const Fields& fields);

/// [x, y, z] error of it (N) by that of the pressures, as if all of them erred alike: the integral of pressure_error
/// |n_d| over the garment. Far too large over tips and where directions cancel; of a sleeve between held hems on a leg,
/// whose force along the axis is that of the hems, it is 0.6 to 1 times the true one.
Vec3 contact_resultant_error(const Fields& fields);

/// Sum over the garment of pressure times area times normal of the written fields (N). It differs from the sum of the
/// forces by the error of the pressure, and by what supports take of the fabric's pull on the body.
Vec3 pressure_resultant(const Fields& fields);

}  // namespace toile::solve
