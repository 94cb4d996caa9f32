#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "toile/body/surface.hpp"

namespace toile::body {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = CgalKernel::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

inline CgalPoint cgal_point(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
inline Vec3 to_vec(const CgalPoint& p) {
  return {p.x(), p.y(), p.z()};
}

/// The mesh as CGAL has it, vertices and facets with the same numbers. Throws InputError if it is no surface.
CgalMesh cgal_mesh(const TriangleMesh& mesh);
/// Its vertices and facets in their order, without those that were removed.
TriangleMesh triangles_of(const CgalMesh& mesh);

}  // namespace toile::body
