#pragma once

#include <Eigen/Sparse>

#include "toile/body/surface.hpp"

namespace toile::body {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Laplace's operator on a closed triangle mesh: weak form by cotangents, symmetric and positive semidefinite.
SparseMatrix stiffness_of(const TriangleMesh& mesh);

/// K M^-1 K with the lumped mass M: u^T B u is the integral of the squared Laplacian of u. 1/mm^2.
SparseMatrix bending_of(const TriangleMesh& mesh);

/// Vertices as rows.
Eigen::MatrixX3d rows_of(const std::vector<Vec3>& points);

/// The mesh whose vertices x minimise |x - x0|^2 + length^4 |Laplacian x|^2 over its surface: waves shorter than 2 pi
/// lengths are taken off.
TriangleMesh faired(const TriangleMesh& mesh, double length);

}  // namespace toile::body
