#pragma once

#include <functional>
#include <string>
#include <vector>

namespace toile::garment {

/// Relative arc lengths of nodes, increasing.
using Fractions = std::vector<double>;

/// An edge whose nodes are to be chosen.
struct SeededEdge {
  std::string name;     ///< "panel.edge", for messages
  double length = 0.0;  ///< mm
  double size = 1.0;    ///< wanted distance of nodes, mm
  Fractions kept;       ///< where a node must lie: 0, corners, ends of lines, 1
  Fractions dictated;   ///< all of its nodes, if its mesher leaves no choice; else empty
  /// Wanted distance of nodes (mm) at a relative arc length, where it is less than `size`; empty: nowhere.
  std::function<double(double)> finer = {};
};

/// Two parts of edges that get the same nodes.
struct SeededSeam {
  std::string name;
  struct Side {
    std::size_t edge = 0;  ///< index
    double from = 0.0, to = 1.0;
  } first, second;
  bool reversed = false;  ///< the start of the first meets the end of the second
};

/// [edge] Nodes of all edges. Parts that are sewn together have nodes at equal relative arc lengths of these parts,
/// through any number of seams; else nodes are evenly spread between those that are kept, closer where an edge is to be
/// finer. Each part between two kept nodes has an even number of sides, so that quadrilaterals fill a panel. Throws
/// InputError where what two meshers dictate cannot agree, where nodes would lie closer than a hundredth of what is
/// wanted, and where seams ask for more and more nodes.
std::vector<Fractions> plan_seeds(const std::vector<SeededEdge>& edges, const std::vector<SeededSeam>& seams);

}  // namespace toile::garment
