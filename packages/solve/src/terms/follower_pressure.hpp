#pragma once

namespace toile::solve {

/// Pressure p on an element of `nodes` (3 or 4) nodes at x [nodes][3], along x_,1 x x_,2.
///
/// force [nodes][3] is the integral of p N_I n over the current area. `volume` is a third of the integral of x . n, of
/// which the force is p times the gradient wherever the boundary is held or closed (Bufler 1984): there -p volume is a
/// potential; for other edges see pressure_edges.hpp. `stiffness` [3 nodes][3 nodes], or null, is the second derivative
/// of -p volume, symmetric.
struct PressureOnElement {
  double volume = 0.0;
  double force[12] = {};
};

PressureOnElement pressure_on_element(int nodes, const double* x, double pressure, double* stiffness);

}  // namespace toile::solve
