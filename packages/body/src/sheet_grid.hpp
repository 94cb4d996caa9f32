#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "surface_samples.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Cells of a uniform grid near the facets of a mesh, and the nodes (B-spline coefficients) that they use. Position
/// (i, j, k) spans origin + h (i..i+1, j..j+1, k..k+1); a cell there uses the nodes i..i+3, j..j+3, k..k+3.
/// Where several sheets of the surface pass a position (two thighs), each has a cell of its own there, and its own
/// nodes as far as the sheets do not meet within the reach of a node.
class SheetGrid {
 public:
  using Position = std::array<int, 3>;
  static constexpr double sample_spacing = 0.5;  ///< between the samples that a grid is made from, cells
  struct Cell {
    Position at{};
    std::array<int, 64> unknowns{};  ///< of the node (i + n / 16, j + n / 4 % 4, k + n % 4)
    int sample = -1;                 ///< one of its sheet's, near it
  };

  /// Samples that are not linked belong to different sheets near them. Throws InputError if the box has too many cells.
  SheetGrid(const SurfaceSamples& samples, double cell);
  /// Of cells half as large as those of `coarse`, eight in each of its positions.
  SheetGrid(const SurfaceSamples& samples, const SheetGrid& coarse);
  /// The box round the points, mm. Throws InputError if a grid of these cells round them would be too large.
  static Eigen::AlignedBox3d box_of(const std::vector<Vec3>& points, double cell);
  /// Positions in the grid's box.
  double positions() const { return static_cast<double>(size_[0]) * size_[1] * size_[2]; }

  double cell() const { return cell_; }
  const std::vector<Cell>& cells() const { return cells_; }
  int unknowns() const { return static_cast<int>(nodes_.size()); }
  const std::vector<Position>& nodes() const { return nodes_; }  ///< grid position of each unknown
  /// Position of `point` in cells.
  Vec3 local(const Vec3& point) const { return (point - origin_) / cell_; }
  Vec3 point(const Vec3& local) const { return origin_ + cell_ * local; }
  /// Cells at that place, in local coordinates: [first, end); none outside.
  std::array<int, 2> cells_at(const Vec3& local) const;
  /// Of them, the cell of the sheet that holds the sample; -1 if there is none.
  int cell_of(const Vec3& local, int sample) const;
  /// Of them, the cell on the same sheet as `cell`, which is no further than three cells away; -1 if there is none.
  int continued(int cell, const Vec3& local) const;
  /// Nodes that two cells share; 0: they lie on different sheets, or more than three cells apart.
  int common_nodes(int a, int b) const;
  /// Positions with more than one cell.
  int shared_positions() const;

 private:
  /// A sample near a cell.
  struct Entry {
    int position = 0;
    int sample = 0;
    int cell = 0;
  };

  int index(const Position& at) const { return (at[0] * size_[1] + at[1]) * size_[2] + at[2]; }
  Position position(int index) const {
    return {index / (size_[1] * size_[2]), index / size_[2] % size_[1], index % size_[2]};
  }
  void make_box(const Eigen::AlignedBox3d& box);
  void make_cells(const SurfaceSamples& samples);
  std::vector<Entry> entries_near(const SurfaceSamples& samples) const;
  void part_sheets(const SurfaceSamples& samples, std::vector<Entry>* entries);
  /// For each cell, the cells of the same sheet beyond its three upper sides.
  std::vector<std::array<std::vector<int>, 3>> neighbours(const std::vector<Entry>& entries) const;
  void number_nodes(const std::vector<std::array<std::vector<int>, 3>>& beyond);
  /// Cells of one position with the same nodes become one.
  void merge_equal_cells(std::vector<Entry>* entries);
  void keep_shared(const std::vector<Entry>& entries);
  /// Cells at an index of the box: [first, end).
  std::array<int, 2> cells_of(int index) const;

  double cell_;
  Vec3 origin_;
  Position size_{};
  std::vector<int> first_;  ///< cell at each position of the box, -1: none; the cells of one position are consecutive
  std::vector<Cell> cells_;
  std::vector<Position> nodes_;
  std::vector<std::array<int, 2>> shared_;  ///< (cell, sample) at positions with several cells, sorted
};

}  // namespace toile::body
