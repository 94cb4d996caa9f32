#include "diagnosis/law_floor.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fields/block_arrays.hpp"
#include "toile/material/law.hpp"

namespace toile::solve {

namespace {

/// The smallest stretch so far, through the thickness or in the plane.
struct Smallest {
  double stretch = 0.0;
  bool thickness = false;
  size_t block = 0, element = 0;
};

void look_at(const element::PointFields& fields, size_t block, size_t points, Smallest& smallest) {
  for (size_t k = 0; k < fields.thickness_stretch.size(); ++k) {
    const double* C = &fields.C[3 * k];
    const double mean = 0.5 * (C[0] + C[1]), radius = std::hypot(0.5 * (C[0] - C[1]), C[2]);
    const double in_plane = std::sqrt(std::max(0.0, mean - radius)), through = fields.thickness_stretch[k];
    const double least = std::isfinite(through) ? std::min(in_plane, through) : in_plane;
    if (least < smallest.stretch) smallest = {least, through <= in_plane, block, k / points};
  }
}

}  // namespace

std::string law_floor_text(const Problem& problem, const State& state) {
  constexpr double near = 1.05;  // steps become ever shorter towards the floor
  const std::vector<Vec3> position = node_positions(problem, state);
  Smallest smallest{near * material::stretch_floor};
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) {
    const BlockArrays arrays(problem, b, state, position);
    const element::Element& element = *problem.models[b].element;
    look_at(element.fields(arrays.batch()), b, static_cast<size_t>(element.points()), smallest);
  }
  if (smallest.stretch >= near * material::stretch_floor) return {};
  const mesh::Block& block = problem.mesh->blocks[smallest.block];
  const int node = block.connectivity[smallest.element * static_cast<size_t>(block.nodes_per_element)];
  const Vec3& at = position[node];
  std::ostringstream out;
  out.precision(3);
  out << "the fabric's floor was reached in panel \"" << block.name << "\", element " << smallest.element + 1
      << ", at (" << at[0] << ", " << at[1] << ", " << at[2] << ") mm: its stretch "
      << (smallest.thickness ? "through the thickness" : "in the plane") << " is " << smallest.stretch
      << ", and no energy is evaluated below " << material::stretch_floor;
  return out.str();
}

}  // namespace toile::solve
