#pragma once

#include <array>

namespace toile::identify {

/// Stress and tangent of one point in the axes of its test, x along the pull.
struct TestAxes {
  double Sxx, Syy, Sxy;
  double Dxy, Dxg, Dyy, Dyg, Dgg;  ///< g: the shear strain 2 E_xy
};

/// The matrix T of E_fabric = T E_test, by its columns; E = (E11, E22, 2 E12). The wale stands at the angle a from x:
/// cc = cos^2 a, ss = sin^2 a, cs = cos a sin a.
struct Turn {
  double cc, ss, cs;
  std::array<double, 3> x() const { return {cc, ss, -2.0 * cs}; }
  std::array<double, 3> y() const { return {ss, cc, 2.0 * cs}; }
  std::array<double, 3> g() const { return {cs, -cs, cc - ss}; }
};

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// D [6] in the order of LawV1, times a strain.
inline std::array<double, 3> times(const std::array<double, 6>& D, const std::array<double, 3>& E) {
  return {D[0] * E[0] + D[3] * E[1] + D[4] * E[2], D[3] * E[0] + D[1] * E[1] + D[5] * E[2],
          D[4] * E[0] + D[5] * E[1] + D[2] * E[2]};
}

/// S_test = T^T S, D_test = T^T D T.
inline TestAxes to_test_axes(const Turn& turn, const std::array<double, 3>& S, const std::array<double, 6>& D) {
  const auto x = turn.x(), y = turn.y(), g = turn.g();
  const auto Dy = times(D, y), Dg = times(D, g);
  return {dot(x, S), dot(y, S), dot(g, S), dot(x, Dy), dot(x, Dg), dot(y, Dy), dot(y, Dg), dot(g, Dg)};
}

/// S_x (or its derivative) with the free strains condensed: x - D_xu D_uu^-1 (y, g).
inline double condensed_stress(const TestAxes& a, double x, double y, double g) {
  const double det = a.Dyy * a.Dgg - a.Dyg * a.Dyg;
  const double by_y = (a.Dxy * a.Dgg - a.Dxg * a.Dyg) / det, by_g = (a.Dxg * a.Dyy - a.Dxy * a.Dyg) / det;
  return x - by_y * y - by_g * g;
}

}  // namespace toile::identify
