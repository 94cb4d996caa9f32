#pragma once

#include <vector>

#include "equilibrium/stencils.hpp"
#include "terms/strain.hpp"

namespace toile::solve {

/// Keeps slack fabric, which carries nothing, where the step found it: the potential
///   eps/2 h0 D0 int |grad(x - x_0)|^2 dA
/// over the pattern, x_0 the positions at the start of the step, D0 the mean of the fabric's natural stiffness along
/// wale and course, eps its residual stiffness; of shells h0^2 over the block's area times as much. It is quadratic and
/// convex, so that it adds no folds of its own as compressed fabric would (doc/theory.md, "Residual stiffness").
class ResidualStiffness : public Term {
 public:
  /// Whether any fabric has some.
  static bool is_in(const Problem& problem);

  /// `start`: of the first step.
  ResidualStiffness(const Problem& problem, const Layout& layout, const Graph& graph, const Strain& strain,
                    const Configuration& start);

  void add(const Configuration& at, Forces& forces, double* tangent) override;
  double potential(const Configuration& at, const Configuration& held) override;
  void start_step(const Configuration& at) override { start_ = at.x; }
  void set_active(bool active) { active_ = active; }

 private:
  /// The elements of one block on this rank.
  struct Part {
    const Layout::BlockPart* layout;
    size_t nodes;  ///< an element
    Stencils stencils;
    std::vector<double> stiffness;  ///< [element][node][node] N/mm, the same along x, y and z
    std::vector<double> tangent;    ///< [element][3 nodes][3 nodes] N/mm, while it is added
  };
  double moved(int node, size_t component, const Configuration& at) const;
  void add_forces(const Part& part, size_t element, const Configuration& at, Forces& forces) const;

  const Layout& layout_;
  std::vector<double> start_;  ///< [local node][3] mm
  bool active_ = true;
  std::vector<Part> parts_;
};

}  // namespace toile::solve
