#pragma once

#include <cstdint>
#include <vector>

#include "equilibrium/layout.hpp"

namespace toile::solve {

/// Place of an entry in the values of the graph's matrix; -1 where the row is not of this rank, or either is held.
std::int64_t place_of(const Graph& graph, LocalId row, LocalId column);

/// Where the second derivatives of one block's elements go in the tangent: those by the positions of their nodes, and
/// by the rotations if they are wanted and there are any.
class Stencils {
 public:
  Stencils(const Layout& layout, const Layout::BlockPart& block, const Graph& graph, bool with_rotations);

  int unknowns() const { return unknowns_; }  ///< of an element: 3 or 5 times its nodes
  /// Adds the derivatives of all elements [element][unknown][unknown] by x, y, z (and w). They are turned in place to
  /// the components of the clusters.
  void add(double* derivatives, double* values) const;

 private:
  void turn(size_t element, double* derivatives) const;

  const Layout& layout_;
  const Layout::BlockPart& block_;
  int nodes_ = 0, unknowns_ = 0;
  std::vector<std::int64_t> places_;  ///< [element][unknown][unknown]
  std::vector<size_t> turned_;        ///< elements with a node whose components are not x, y and z
};

}  // namespace toile::solve
