#pragma once

#include <cstdint>
#include <vector>

#include "layout.hpp"

namespace toile::solve {

/// Nodal unknowns of the elements of one rank.
struct Configuration {
  std::vector<double> x;         ///< [local node][3] mm
  std::vector<double> rotation;  ///< [local node][2] of shells, since the start of the step; empty without shells
};

/// Sums the elements of one rank into forces and the tangent of the unknowns.
class ElementAssembly {
 public:
  ElementAssembly(const Problem& problem, const Layout& layout, const Graph& graph);

  struct Sums {
    double energy = 0.0;            ///< N mm, of the elements owned by this rank
    std::vector<double> force;      ///< [local cluster][3] gradient of the strain energy, N; complete where owned
    std::vector<double> magnitude;  ///< [local cluster][3] sum of the magnitudes that met there, N
    /// The same of the rotations: [local node][2], N mm; empty without shells.
    std::vector<double> moment, moment_magnitude;
    double pressure_potential = 0.0;     ///< N mm, of follower pressures; owned elements
    std::vector<double> pressure_force;  ///< [local cluster][3] N; empty without pressures
    int extrapolated = 0;                ///< owned elements outside the calibrated range of their fabric
  };

  /// Follower pressures count `load` times. Adds to `values` (entries of the graph, may be null).
  Sums evaluate(const Configuration& at, double load, double* values);

  /// Whether a follower pressure ends at an edge, on any rank: its potential is then one about a configuration.
  bool has_pressure_edges() const { return has_pressure_edges_; }
  void hold_pressure_edges(const Configuration& at);

  /// The directors' frames [local node] from which rotations count from now on.
  void set_frames(const std::vector<Frame>& frames);
  /// What the elements would keep frozen during a step (Element::freeze) from this state on; adopt_frozen() makes them
  /// do so. Returns the largest change of a thickness, mm, of this rank.
  double find_frozen(const Configuration& at);
  void adopt_frozen();
  /// What they keep frozen now, of all elements of the garment, zero where another rank owns them: [block][element].
  std::vector<double> frozen() const;
  /// Sets it, given all of it.
  void set_frozen(const std::vector<double>& all);

  /// Part of the energy that only stabilises reduced elements, N mm, of the elements owned by this rank.
  double stabilisation_energy(const Configuration& at);
  /// Reference area (mm^2) that belongs to each local node; complete for nodes of owned clusters.
  std::vector<double> reference_areas() const;
  /// Thickness (mm) averaged over the current area around each local node; complete for nodes of owned clusters.
  std::vector<double> nodal_thickness(const Configuration& at);

 private:
  struct Part {
    const element::Element* element;
    const material::Material* material;
    const Layout::BlockPart* layout;
    ShellSection shell;
    double pressure;  ///< MPa at load 1
    int nodes;        ///< an element
    std::vector<double> pattern, wale_angle, params, x;
    std::vector<double> frames, reference, frozen, next_frozen;  ///< of shells, see element::Batch
    std::vector<double> energy, residual, tangent;
    std::vector<std::uint8_t> status;
    std::vector<std::uint8_t> pressure_edges;  ///< [element] see find_pressure_edges; empty without a pressure
    std::vector<double> edge_x;                ///< positions [element][node][3] about which their potential is
    std::vector<std::int64_t> entry;           ///< [element][ndof][ndof] place in the matrix, or -1
    std::vector<size_t> turned;                ///< elements with a node whose components are not x, y and z
    size_t first_frozen;                       ///< place of the block's values among those of the garment
  };

  void find_entries(Part& part, const Graph& graph) const;
  void gather(Part& part, const Configuration& at) const;
  void run(Part& part, bool with_tangent) const;
  void add_pressure(Part& part, double load, bool with_tangent, Sums& sums) const;
  void turn_tangents(Part& part) const;
  /// The edges of an element at which the pressure ends: returns their part of the potential over the pressure, and
  /// adds to the element's stiffness unless it is null.
  double add_pressure_edges(const Part& part, size_t element, double pressure, double* stiffness) const;
  void add_up(const Part& part, Sums& sums) const;
  element::Batch batch(const Part& part, int first, int count) const;

  const Layout& layout_;
  std::vector<Part> parts_;
  size_t all_frozen_ = 0;  ///< values of the whole garment
  bool has_pressure_ = false, has_pressure_edges_ = false;
};

}  // namespace toile::solve
