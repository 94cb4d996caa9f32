#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::result {

/// A part of the estimated error of the pressure.
struct PressureError {
  std::string name;
  std::vector<double> values;  ///< [node] MPa; those with a sign cancel in a mean
};

/// The deformed garment with the fields that are averaged around its sections.
struct GarmentFields {
  const mesh::Mesh* mesh = nullptr;
  std::vector<mesh::Vec3> position;  ///< [node] mm
  /// [node] the first of the nodes that a closed seam holds together here, itself if there is none. Empty: no seams.
  std::vector<int> tied = {};
  std::vector<double> pressure = {};  ///< [node] contact pressure, MPa
  /// Independent of each other. A section adds to the first what it misses between two rows of nodes. Empty: not known.
  std::vector<PressureError> pressure_errors = {};
  std::vector<Eigen::Matrix3d> tension = {};  ///< [element] force per current length in space, symmetric, N/mm
  std::vector<double> smallest_stress = {};   ///< [element] smallest principal Cauchy stress, MPa
  /// [element] true where a support ends: a held node passes the tension on to the body as a line force, so the
  /// pressure there depends on the mesh. Empty: nowhere.
  std::vector<bool> at_support = {};
  /// [node] number of the plane of symmetry that it is held in: the garment goes on beyond as its mirror image; -1: in
  /// none. Empty: nowhere.
  std::vector<int> mirror = {};
};

}  // namespace toile::result
