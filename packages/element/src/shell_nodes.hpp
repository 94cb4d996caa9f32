#pragma once

#include <algorithm>
#include <cstddef>

#include "director.hpp"
#include "toile/element/element.hpp"

namespace toile::element {

/// Nodes of one shell element: reference and current position (mm) and director.
template <int Nodes>
struct ShellNodes {
  double pattern[Nodes][2];
  double X[Nodes][3], D[Nodes][3];
  double x[Nodes][3], d[Nodes][3];
  Director director[Nodes];

  void set_reference(const Batch& batch, std::ptrdiff_t e);
  void set_positions(const Batch& batch, std::ptrdiff_t e);
  void set_directors(const Batch& batch, std::ptrdiff_t e);
};

template <int Nodes>
void ShellNodes<Nodes>::set_reference(const Batch& batch, std::ptrdiff_t e) {
  for (int i = 0; i < Nodes; ++i) {
    const std::ptrdiff_t node = Nodes * e + i;
    const double* flat = batch.pattern + 2 * node;
    const double plane[6] = {flat[0], flat[1], 0.0, 0.0, 0.0, 1.0};
    const double* values = batch.reference ? batch.reference + 6 * node : plane;
    std::copy_n(flat, 2, pattern[i]);
    std::copy_n(values, 3, X[i]);
    std::copy_n(values + 3, 3, D[i]);
  }
}

template <int Nodes>
void ShellNodes<Nodes>::set_positions(const Batch& batch, std::ptrdiff_t e) {
  for (int i = 0; i < Nodes; ++i) std::copy_n(batch.x + 5 * (Nodes * e + i), 3, x[i]);
}

template <int Nodes>
void ShellNodes<Nodes>::set_directors(const Batch& batch, std::ptrdiff_t e) {
  for (int i = 0; i < Nodes; ++i) {
    const std::ptrdiff_t node = Nodes * e + i;
    director[i] = element::director(batch.frames + 9 * node, batch.x + 5 * node + 3);
    std::copy_n(director[i].d, 3, d[i]);
  }
}

}  // namespace toile::element
