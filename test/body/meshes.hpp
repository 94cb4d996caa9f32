#pragma once

#include <functional>
#include <string>

#include "toile/body/surface.hpp"

namespace toile::test {

/// Tube about z for meshing: chart(u, z) is the surface point at u (period 1, about proportional to arc length).
struct TubeShape {
  std::function<body::Vec3(double u, double z)> chart;
  double perimeter;  ///< mm
  double height;     ///< mm, z from 0
};

TubeShape elliptic_tube(double a, double b, double height);

/// The lobed body of the project's reconstruction study: r = 60 + 3 cos(2 theta + z/60) + 1.2 cos(5 theta - z/50), mm.
TubeShape lobed_tube(double height);
/// Its larger principal curvature at (theta, z), 1/mm, and the point there.
double lobed_curvature(double theta, double z, body::Vec3* point);

/// Unstructured triangles: randomly moved points (vertices exactly on the surface), Delaunay in the unrolled plane,
/// open ends.
body::TriangleMesh random_triangulation(const TubeShape& shape, double edge, unsigned seed);

/// Writes an OBJ file, coordinates times `scale`, and returns its path in the folder for temporary files.
std::string write_obj(const std::string& name, const body::TriangleMesh& mesh, double scale = 1.0);

}  // namespace toile::test
