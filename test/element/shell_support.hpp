#pragma once

#include <Eigen/Geometry>

#include "support.hpp"

namespace toile::element::testing {

/// Writes the frozen values of the present state.
void freeze(Arrays& shells);

/// Carries the frames to the present directors (parallel transport) and sets the rotations to zero, as between steps.
void carry_frames(Arrays& shells);

/// `n` distorted shells of about 10 mm, stretched by about 1.3 and 1.2 and bent, in a random pose, in random frames,
/// with rotations of about 0.3; the reference is flat, or a saddle with directors near its normals. Frozen as they are.
Arrays random_shells(const Element& element, const Law& law, int n, unsigned seed, bool curved);

/// The same elements at rest: their reference, placed by a rotation and a shift, in other frames, without rotations.
Arrays at_rest(const Arrays& shells, const Eigen::Matrix3d& Q, const Eigen::Vector3d& shift);

/// Shells in random plane pattern positions on a mesh, flat and at rest in the plane z = 0, frames along the axes.
Arrays flat_shells(const PlaneMesh& mesh, const Element& element, const Law& law, double wale_angle);

/// Displacements (5 a node) of flat shells: w = (k11 X^2 + k22 Y^2)/2 + k12 X Y with the directors normal to it.
Eigen::VectorXd constant_curvature(const PlaneMesh& mesh, double k11, double k22, double k12);

/// Displacements (5 a node) of flat shells: constant transverse shear, with a tilt of the plane that costs nothing.
Eigen::VectorXd constant_shear(const PlaneMesh& mesh, const Eigen::Vector2d& gamma);

/// Sum of the element vectors (5 a node).
Eigen::VectorXd scatter_shells(const PlaneMesh& mesh, const Eigen::VectorXd& element_vectors);

}  // namespace toile::element::testing
