#pragma once

#include <array>
#include <numeric>
#include <vector>

namespace toile::body {

/// Connected pieces of a set of triangles: union-find over the vertices.
class Pieces {
 public:
  Pieces(std::size_t vertices, const std::vector<std::array<int, 3>>& triangles) : parent_(vertices) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const auto& t : triangles) {
      parent_[root(t[0])] = root(t[1]);
      parent_[root(t[1])] = root(t[2]);
    }
  }
  /// The same vertex for all triangles of a piece.
  int of(const std::array<int, 3>& triangle) { return root(triangle[0]); }

 private:
  int root(int i) {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }
  std::vector<int> parent_;
};

}  // namespace toile::body
