#pragma once

#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::run {

/// Of a garment and a disc, on a plane across the axis of light.
struct Shadow {
  double area = 0.0;            ///< mm^2, the disc's included
  std::vector<double> outline;  ///< [direction] largest distance from the axis, mm; directions at equal angles
};

/// `position`: [node] mm. The axis goes through `point` along `direction`, of any length. The area is that of the union
/// of the elements' shadows along `directions` rays, whatever lies over what.
Shadow shadow(const mesh::Mesh& mesh, const std::vector<solve::Vec3>& position, const solve::Vec3& point,
              const solve::Vec3& direction, double disc_radius, int directions = 1440);

/// Places where a closed curve of distances stands forward by `least` or more of what lies on both sides.
int count_folds(const std::vector<double>& outline, double least);

/// What a drapemeter tells of a fabric.
struct DrapeReading {
  double coefficient = 0.0;
  int folds = 0;
  Shadow shadow;
};

/// Of the garment in the scene's Drapemeter, which must be there. `position`: [node] mm.
DrapeReading read_drape(const scene::Scene& scene, const std::vector<solve::Vec3>& position);

}  // namespace toile::run
