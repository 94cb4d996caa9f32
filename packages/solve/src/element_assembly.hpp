#pragma once

#include <cstdint>
#include <vector>

#include "layout.hpp"

namespace toile::solve {

/// Sums the elements of one rank into cluster forces and the tangent of the unknowns.
class ElementAssembly {
 public:
  ElementAssembly(const Problem& problem, const Layout& layout, const Graph& graph);

  struct Sums {
    double energy = 0.0;            ///< N mm, of the elements owned by this rank
    std::vector<double> force;      ///< [local cluster][3] gradient of the strain energy, N; complete where owned
    std::vector<double> magnitude;  ///< [local cluster][3] sum of the magnitudes that met there, N
    int extrapolated = 0;           ///< owned elements outside the calibrated range of their fabric
  };

  /// `x`: [local node][3] mm. Adds to `values` (entries of the graph, may be null).
  Sums evaluate(const std::vector<double>& x, double* values);

  /// Reference area (mm^2) that belongs to each local node; complete for nodes of owned clusters.
  std::vector<double> reference_areas() const;
  /// Thickness (mm) averaged over the current area around each local node; complete for nodes of owned clusters.
  std::vector<double> nodal_thickness(const std::vector<double>& x);

 private:
  struct Part {
    const element::Element* element;
    const material::Material* material;
    const Layout::BlockPart* layout;
    int nodes;  ///< an element
    std::vector<double> pattern, wale_angle, params, x;
    std::vector<double> energy, residual, tangent;
    std::vector<std::uint8_t> status;
    std::vector<std::int64_t> entry;  ///< [element][ndof][ndof] place in the matrix, or -1
  };

  void find_entries(Part& part, const Graph& graph) const;
  void gather(Part& part, const std::vector<double>& x) const;
  void run(Part& part, bool with_tangent) const;
  element::Batch batch(const Part& part, int first, int count) const;

  const Layout& layout_;
  std::vector<Part> parts_;
};

}  // namespace toile::solve
