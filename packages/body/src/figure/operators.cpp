#include "figure/operators.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "mesh_geometry.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

SparseMatrix mass_of(const TriangleMesh& mesh, double power) {
  const std::vector<double> areas = vertex_areas(mesh);
  SparseMatrix mass(areas.size(), areas.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    entries.emplace_back(i, i, std::pow(areas[i], power));
  }
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

}  // namespace

SparseMatrix stiffness_of(const TriangleMesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& t : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const int a = t[(corner + 1) % 3], b = t[(corner + 2) % 3];
      const Vec3 u = mesh.vertices[a] - mesh.vertices[t[corner]], v = mesh.vertices[b] - mesh.vertices[t[corner]];
      const double weight = 0.5 * u.dot(v) / u.cross(v).norm();
      entries.emplace_back(a, b, -weight);
      entries.emplace_back(b, a, -weight);
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
    }
  }
  SparseMatrix stiffness(mesh.vertices.size(), mesh.vertices.size());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

SparseMatrix bending_of(const TriangleMesh& mesh) {
  const SparseMatrix stiffness = stiffness_of(mesh);
  return stiffness * mass_of(mesh, -1.0) * stiffness;
}

Eigen::MatrixX3d rows_of(const std::vector<Vec3>& points) {
  Eigen::MatrixX3d rows(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    rows.row(i) = points[i].transpose();
  }
  return rows;
}

TriangleMesh faired(const TriangleMesh& mesh, double length) {
  const SparseMatrix mass = mass_of(mesh, 1.0);
  const SparseMatrix system = mass + std::pow(length, 4) * bending_of(mesh);
  const Eigen::SimplicialLDLT<SparseMatrix> solver(system);
  const Eigen::MatrixX3d moved = solver.solve(mass * rows_of(mesh.vertices));
  if (solver.info() != Eigen::Success || !moved.allFinite()) {
    throw base::InputError("the body's surface cannot be made smooth: it has facets without area");
  }
  TriangleMesh result = mesh;
  for (std::size_t i = 0; i < result.vertices.size(); ++i) {
    result.vertices[i] = moved.row(i).transpose();
  }
  return result;
}

}  // namespace toile::body
