#pragma once

#include <vector>

#include "crossings.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Connected pieces that lie inside another piece.
struct Nested {
  int cavities = 0;          ///< their facets looked to the other side than those of the piece round them
  int solids = 0;            ///< to the same side
  std::vector<char> inside;  ///< marks them, by number_pieces
};

/// Finds every connected piece that lies inside another one and does not cross it. A tube with open ends counts as if
/// its ends were closed.
Nested find_nested(const TriangleMesh& mesh, const std::vector<Crossing>& crossings);

/// Removes the pieces that lie inside another one: no garment can touch them.
void drop(const Nested& nested, TriangleMesh* mesh);

/// Volume of each connected piece, mm^3, negative if its facets look inwards, by Pieces::of. Seen from its own centre,
/// a tube with open ends has one as well.
std::vector<double> signed_volumes(const TriangleMesh& mesh, const std::vector<int>& piece, int pieces);

/// Number of the connected piece of each triangle, from 0; sets how many there are.
std::vector<int> number_pieces(const TriangleMesh& mesh, int* count);

}  // namespace toile::body
