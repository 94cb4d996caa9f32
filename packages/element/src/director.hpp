#pragma once

namespace toile::element {

/// Director of a node, d = Exp(d_n, w_1 t_1 + w_2 t_2), with its exact derivatives by w at any w.
struct Director {
  double d[3];
  double first[2][3];   ///< dd/dw_1, dd/dw_2
  double second[3][3];  ///< d2d/dw2 in the order 11, 22, 12
};

/// `frame` [9]: orthonormal t_1, t_2, d_n; `w` [2] radians.
Director director(const double* frame, const double* w);

}  // namespace toile::element
