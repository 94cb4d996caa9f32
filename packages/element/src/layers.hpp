#pragma once

namespace toile::element {

/// Gauss rule through the thickness: places on [-1, 1], weights with sum one.
struct Layers {
  int n;
  const double* place;
  const double* weight;
};

/// `n`: 1, 3, 5 or 7; the middle layer is the mid-surface.
Layers gauss_layers(int n);

}  // namespace toile::element
