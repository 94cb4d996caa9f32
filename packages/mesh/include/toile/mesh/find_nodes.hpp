#pragma once

#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

/// Nodes that a name of the input stands for, or what is wrong with the name.
struct FoundNodes {
  std::vector<int> nodes;
  std::string problem;  ///< complete sentence with what is valid; empty: the nodes were found
  double off = 0.0;     ///< mm in the pattern: how far a place, or the end of a part of an edge, is from the node taken
};

/// Nodes of
/// - a panel, "front" (ascending), or an edge of it, "front.left" (in its order);
/// - a part of an edge, "front.left[0.25:end]", "front.armhole[notch1:notch2]" or "front.left[30mm:90mm]" (in its
/// order);
/// - a corner, "front.bottom-left", "front.bottom-right", "front.top-right" or "front.top-left": one node;
/// - a place on an edge, "front.left@0.5": the one node nearest to this relative arc length in the pattern;
/// - a place in a panel, "front@0.5,0.25": the one node in the column of elements that starts nearest to the first
///   number along "front.bottom" and in the row that starts nearest to the second along "front.left".
/// - a point of a panel's pattern, "front@(12.5,40)": the one node nearest to it (mm), not further away than the
/// longest
///   side of an element.
/// Numbers may be separated by blanks as well. Of two nodes that are equally near the first one is taken.
FoundNodes find_nodes(const Mesh& mesh, const std::string& name);

/// Nodes along an edge, each with the length of it that belongs to it in the pattern, mm: the integral of its shape
/// function along the edge.
struct EdgeLengths {
  std::vector<int> nodes;
  std::vector<double> lengths;
};

/// Of the edge, or the part of an edge, that find_nodes finds under this name; a part may end between nodes.
EdgeLengths edge_lengths(const Mesh& mesh, const std::string& name);

/// A point between two neighbouring nodes of an edge, (1 - share) first + share second.
struct EdgePlace {
  int first = 0, second = 0;
  double share = 0.0;
};

/// At a relative arc length in the pattern along an edge of at least two nodes.
EdgePlace edge_place(const Mesh& mesh, const std::vector<int>& edge, double fraction);

}  // namespace toile::mesh
