#pragma once

#include <algorithm>

#include "membrane_point.hpp"
#include "nodal_system.hpp"
#include "reference_point.hpp"
#include "vector.hpp"

namespace toile::element {

/// Kinematics of a shell at one in-plane point, in the material frame of its reference.
///
/// With a_a = sum_i g_ai x_i and d_a = l sum_i g_ai d_i (l the frozen thickness stretch), the surface at height z has
/// the base p_a(z) = a_a + z d_a, and C_ab(z) = delta_ab + p_a.p_b - P_a.P_b with P_a the same of the reference, where
/// l = 1. The shifter is neglected: stretches refer to the mid-surface of the reference, an error of order z/R. So each
/// layer is a membrane through x_i + z l d_i, and its second derivatives are the membrane's times 1, z l and z^2 l^2.
template <int Nodes>
struct ShellPoint {
  ReferencePoint<Nodes> reference;
  double curvature[3];  ///< (P.P)_ab is delta_ab + z curvature + z^2 square, in the order 11, 22, 12
  double square[3];
  double l;        ///< h/h0 at the start of the step
  double a[2][3];  ///< mid-surface base
  double d[2][3];  ///< derivatives of the director, times l, 1/mm

  /// Sets curvature and square; `reference` is there already.
  void set_curvature(const ShellNodes<Nodes>& nodes);
  void deform(const ShellNodes<Nodes>& nodes, double thickness_stretch);
  void base(double z, double (&p)[2][3]) const;
  /// C11, C22, C12 at height z; of negative determinant, which neither a law nor a relaxed one admits, of a layer that
  /// curvature has turned inside out (its C alone would not tell).
  void deformation(double z, double (&C)[3]) const;
};

/// Derivatives of the energy of one in-plane point, summed over its layers.
struct Resultants {
  double force[2][2][3] = {};  ///< with respect to a_a and to d_a (times l)
  double stiffness[3][6][6];   ///< moments 0, 1, 2 in z of the membrane's Hessian

  void clear_stiffness() { std::fill_n(&stiffness[0][0][0], 3 * 36, 0.0); }
  /// Adds a layer at height z with base p whose weighted stress is S.
  void add_force(double z, const double (&p)[2][3], const double (&S)[3]);
  void add_stiffness(double z, const double (&p)[2][3], const double (&S)[3], const double (&D)[6]);
  /// Adds to the system of the element's nodes.
  template <int Nodes>
  void spread_force(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const;
  template <int Nodes>
  void spread_stiffness(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const;
};

template <int Nodes>
void ShellPoint<Nodes>::set_curvature(const ShellNodes<Nodes>& nodes) {
  double D[2][3];
  for (int b = 0; b < 2; ++b) combine(reference.g[b], nodes.D, D[b]);
  const auto& A = reference.axis;
  for (int b = 0; b < 2; ++b) {
    curvature[b] = 2.0 * dot(A[b], D[b]);
    square[b] = dot(D[b], D[b]);
  }
  curvature[2] = dot(A[0], D[1]) + dot(A[1], D[0]);
  square[2] = dot(D[0], D[1]);
}

template <int Nodes>
void ShellPoint<Nodes>::deform(const ShellNodes<Nodes>& nodes, double thickness_stretch) {
  l = thickness_stretch;
  for (int b = 0; b < 2; ++b) {
    combine(reference.g[b], nodes.x, a[b]);
    combine(reference.g[b], nodes.d, d[b]);
    for (double& component : d[b]) component *= l;
  }
}

template <int Nodes>
void ShellPoint<Nodes>::base(double z, double (&p)[2][3]) const {
  for (int b = 0; b < 2; ++b) {
    for (int c = 0; c < 3; ++c) p[b][c] = a[b][c] + z * d[b][c];
  }
}

template <int Nodes>
void ShellPoint<Nodes>::deformation(double z, double (&C)[3]) const {
  double p[2][3], normal[3], layer_normal[3];
  base(z, p);
  cross(a[0], a[1], normal);
  cross(p[0], p[1], layer_normal);
  if (!(dot(normal, layer_normal) > 0.0)) {
    C[0] = -1.0;
    C[1] = 1.0;
    C[2] = 0.0;
    return;
  }
  C[0] = dot(p[0], p[0]);
  C[1] = dot(p[1], p[1]);
  C[2] = dot(p[0], p[1]);
  for (int q = 0; q < 3; ++q) C[q] -= z * (curvature[q] + z * square[q]);
}

inline void Resultants::add_force(double z, const double (&p)[2][3], const double (&S)[3]) {
  for (int c = 0; c < 3; ++c) {
    const double P[2] = {S[0] * p[0][c] + S[2] * p[1][c], S[2] * p[0][c] + S[1] * p[1][c]};
    for (int b = 0; b < 2; ++b) {
      force[0][b][c] += P[b];
      force[1][b][c] += z * P[b];
    }
  }
}

inline void Resultants::add_stiffness(double z, const double (&p)[2][3], const double (&S)[3], const double (&D)[6]) {
  double A[6][6];
  plane_hessian(p, S, D, A);
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) {
      stiffness[0][r][c] += A[r][c];
      stiffness[1][r][c] += z * A[r][c];
      stiffness[2][r][c] += z * z * A[r][c];
    }
  }
}

template <int Nodes>
void Resultants::spread_force(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const {
  const auto& g = point.reference.g;
  for (int i = 0; i < Nodes; ++i) {
    for (int c = 0; c < 3; ++c) {
      system.force[i][c] += g[0][i] * force[0][0][c] + g[1][i] * force[0][1][c];
      system.force[i][3 + c] += point.l * (g[0][i] * force[1][0][c] + g[1][i] * force[1][1][c]);
    }
  }
}

// Moment 0 couples positions, moment 1 positions with directors, moment 2 directors.
template <int Nodes>
void Resultants::spread_stiffness(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const {
  const auto& g = point.reference.g;
  const double scale[3] = {1.0, point.l, point.l * point.l};
  for (int i = 0; i < Nodes; ++i) {
    double half[3][3][6];
    for (int k = 0; k < 3; ++k) {
      const double g0 = scale[k] * g[0][i], g1 = scale[k] * g[1][i];
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 6; ++c) half[k][r][c] = g0 * stiffness[k][r][c] + g1 * stiffness[k][3 + r][c];
      }
    }
    for (int j = i; j < Nodes; ++j) {
      auto& block = system.block(i, j);
      const double g0 = g[0][j], g1 = g[1][j];
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const double coupling = half[1][r][c] * g0 + half[1][r][3 + c] * g1;
          block[r][c] += half[0][r][c] * g0 + half[0][r][3 + c] * g1;
          block[r][3 + c] += coupling;
          block[3 + r][c] += coupling;
          block[3 + r][3 + c] += half[2][r][c] * g0 + half[2][r][3 + c] * g1;
        }
      }
    }
  }
}

}  // namespace toile::element
