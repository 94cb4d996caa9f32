#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Values and derivatives of the four cubic B-splines that are non-zero on a cell, at t in [0, 1] of the cell:
/// row = order of the derivative (0..3), column = spline.
Eigen::Matrix4d cubic_splines(double t);

/// Cells of a uniform grid near the facets of a mesh, and the nodes (B-spline coefficients) that they use.
/// Cell (i, j, k) spans origin + h (i..i+1, j..j+1, k..k+1) and uses the nodes i..i+3, j..j+3, k..k+3.
class CellGrid {
 public:
  /// Active are the cells that hold a point of the facets, and their 26 neighbours.
  CellGrid(const TriangleMesh& mesh, double cell);

  double cell() const { return cell_; }
  int active_cells() const { return active_cells_; }
  int unknowns() const { return static_cast<int>(nodes_.size()); }
  const std::vector<std::array<int, 3>>& nodes() const { return nodes_; }  ///< grid position of each unknown
  /// Position of `point` in cells.
  Vec3 local(const Vec3& point) const { return (point - origin_) / cell_; }
  /// Grid position of the first node of the active cell at `local`; false outside the active cells.
  bool locate(const Vec3& local, std::array<int, 3>* position) const;
  bool is_active(int i, int j, int k) const { return active_[cell_index(i, j, k)] != 0; }
  const std::array<int, 3>& cells() const { return cells_; }
  /// Unknown of the node at that grid position, -1 if no active cell uses it.
  int unknown(int i, int j, int k) const { return unknown_[(i * (cells_[1] + 3) + j) * (cells_[2] + 3) + k]; }

 private:
  int cell_index(int i, int j, int k) const { return (i * cells_[1] + j) * cells_[2] + k; }
  void mark(const TriangleMesh& mesh);
  void number_nodes();

  double cell_;
  Vec3 origin_;
  std::array<int, 3> cells_;
  std::vector<char> active_;
  std::vector<int> unknown_;
  std::vector<std::array<int, 3>> nodes_;
  int active_cells_ = 0;
};

/// Tricubic B-spline f on the active cells, in mm.
class SplineField {
 public:
  struct Value {
    double value = 0.0;            ///< mm
    Vec3 gradient = Vec3::Zero();  ///< dimensionless
    Mat3 hessian = Mat3::Zero();   ///< 1/mm
  };
  /// `coefficients`: one for each unknown of the grid, in cells.
  SplineField(CellGrid grid, std::vector<double> coefficients)
      : grid_(std::move(grid)), coefficients_(std::move(coefficients)) {}
  /// False outside the active cells.
  bool evaluate(const Vec3& point, Value* result) const;
  const CellGrid& grid() const { return grid_; }

 private:
  CellGrid grid_;
  std::vector<double> coefficients_;
};

/// Least-squares fit of a level set to vertices (f = 0) and vertex normals (grad f = n), with the integral of the
/// squared third derivatives times `smoothing`; see the README. Throws InputError if the system cannot be factorised.
SplineField fit_level_set(const TriangleMesh& mesh, double cell, double smoothing);

}  // namespace toile::body
