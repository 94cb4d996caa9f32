#include "terms/follower_pressure.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace toile::solve {

namespace {

using Vec3 = Eigen::Vector3d;

struct Point {
  std::array<double, 4> N, d1, d2;
  double weight;
};

/// 2 x 2 points of the bilinear quadrilateral: exact, the integrand is of second order in each coordinate.
std::array<Point, 4> quadrilateral() {
  constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double gauss = 1.0 / std::sqrt(3.0);
  std::array<Point, 4> points{};
  for (int p = 0; p < 4; ++p)
    for (int i = 0; i < 4; ++i) {
      const double u = 1.0 + corner[i][0] * corner[p][0] * gauss, v = 1.0 + corner[i][1] * corner[p][1] * gauss;
      points[p].N[i] = 0.25 * u * v;
      points[p].d1[i] = 0.25 * corner[i][0] * v;
      points[p].d2[i] = 0.25 * corner[i][1] * u;
      points[p].weight = 1.0;
    }
  return points;
}

/// Centre of the linear triangle.
constexpr Point triangle = {{1.0 / 3, 1.0 / 3, 1.0 / 3, 0}, {-1, 1, 0, 0}, {-1, 0, 1, 0}, 0.5};

Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

void add_point(int nodes, const double* x, double pressure, const Point& point, PressureOnElement& out,
               double* stiffness) {
  Vec3 at = Vec3::Zero(), a1 = Vec3::Zero(), a2 = Vec3::Zero();
  for (int i = 0; i < nodes; ++i) {
    const Eigen::Map<const Vec3> xi(x + 3 * i);
    at += point.N[i] * xi;
    a1 += point.d1[i] * xi;
    a2 += point.d2[i] * xi;
  }
  const Vec3 normal = point.weight * a1.cross(a2);
  out.volume += at.dot(normal) / 3.0;
  for (int i = 0; i < nodes; ++i)
    for (int c = 0; c < 3; ++c) out.force[3 * i + c] += pressure * point.N[i] * normal[c];
  if (stiffness == nullptr) return;
  // Second derivative of x . (a_1 x a_2) / 3, a sum of triple products of (x, a_1, a_2).
  const double factor = -pressure * point.weight / 3.0;
  const Eigen::Matrix3d X = cross_matrix(at), A1 = cross_matrix(a1), A2 = cross_matrix(a2);
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> K(stiffness, 3 * nodes, 3 * nodes);
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < nodes; ++j) {
      const double xa1 = point.N[i] * point.d1[j] - point.d1[i] * point.N[j];
      const double xa2 = point.N[i] * point.d2[j] - point.d2[i] * point.N[j];
      const double a12 = point.d1[i] * point.d2[j] - point.d2[i] * point.d1[j];
      K.block<3, 3>(3 * i, 3 * j) += factor * (xa2 * A1 - xa1 * A2 - a12 * X);
    }
}

}  // namespace

PressureOnElement pressure_on_element(int nodes, const double* x, double pressure, double* stiffness) {
  static const std::array<Point, 4> four = quadrilateral();
  PressureOnElement out;
  if (nodes == 4) {
    for (const Point& point : four) add_point(nodes, x, pressure, point, out, stiffness);
  } else {
    add_point(nodes, x, pressure, triangle, out, stiffness);
  }
  return out;
}

}  // namespace toile::solve
