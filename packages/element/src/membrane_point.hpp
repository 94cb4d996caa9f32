#pragma once

#include <algorithm>
#include <cmath>

namespace toile::element {

/// Shape functions of a parent element at the points of its quadrature rule.
template <int Nodes, int Points>
struct Rule {
  double N[Points][Nodes];      ///< values
  double dN[Points][Nodes][2];  ///< derivatives with respect to the parent coordinates
  double weight[Points];        ///< sum: area of the parent element
};

/// Kinematics of a membrane at one integration point.
///
/// With the gradients g_i of the shape functions in the material frame (wale, course), the columns of F R are
/// a_1 = sum_i g_i1 x_i and a_2 = sum_i g_i2 x_i, so C11 = a_1.a_1, C22 = a_2.a_2, C12 = a_1.a_2. In terms of
/// E = (C11/2, C22/2, C12): dE_1 = a_1.da_1, dE_2 = a_2.da_2, dE_3 = a_2.da_1 + a_1.da_2. See Bonet and Wood, Nonlinear
/// Continuum Mechanics for Finite Element Analysis (2008), chapter 9.
template <int Nodes>
struct MembranePoint {
  static constexpr int dofs = 3 * Nodes;

  double g[Nodes][2];  ///< gradients of the shape functions, 1/mm
  double a[2][3];      ///< columns of F in the axes of g
  double area;         ///< reference area of the point, detJ w, mm^2; not positive: the pattern is folded there

  /// Sets g (in the pattern's axes) and area from the pattern X [Nodes][2], the parent derivatives and the weight.
  void set_reference(const double* X, const double (&dN)[Nodes][2], double weight);
  /// Turns g into axes that lie at the angle with this cosine and sine from its present ones.
  void rotate(double cosine, double sine);
  /// Sets a from the positions x [Nodes][3].
  void deform(const double* x);
  /// Current over reference area, |a_1 x a_2|.
  double area_stretch() const;
  /// r += the gradient with respect to x of a density with first derivative S (already times thickness and area).
  void add_residual(const double (&S)[3], double (&r)[dofs]) const;
  /// K += the Hessian with second derivative D (order as in LawV1): blocks (i, j) with j >= i only.
  void add_tangent(const double (&S)[3], const double (&D)[6], double (&K)[dofs][dofs]) const;
};

/// Hessian of a density W(C) with respect to (a_1, a_2): B^T D B with the rows (a_1, 0), (0, a_2), (a_2, a_1) of B, and
/// the geometric part S_ab times the identity.
inline void plane_hessian(const double (&a)[2][3], const double (&S)[3], const double (&D)[6], double (&A)[6][6]) {
  const auto& [u, v] = a;
  for (int c = 0; c < 3; ++c) {
    for (int d = 0; d < 3; ++d) {
      const double uu = u[c] * u[d], vv = v[c] * v[d], uv = u[c] * v[d], vu = v[c] * u[d];
      A[c][d] = D[0] * uu + D[4] * (uv + vu) + D[2] * vv;
      A[c][3 + d] = D[3] * uv + D[4] * uu + D[5] * vv + D[2] * vu;
      A[3 + d][c] = A[c][3 + d];
      A[3 + c][3 + d] = D[1] * vv + D[5] * (uv + vu) + D[2] * uu;
    }
  }
  for (int c = 0; c < 3; ++c) {
    A[c][c] += S[0];
    A[c][3 + c] += S[2];
    A[3 + c][c] += S[2];
    A[3 + c][3 + c] += S[1];
  }
}

template <int Nodes>
void MembranePoint<Nodes>::set_reference(const double* X, const double (&dN)[Nodes][2], double weight) {
  double J[2][2] = {};
  for (int i = 0; i < Nodes; ++i) {
    for (int r = 0; r < 2; ++r) {
      J[r][0] += dN[i][r] * X[2 * i];
      J[r][1] += dN[i][r] * X[2 * i + 1];
    }
  }
  const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
  const double inverse = 1.0 / det;
  for (int i = 0; i < Nodes; ++i) {
    g[i][0] = (J[1][1] * dN[i][0] - J[0][1] * dN[i][1]) * inverse;
    g[i][1] = (J[0][0] * dN[i][1] - J[1][0] * dN[i][0]) * inverse;
  }
  area = det * weight;
}

template <int Nodes>
void MembranePoint<Nodes>::rotate(double cosine, double sine) {
  for (auto& gradient : g) {
    const double x = gradient[0], y = gradient[1];
    gradient[0] = cosine * x + sine * y;
    gradient[1] = cosine * y - sine * x;
  }
}

template <int Nodes>
void MembranePoint<Nodes>::deform(const double* x) {
  for (int axis = 0; axis < 2; ++axis) {
    double sum[3] = {};
    for (int i = 0; i < Nodes; ++i) {
      for (int c = 0; c < 3; ++c) sum[c] += g[i][axis] * x[3 * i + c];
    }
    std::copy_n(sum, 3, a[axis]);
  }
}

template <int Nodes>
double MembranePoint<Nodes>::area_stretch() const {
  const auto& [u, v] = a;
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

template <int Nodes>
void MembranePoint<Nodes>::add_residual(const double (&S)[3], double (&r)[dofs]) const {
  for (int c = 0; c < 3; ++c) {
    const double P1 = S[0] * a[0][c] + S[2] * a[1][c];
    const double P2 = S[2] * a[0][c] + S[1] * a[1][c];
    for (int i = 0; i < Nodes; ++i) r[3 * i + c] += g[i][0] * P1 + g[i][1] * P2;
  }
}

template <int Nodes>
void MembranePoint<Nodes>::add_tangent(const double (&S)[3], const double (&D)[6], double (&K)[dofs][dofs]) const {
  double A[6][6];
  plane_hessian(a, S, D, A);
  for (int i = 0; i < Nodes; ++i) {
    double T[3][6];
    for (int c = 0; c < 3; ++c) {
      for (int d = 0; d < 6; ++d) T[c][d] = g[i][0] * A[c][d] + g[i][1] * A[3 + c][d];
    }
    for (int j = i; j < Nodes; ++j) {
      for (int c = 0; c < 3; ++c) {
        for (int d = 0; d < 3; ++d) K[3 * i + c][3 * j + d] += T[c][d] * g[j][0] + T[c][3 + d] * g[j][1];
      }
    }
  }
}

}  // namespace toile::element
