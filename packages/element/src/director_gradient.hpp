#pragma once

#include <algorithm>

#include "reference_point.hpp"
#include "vector.hpp"

namespace toile::element {

/// Directions of the parent element along which a director runs from node to node, as long as the element, and the dual
/// vectors: sum_k dual_kr along_kq is the identity. Quadrilaterals: the two coordinate lines. Triangles: the three
/// edges in a closed walk, with the duals that treat them alike.
template <int Nodes>
struct Fibres;
template <>
struct Fibres<4> {
  static constexpr int n = 2;
  static constexpr double along[n][2] = {{2.0, 0.0}, {0.0, 2.0}};
  static constexpr double dual[n][2] = {{0.5, 0.0}, {0.0, 0.5}};
};
template <>
struct Fibres<3> {
  static constexpr int n = 3;
  static constexpr double third = 1.0 / 3.0;
  static constexpr double along[n][2] = {{1.0, 0.0}, {-1.0, 1.0}, {0.0, -1.0}};
  static constexpr double dual[n][2] = {{2.0 * third, third}, {-third, third}, {-third, -2.0 * third}};
};

/// Arc over chord of the unit circle, (angle/2)/sin(angle/2) = asin(u)/u, as a function of s = u^2 with u half the
/// chord: a Taylor polynomial, 3e-5 off at 60 degrees and 1e-3 at 90 degrees, smooth at any angle.
struct ArcOverChord {
  double value, first, second;
  explicit ArcOverChord(double s) {
    constexpr double c1 = 1.0 / 6.0, c2 = 3.0 / 40.0, c3 = 5.0 / 112.0, c4 = 35.0 / 1152.0;
    value = 1.0 + s * (c1 + s * (c2 + s * (c3 + s * c4)));
    first = c1 + s * (2.0 * c2 + s * (3.0 * c3 + s * 4.0 * c4));
    second = 2.0 * c2 + s * (6.0 * c3 + s * 12.0 * c4);
  }
};

/// Derivatives of the director at one in-plane point, with directors that turn along great circles.
///
/// Interpolated straight, a director that turns by the angle D from one side of the element to the other changes by the
/// chord 2 sin(D/2). Here its change along each fibre, e_k = u_k . grad d, is scaled by arc over chord, and the
/// derivatives along the material axes are sum_k w_ka (arc/chord)(e_k) e_k: the curvature of a strip that is bent to a
/// circle is exact for any number of elements. The frame-indifferent e_k are the only argument, so that the energy
/// stays objective, and the derivatives are exact.
template <int Nodes>
class DirectorGradient {
 public:
  void set_reference(const ReferencePoint<Nodes>& point);
  /// `straight`: derivatives of the interpolated directors along the material axes. Keeps the changes for what follows.
  void turn(const double (&straight)[2][3], double (&turned)[2][3]);
  /// d turned_a / d straight_b as rows 3 a + r, columns 3 b + c.
  void jacobian(double (&J)[6][6]) const;
  /// K += the second derivative of sum_a moment_a . turned_a by `straight`.
  void add_second(const double (&moment)[2][3], double (&K)[6][6]) const;

 private:
  static constexpr int fibres = Fibres<Nodes>::n;
  double along_[fibres][2];  ///< u_k, mm
  double dual_[fibres][2];   ///< w_k, 1/mm
  double change_[fibres][3];
};

template <int Nodes>
void DirectorGradient<Nodes>::set_reference(const ReferencePoint<Nodes>& point) {
  const auto& T = point.to_material;
  const double inverse = 1.0 / (T[0][0] * T[1][1] - T[0][1] * T[1][0]);
  const double tangent[2][2] = {{inverse * T[1][1], -inverse * T[1][0]}, {-inverse * T[0][1], inverse * T[0][0]}};
  for (int k = 0; k < fibres; ++k) {
    const auto& along = Fibres<Nodes>::along[k];
    const auto& dual = Fibres<Nodes>::dual[k];
    for (int a = 0; a < 2; ++a) {
      along_[k][a] = along[0] * tangent[0][a] + along[1] * tangent[1][a];
      dual_[k][a] = dual[0] * T[0][a] + dual[1] * T[1][a];
    }
  }
}

template <int Nodes>
void DirectorGradient<Nodes>::turn(const double (&straight)[2][3], double (&turned)[2][3]) {
  std::fill_n(&turned[0][0], 6, 0.0);
  for (int k = 0; k < fibres; ++k) {
    auto& change = change_[k];
    combine(along_[k], straight, change);
    const double ratio = ArcOverChord(0.25 * dot(change, change)).value;
    for (int a = 0; a < 2; ++a) {
      for (int c = 0; c < 3; ++c) turned[a][c] += dual_[k][a] * ratio * change[c];
    }
  }
}

template <int Nodes>
void DirectorGradient<Nodes>::jacobian(double (&J)[6][6]) const {
  std::fill_n(&J[0][0], 36, 0.0);
  for (int k = 0; k < fibres; ++k) {
    const auto& change = change_[k];
    const ArcOverChord ratio(0.25 * dot(change, change));
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        const double slope = (r == c ? ratio.value : 0.0) + 0.5 * ratio.first * change[r] * change[c];
        for (int a = 0; a < 2; ++a) {
          for (int b = 0; b < 2; ++b) J[3 * a + r][3 * b + c] += dual_[k][a] * along_[k][b] * slope;
        }
      }
    }
  }
}

template <int Nodes>
void DirectorGradient<Nodes>::add_second(const double (&moment)[2][3], double (&K)[6][6]) const {
  for (int k = 0; k < fibres; ++k) {
    const auto& change = change_[k];
    const ArcOverChord ratio(0.25 * dot(change, change));
    double m[3];
    combine(dual_[k], moment, m);
    const double work = dot(m, change);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        const double slope = 0.5 * ratio.first * ((r == c ? work : 0.0) + m[r] * change[c] + change[r] * m[c]) +
                             0.25 * ratio.second * work * change[r] * change[c];
        for (int a = 0; a < 2; ++a) {
          for (int b = 0; b < 2; ++b) K[3 * a + r][3 * b + c] += along_[k][a] * along_[k][b] * slope;
        }
      }
    }
  }
}

}  // namespace toile::element
