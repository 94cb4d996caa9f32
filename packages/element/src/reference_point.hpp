#pragma once

#include <cmath>

#include "shell_nodes.hpp"
#include "vector.hpp"

namespace toile::element {

/// Orthonormal material frame of the reference surface at one point.
///
/// Axis 1 is the image in the reference's tangent plane of the pattern's wale direction, normalised; axis 2 completes
/// it counter-clockwise about A_1 x A_2. The pattern of a curved reference is only a parametrisation; of a flat one
/// this is the frame of the membranes.
template <int Nodes>
struct ReferencePoint {
  double axis[2][3];         ///< the material axes
  double to_material[2][2];  ///< A^r . axis_a: turns derivatives by the parent coordinate r into those along axis a
  double g[2][Nodes];        ///< gradients of the shape functions along the axes, 1/mm
  double area;               ///< reference area of the point, mm^2; not positive: pattern or reference are folded there

  void set(const ShellNodes<Nodes>& nodes, const double (&dN)[Nodes][2], double weight, double cosine, double sine);

 private:
  void set_axes(const double (&A)[2][3], const double (&wale)[2], double weight, const double (&D)[3]);
};

template <int Nodes>
void ReferencePoint<Nodes>::set(const ShellNodes<Nodes>& nodes, const double (&dN)[Nodes][2], double weight,
                                double cosine, double sine) {
  double A[2][3] = {}, J[2][2] = {}, D[3] = {};
  for (int i = 0; i < Nodes; ++i) {
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 3; ++c) A[r][c] += dN[i][r] * nodes.X[i][c];
      for (int c = 0; c < 2; ++c) J[r][c] += dN[i][r] * nodes.pattern[i][c];
    }
    for (int c = 0; c < 3; ++c) D[c] += nodes.D[i][c];
  }
  // Parent components of the wale direction, up to the positive factor det J.
  const double wale[2] = {J[1][1] * cosine - J[1][0] * sine, J[0][0] * sine - J[0][1] * cosine};
  set_axes(A, wale, weight, D);
  if (!(J[0][0] * J[1][1] - J[0][1] * J[1][0] > 0.0)) area = -std::abs(area);
  for (int axis_index = 0; axis_index < 2; ++axis_index) {
    for (int i = 0; i < Nodes; ++i) {
      g[axis_index][i] = dN[i][0] * to_material[0][axis_index] + dN[i][1] * to_material[1][axis_index];
    }
  }
}

template <int Nodes>
void ReferencePoint<Nodes>::set_axes(const double (&A)[2][3], const double (&wale)[2], double weight,
                                     const double (&D)[3]) {
  double normal[3], dual[2][3];
  cross(A[0], A[1], normal);
  const double measure = std::sqrt(dot(normal, normal)), inverse = 1.0 / measure;
  for (double& component : normal) component *= inverse;
  cross(A[1], normal, dual[0]);
  cross(normal, A[0], dual[1]);
  for (int c = 0; c < 3; ++c) axis[0][c] = wale[0] * A[0][c] + wale[1] * A[1][c];
  const double shrink = 1.0 / std::sqrt(dot(axis[0], axis[0]));
  for (double& component : axis[0]) component *= shrink;
  cross(normal, axis[0], axis[1]);
  for (int r = 0; r < 2; ++r) {
    for (int a = 0; a < 2; ++a) to_material[r][a] = dot(dual[r], axis[a]) * inverse;
  }
  area = dot(normal, D) > 0.0 ? measure * weight : -measure * weight;
}

}  // namespace toile::element
