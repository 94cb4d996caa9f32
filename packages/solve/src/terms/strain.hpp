#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "equilibrium/stencils.hpp"
#include "terms/term.hpp"

namespace toile::solve {

/// The strain of all panels: sums the elements of one rank.
class Strain : public Term {
 public:
  Strain(const Problem& problem, const Layout& layout, const Graph& graph);

  void add(const Configuration& at, Forces& forces, double* tangent) override;
  double potential(const Configuration& at, const Configuration& held) override;

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
  /// Integrals of grad N_I . grad N_J over the reference of the local elements of a part of the layout:
  /// [element][node][node].
  std::vector<double> gradient_products(size_t part) const;
  /// Reference area (mm^2) that belongs to each local node; complete for nodes of owned clusters.
  std::vector<double> reference_areas() const;
  /// Thickness (mm) averaged over the current area around each local node; complete for nodes of owned clusters.
  std::vector<double> nodal_thickness(const Configuration& at);

 private:
  /// What an element starts from, see element::Batch.
  struct Reference {
    std::vector<double> pattern, wale_angle, params;
    std::vector<double> directors;  ///< of shells whose reference is the placed shape
  };
  /// The configuration that is asked for.
  struct Present {
    std::vector<double> x, frames;
  };
  /// What elements keep during a step.
  struct Frozen {
    std::vector<double> now, next;
    size_t first = 0;  ///< place of the block's values among those of the garment
  };
  /// Of the last evaluation, see element::Result.
  struct Results {
    std::vector<double> energy, residual, tangent;
    std::vector<std::uint8_t> status;
  };
  /// The elements of one block on this rank.
  struct Part {
    Part(const BlockModel& model, const Layout::BlockPart& local, int nodes_per_element, Stencils places)
        : element(model.element),
          material(model.material),
          layout(&local),
          shell(model.shell),
          nodes(nodes_per_element),
          stencils(std::move(places)) {}

    const element::Element* element;
    const material::Material* material;
    const Layout::BlockPart* layout;
    ShellModel shell;
    int nodes;  ///< an element
    Stencils stencils;
    Reference reference;
    Present present;
    Frozen frozen;
    Results results;
  };

  Part make_part(const Problem& problem, const Layout::BlockPart& local, const std::vector<Frame>& start,
                 const Graph& graph);
  void gather(Part& part, const Configuration& at) const;
  void run(Part& part, bool with_tangent) const;
  void add_up(const Part& part, Forces& forces) const;
  element::Batch batch(const Part& part, int first, int count) const;

  const Layout& layout_;
  std::vector<Part> parts_;
  size_t all_frozen_ = 0;  ///< values of the whole garment
};

}  // namespace toile::solve
