#pragma once

#include <array>
#include <string>
#include <vector>

#include "toile/body/body.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Two connected pieces (numbers by number_pieces, the first is the smaller one) whose facets intersect or touch.
struct Crossing {
  int first = 0;
  int second = 0;
  int pairs = 0;              ///< of facets
  Vec3 place = Vec3::Zero();  ///< near one of them, mm
};

/// The pieces that cross each other, sorted by their numbers. `pairs`: triangles of `mesh` that intersect, also within
/// one piece. Pieces that have no more than corners in common cross if one of them lies in the box of the other.
std::vector<Crossing> find_crossings(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& pairs);

/// Throws InputError if two pieces cross that both have facets in reach; `inside` marks pieces that do not count.
void check_apart(const std::string& file, const TriangleMesh& mesh, const std::vector<Crossing>& crossings,
                 const std::vector<char>& inside, const Region& reach);

}  // namespace toile::body
