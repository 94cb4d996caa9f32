#pragma once

#include <optional>
#include <string>
#include <vector>

namespace toile::solve {

/// How linear systems are solved.
struct LinearOptions {
  std::string method = "cg";  ///< "cg", "gmres" (Belos) or "direct" (factorisation of every tangent)
  double tolerance = 1e-10;   ///< relative residual
  int kept_iterations = 12;   ///< a kept factorisation that needs more is renewed
  bool condition = false;     ///< the tangent's condition number is found where its pivots are counted
};

/// How a step is brought to equilibrium.
struct NewtonOptions {
  double tolerance = 1e-10;     ///< residual over the norm of the nodal forces that meet in it
  double gap_tolerance = 1e-6;  ///< largest gap of a node in contact, mm
  int max_iterations = 60;
  /// The undamped end of a stage is sought, where nothing is cut back: up to five times max_iterations as long as the
  /// residual halves in every third of them.
  bool to_rest = false;
};

/// Artificial damping of a stage.
struct DampingOptions {
  bool active = false;
  double fraction = 2e-4;  ///< dissipated energy of a step over the strain energy (largest so far)
  double limit = 0.05;     ///< accumulated dissipation over the largest strain energy that is still called quasi-static
};

class StageKind;

/// Where a path of arc length ends: a quantity has this value.
struct PathTarget {
  bool volume = false;  ///< what panels under pressure sweep, mm^3; then the rest but the value says nothing
  std::string on;       ///< a node by name, or a support
  int node = -1;        ///< of the mesh, whose displacement it is
  int support = -1;     ///< whose force on the garment it is, if not negative
  int direction = 2;    ///< x, y, z
  double value = 0.0;   ///< mm, N or mm^3
};

struct StageOptions {
  std::string name;
  const StageKind* kind = nullptr;  ///< what happens in it, see stage_kind.hpp
  double target = 1.0;              ///< load (or closing of the seams) at the end
  double first_step = 0.1;
  double smallest_step = 1e-4;
  double largest_step = 0.5;
  int max_steps = 200;
  double most_time = 0.0;             ///< s; 0: no limit
  int most_iterations = 5000;         ///< of Newton's method, failed attempts included
  bool arc_length = false;            ///< pseudo-arc-length instead of natural continuation
  std::optional<PathTarget> until;    ///< of arc length: where it ends instead of at its target
  bool stability_every_step = false;  ///< count negative pivots at every accepted step, not at the end only
  DampingOptions damping;
  std::vector<std::string> released;  ///< supports that end with the start of this stage
};

struct SolverOptions {
  LinearOptions linear;
  NewtonOptions newton;
  double most_time = 0.0;  ///< of the run, s; 0: no limit
};

}  // namespace toile::solve
