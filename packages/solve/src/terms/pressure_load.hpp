#pragma once

#include <cstdint>
#include <vector>

#include "equilibrium/stencils.hpp"
#include "terms/term.hpp"

namespace toile::solve {

/// The pressures that follow their panels, see follower_pressure.hpp and, for its edges, pressure_edges.hpp. Their
/// potential ends at an edge that is free: it is one about the held configuration there.
class PressureLoad : public Term {
 public:
  PressureLoad(const Problem& problem, const Layout& layout, const Graph& graph);

  void add(const Configuration& at, Forces& forces, double* tangent) override;
  double potential(const Configuration& at, const Configuration& held) override;

 private:
  struct Part {
    const Layout::BlockPart* layout;
    int nodes;                        ///< an element
    double pressure;                  ///< MPa at load 1
    std::vector<std::uint8_t> edges;  ///< [element] see find_pressure_edges
    Stencils stencils;
    std::vector<double> stiffness = {};  ///< [element][3 nodes][3 nodes] of the last tangent
  };

  void add_edges(const Part& part, size_t element, double pressure, const double* x, double* stiffness) const;

  const Layout& layout_;
  std::vector<Part> parts_;
};

}  // namespace toile::solve
