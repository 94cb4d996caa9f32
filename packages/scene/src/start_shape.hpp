// The placed start as a shape: deformation of its elements, lengths of its edges.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "toile/mesh/mesh.hpp"
#include "toile/solve/problem.hpp"

namespace toile::scene {

/// Deformation of one element at its centre.
struct Deformation {
  Eigen::Matrix<double, 3, 2> F = Eigen::Matrix<double, 3, 2>::Zero();  ///< d position / d pattern
  solve::Vec3 centre = solve::Vec3::Zero();                             ///< mm
  double wale_angle = 0.0;                                              ///< radians from the pattern's x axis

  /// Image of a unit vector of the pattern, given by its angle from the pattern's x axis; its length is the stretch.
  solve::Vec3 along(double angle) const;
  solve::Vec3 wale() const { return along(wale_angle); }
  solve::Vec3 course() const;
  /// Principal stretches, larger first.
  std::pair<double, double> principal() const;
};

/// All elements of a block, at these node positions.
std::vector<Deformation> deformations(const mesh::Mesh& mesh, const mesh::Block& block,
                                      const std::vector<solve::Vec3>& position);

/// Length of the line through some nodes, mm.
double length_of_line(const std::vector<int>& nodes, const std::vector<solve::Vec3>& position);

/// Mean length of the sides of a block's elements, mm.
double mean_side(const mesh::Block& block, const std::vector<solve::Vec3>& position);

/// Name of the panel of an edge: "front" of "front.left".
std::string panel_of_edge(const std::string& edge);
/// Whether an edge is the left or the right one of its panel, which run along a limb.
bool is_side(const std::string& edge);

}  // namespace toile::scene
