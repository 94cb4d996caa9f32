#include "toile/criteria/map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.hpp"
#include "toile/material/ellipticity.hpp"

namespace toile::criteria {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Unit vectors along the principal stretches; the axes where C12 = 0.
std::array<std::array<double, 2>, 2> principal_directions(const Strain& C) {
  const double angle = C[2] == 0.0 ? 0.0 : 0.5 * std::atan2(2.0 * C[2], C[0] - C[1]);
  return {{{std::cos(angle), std::sin(angle)}, {-std::sin(angle), std::cos(angle)}}};
}

struct Eigenvalues {
  double smaller, larger;
};

/// d2W/dl_i dl_j of the principal stretches l at fixed principal directions n: dC = 2 l dl n (x) n, so
/// H_ij = l_i l_j (n_i n_i):D:(n_j n_j) + delta_ij S:(n_i n_i).
Eigenvalues stretch_hessian(const Outputs& s) {
  const auto n = principal_directions(s.C);
  std::array<std::array<double, 3>, 2> e;
  std::array<double, 2> stretch, stress;
  for (int i = 0; i < 2; ++i) {
    e[i] = {n[i][0] * n[i][0], n[i][1] * n[i][1], 2.0 * n[i][0] * n[i][1]};
    stretch[i] = std::sqrt(e[i][0] * s.C[0] + e[i][1] * s.C[1] + e[i][2] * s.C[2]);
    stress[i] = e[i][0] * s.S[0] + e[i][1] * s.S[1] + e[i][2] * s.S[2];
  }
  const auto curvature = [&](int i, int j) {
    double sum = 0.0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) sum += e[i][a] * s.tangent(a, b) * e[j][b];
    return sum * stretch[i] * stretch[j];
  };
  const double H11 = curvature(0, 0) + stress[0], H22 = curvature(1, 1) + stress[1], H12 = curvature(0, 1);
  const double mean = 0.5 * (H11 + H22), spread = std::hypot(0.5 * (H11 - H22), H12);
  return {mean - spread, mean + spread};
}

/// Eigenvalues of a symmetric 3 x 3 matrix by Jacobi rotations.
std::array<double, 3> eigenvalues(std::array<std::array<double, 3>, 3> A) {
  for (int sweep = 0; sweep < 30; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (A[p][q] == 0.0) continue;
        const double angle = 0.5 * std::atan2(2.0 * A[p][q], A[q][q] - A[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (int k = 0; k < 3; ++k) {
          const double left = A[k][p], right = A[k][q];
          A[k][p] = c * left - s * right;
          A[k][q] = s * left + c * right;
        }
        for (int k = 0; k < 3; ++k) {
          const double left = A[p][k], right = A[q][k];
          A[p][k] = c * left - s * right;
          A[q][k] = s * left + c * right;
        }
        A[p][q] = A[q][p] = 0.0;
      }
  return {A[0][0], A[1][1], A[2][2]};
}

/// In the orthonormal components (E11, E22, sqrt(2) E12), E3 = C12 = 2 E12.
std::array<double, 3> tangent_eigenvalues(const Outputs& s) {
  const double root = std::sqrt(2.0);
  const std::array<double, 3> scale = {1.0, 1.0, root};
  std::array<std::array<double, 3>, 3> A;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) A[a][b] = s.tangent(a, b) * scale[a] * scale[b];
  return eigenvalues(A);
}

}  // namespace

MapPoint map_point(double wale, double course, double shear, const Outputs& s) {
  MapPoint point = {wale, course, shear, s};
  if (!s.admissible()) {
    point.ellipticity = point.direction = point.convexity = point.condition = not_a_number;
    return point;
  }
  const material::Ellipticity acoustic = material::ellipticity(s.C, s.S, s.D);
  const Eigenvalues hessian = stretch_hessian(s);
  const auto D = tangent_eigenvalues(s);
  const auto magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double smallest = *std::min_element(D.begin(), D.end(), magnitude);
  const double largest = *std::max_element(D.begin(), D.end(), magnitude);
  point.tensile = s.tensile(rounding * std::abs(largest));
  point.ellipticity = acoustic.smallest;
  point.direction = std::atan2(acoustic.direction[1], acoustic.direction[0]) * 180.0 / pi;
  point.elliptic = acoustic.smallest >= -rounding * acoustic.largest;
  point.convexity = hessian.smaller;
  point.convex = hessian.smaller >= -rounding * std::abs(hessian.larger);
  point.condition = std::abs(largest / smallest);
  point.tangent_positive = *std::min_element(D.begin(), D.end()) > 0.0;
  return point;
}

std::vector<MapPoint> map(const Fabric& fabric, const Request& request) {
  std::vector<Strain> strains;
  std::vector<MapPoint> points;
  for (double shear : positions(request.shear, request.shear_points))
    for (double course : positions(request.course, request.points))
      for (double wale : positions(request.wale, request.points)) {
        strains.push_back(strain_of(wale, course, shear));
        points.push_back({wale, course, shear, {}});
      }
  const std::vector<Outputs> states = fabric.evaluate(strains);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = map_point(points[i].wale, points[i].course, points[i].shear, states[i]);
  return points;
}

}  // namespace toile::criteria
