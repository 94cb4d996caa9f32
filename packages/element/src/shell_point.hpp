#pragma once

#include <algorithm>

#include "director_gradient.hpp"
#include "membrane_point.hpp"
#include "nodal_system.hpp"
#include "reference_point.hpp"
#include "vector.hpp"

namespace toile::element {

/// Kinematics of a shell at one in-plane point, in the material frame of its reference.
///
/// With a_a = sum_i g_ai x_i and d_a, l times the derivative of the director (see DirectorGradient; l is the frozen
/// thickness stretch), the surface at height z has the base p_a(z) = a_a + z d_a, and C_ab(z) = delta_ab + p_a.p_b -
/// P_a.P_b with P_a the same of the reference, where l = 1. The shifter is neglected: stretches refer to the
/// mid-surface of the reference, an error of order z/R. The second derivatives of each layer by a_a and d_a are those
/// of a membrane times 1, z and z^2.
template <int Nodes>
struct ShellPoint {
  ReferencePoint<Nodes> reference;
  double curvature[3];  ///< (P.P)_ab is delta_ab + z curvature + z^2 square, in the order 11, 22, 12
  double square[3];
  double l;               ///< h/h0 at the start of the step
  double a[2][3];         ///< mid-surface base
  double d[2][3];         ///< derivatives of the director, times l, 1/mm
  double straight[2][3];  ///< l sum_i g_ai d_i: the same of a director that is interpolated straight
  DirectorGradient<Nodes> gradient;

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
  double stiffness[3][6][6];   ///< moments 0, 1, 2 in z of the membrane's Hessian: (a, a), (a, d), (d, d)

  void clear_stiffness() { std::fill_n(&stiffness[0][0][0], 3 * 36, 0.0); }
  /// Adds a layer at height z with base p whose weighted stress is S.
  void add_force(double z, const double (&p)[2][3], const double (&S)[3]);
  void add_stiffness(double z, const double (&p)[2][3], const double (&S)[3], const double (&D)[6]);
  /// Turns derivatives by d_a into those by sum_i g_ai d_i. After the last layer.
  template <int Nodes>
  void refer_to_directors(const ShellPoint<Nodes>& point, bool with_stiffness);
  /// Adds to the system of the element's nodes.
  template <int Nodes>
  void spread_force(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const;
  template <int Nodes>
  void spread_stiffness(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const;
};

template <int Nodes>
void ShellPoint<Nodes>::set_curvature(const ShellNodes<Nodes>& nodes) {
  double D[2][3];
  gradient.set_reference(reference);
  for (int b = 0; b < 2; ++b) combine(reference.g[b], nodes.D, straight[b]);
  gradient.turn(straight, D);
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
    combine(reference.g[b], nodes.d, straight[b]);
  }
  gradient.turn(straight, d);
  for (int b = 0; b < 2; ++b) {
    for (int c = 0; c < 3; ++c) {
      d[b][c] *= l;
      straight[b][c] *= l;
    }
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

/// K <- scale K J.
inline void multiply(double (&K)[6][6], double scale, const double (&J)[6][6]) {
  for (auto& row : K) {
    double product[6] = {};
    for (int r = 0; r < 6; ++r) {
      for (int c = 0; c < 6; ++c) product[c] += row[r] * J[r][c];
    }
    for (int c = 0; c < 6; ++c) row[c] = scale * product[c];
  }
}

template <int Nodes>
void Resultants::refer_to_directors(const ShellPoint<Nodes>& point, bool with_stiffness) {
  double J[6][6];
  point.gradient.jacobian(J);
  double moment[2][3];
  for (int b = 0; b < 2; ++b) {
    for (int c = 0; c < 3; ++c) moment[b][c] = point.l * force[1][b][c];
  }
  for (int q = 0; q < 6; ++q) {
    double sum = 0.0;
    for (int r = 0; r < 6; ++r) sum += J[r][q] * moment[r / 3][r % 3];
    force[1][q / 3][q % 3] = sum;
  }
  if (!with_stiffness) return;
  for (int k = 1; k < 3; ++k) multiply(stiffness[k], point.l, J);
  double half[6][6];
  std::copy_n(&stiffness[2][0][0], 36, &half[0][0]);
  for (int q = 0; q < 6; ++q) {
    for (int c = 0; c < 6; ++c) {
      double sum = 0.0;
      for (int r = 0; r < 6; ++r) sum += J[r][q] * half[r][c];
      stiffness[2][q][c] = point.l * sum;
    }
  }
  point.gradient.add_second(moment, stiffness[2]);
}

template <int Nodes>
void Resultants::spread_force(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const {
  const auto& g = point.reference.g;
  for (int i = 0; i < Nodes; ++i) {
    for (int c = 0; c < 3; ++c) {
      system.force[i][c] += g[0][i] * force[0][0][c] + g[1][i] * force[0][1][c];
      system.force[i][3 + c] += g[0][i] * force[1][0][c] + g[1][i] * force[1][1][c];
    }
  }
}

template <int Nodes>
void Resultants::spread_stiffness(const ShellPoint<Nodes>& point, NodalSystem<Nodes>& system) const {
  const auto& g = point.reference.g;
  for (int i = 0; i < Nodes; ++i) {
    // Rows of node i: (a, a), (a, d), (d, d) and the transpose of (a, d).
    double half[4][3][6];
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 6; ++c) {
        for (int k = 0; k < 3; ++k) half[k][r][c] = g[0][i] * stiffness[k][r][c] + g[1][i] * stiffness[k][3 + r][c];
        half[3][r][c] = g[0][i] * stiffness[1][c][r] + g[1][i] * stiffness[1][c][3 + r];
      }
    }
    for (int j = i; j < Nodes; ++j) {
      auto& block = system.block(i, j);
      const double g0 = g[0][j], g1 = g[1][j];
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          block[r][c] += half[0][r][c] * g0 + half[0][r][3 + c] * g1;
          block[r][3 + c] += half[1][r][c] * g0 + half[1][r][3 + c] * g1;
          block[3 + r][c] += half[3][r][c] * g0 + half[3][r][3 + c] * g1;
          block[3 + r][3 + c] += half[2][r][c] * g0 + half[2][r][3 + c] * g1;
        }
      }
    }
  }
}

}  // namespace toile::element
