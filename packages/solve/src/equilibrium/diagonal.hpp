#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "equilibrium/layout.hpp"

namespace toile::solve {

/// Where the blocks of each cluster and each rotation with itself are in the values of the tangent; -1: held, or not of
/// this rank.
struct Diagonal {
  Diagonal(const Layout& layout, const Graph& graph);

  /// Adds a symmetric matrix of space [3][3] to the block of an owned cluster.
  void add(size_t cluster, const Eigen::Matrix3d& block, double* values) const;
  /// Adds factor times mass [local cluster] to the positions' entries.
  void add_mass(double factor, const std::vector<double>& mass, double* values) const;

  std::vector<std::array<std::array<std::int64_t, 3>, 3>> positions;  ///< [owned cluster]
  std::vector<std::array<std::int64_t, 2>> rotations;                 ///< [local node]; empty without shells

 private:
  const Layout& layout_;
};

}  // namespace toile::solve
