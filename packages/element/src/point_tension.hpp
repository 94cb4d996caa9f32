#pragma once

#include <cmath>
#include <cstddef>

#include "toile/element/element.hpp"
#include "vector.hpp"

namespace toile::element {

/// What one integration point knows of its tension, in the material frame.
template <int Nodes>
struct PointTension {
  double a[2][3];         ///< base of the mid-surface
  double stress[2][3];    ///< force per reference length on the sides that the axes are normal to, N/mm
  double g[2][Nodes];     ///< gradients of the shape functions along the axes, 1/mm
  double reference_area;  ///< mm^2
  double position[3];     ///< mm
};

inline void resize(std::size_t points, std::size_t nodes, PointTensions& out) {
  out.position.resize(3 * points);
  out.normal.resize(3 * points);
  out.area.resize(points);
  out.tension.resize(9 * points);
  out.force.resize(3 * nodes * points);
}

/// Writes point `at`: tension = sum over the sides of stress (x) base over the area stretch. Only its symmetric part
/// is kept: that of a shell is not symmetric by the moment that its curvature turns, which no curvature tensor sees.
template <int Nodes>
void write_tension(const PointTension<Nodes>& point, std::size_t at, PointTensions& out) {
  double normal[3];
  cross(point.a[0], point.a[1], normal);
  const double stretch = std::sqrt(dot(normal, normal));
  out.area[at] = stretch * point.reference_area;
  for (std::size_t i = 0; i < 3; ++i) {
    out.position[3 * at + i] = point.position[i];
    out.normal[3 * at + i] = normal[i] / stretch;
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (int b = 0; b < 2; ++b) sum += point.stress[b][i] * point.a[b][j] + point.stress[b][j] * point.a[b][i];
      out.tension[9 * at + 3 * i + j] = 0.5 * sum / stretch;
    }
    for (std::size_t k = 0; k < Nodes; ++k)
      out.force[3 * (Nodes * at + k) + i] =
          point.reference_area * (point.stress[0][i] * point.g[0][k] + point.stress[1][i] * point.g[1][k]);
  }
}

/// a <- map a, for both base vectors.
inline void apply(const double* map, double (&a)[2][3]) {
  for (auto& vector : a) {
    double turned[3];
    for (int i = 0; i < 3; ++i)
      turned[i] = map[3 * i] * vector[0] + map[3 * i + 1] * vector[1] + map[3 * i + 2] * vector[2];
    for (int i = 0; i < 3; ++i) vector[i] = turned[i];
  }
}

}  // namespace toile::element
