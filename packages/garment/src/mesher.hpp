#pragma once

#include <map>
#include <string>
#include <vector>

#include "cut.hpp"
#include "seeds.hpp"
#include "toile/base/parameters.hpp"
#include "toile/mesh/panel_mesh.hpp"

namespace toile::garment {

/// Of a panel: more would take the memory of a large machine before the first step.
constexpr int most_elements = 1000000;

/// One way of meshing a panel.
struct Mesher {
  base::Spec spec;  ///< its parameters, in the panel's list
  /// The panel's edges with the nodes that the mesher wants; their names are those of the edges alone.
  std::vector<SeededEdge> (*edges)(const base::List& panel, const Cut& cut);
  /// The mesh, with nodes on the edges where `seeds` (by edge) has them. Throws InputError through `panel.fail`.
  mesh::PanelMesh (*mesh)(const base::List& panel, const Cut& cut, const std::map<std::string, Fractions>& seeds);
};

/// All meshers; a new one is a source of its own and a line here.
const std::vector<Mesher>& meshers();

Mesher structured_mesher();  ///< rows of elements between four sides
Mesher free_mesher();        ///< any outline, by Gmsh

/// The mesher that a panel names.
const Mesher& mesher_of(const base::List& panel);

}  // namespace toile::garment
