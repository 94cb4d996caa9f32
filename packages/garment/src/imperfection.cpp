#include "imperfection.hpp"

#include <cmath>
#include <random>

namespace toile::garment {
namespace {

/// Offset of each node over the amplitude, -1..1, zero on the edges.
using Offsets = std::vector<double>;

Offsets random_offsets(const mesh::Grid& grid, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  Offsets offsets(grid.nodes.size(), 0.0);
  for (int j = 1; j < grid.along; ++j) {
    for (int i = 1; i < grid.across; ++i) {
      // The 53 leading bits: the distributions of the standard library differ between platforms.
      offsets[grid.node(i, j)] = std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0;
    }
  }
  return offsets;
}

/// Relative arc length along a line of nodes, 0..1.
std::vector<double> fractions(const mesh::Grid& grid, const std::vector<int>& line) {
  std::vector<double> arc{0.0};
  for (std::size_t k = 1; k < line.size(); ++k) {
    arc.push_back(arc.back() + (grid.nodes[line[k]] - grid.nodes[line[k - 1]]).norm());
  }
  for (double& s : arc) s /= arc.back();
  return arc;
}

Offsets wave_offsets(const mesh::Grid& grid, int across, int along) {
  Offsets offsets(grid.nodes.size(), 0.0);
  for (int j = 1; j < grid.along; ++j) {
    const std::vector<double> u = fractions(grid, grid.row(j));
    for (int i = 1; i < grid.across; ++i) offsets[grid.node(i, j)] = std::sin(across * M_PI * u[i]);
  }
  for (int i = 1; i < grid.across; ++i) {
    const std::vector<double> v = fractions(grid, grid.column(i));
    for (int j = 1; j < grid.along; ++j) offsets[grid.node(i, j)] *= std::sin(along * M_PI * v[j]);
  }
  return offsets;
}

Offsets read_waves(const base::List& list, const mesh::Grid& grid) {
  const base::Reals& count = list.reals("half-waves");
  if (count.size() != 2 || count[0] != std::floor(count[0]) || count[1] != std::floor(count[1])) {
    list.fail("half-waves", "needs two whole numbers, from left to right and from bottom to top");
  }
  if (2.0 * count[0] > grid.across || 2.0 * count[1] > grid.along) {
    list.fail("half-waves", "the mesh cannot show so many: a half-wave needs at least two elements");
  }
  return wave_offsets(grid, static_cast<int>(count[0]), static_cast<int>(count[1]));
}

}  // namespace

base::Spec imperfection_spec() {
  const base::Spec random =
      base::Spec("random", "An offset of its own for each node, evenly spread.")
          .integer("seed", "Another seed makes another imperfection of the same size.", 1, base::Range::at_least(0));
  const base::Spec waves =
      base::Spec("waves", "A product of two sines of the relative arc length in the pattern.")
          .reals("half-waves", "", "Two whole numbers: half-waves from left to right and from bottom to top.",
                 base::required, base::Range::at_least(1.0));
  return base::Spec(
             "Imperfection",
             "Small offset of the placed panel along its normal, from which wrinkles can grow. Nodes on the edges "
             "stay where they are.")
      .real("amplitude", "mm", "Largest offset.", base::required, base::Range::positive())
      .variant("type", "Shape of the offset.", {random, waves}, std::string("random"));
}

void add_imperfection(const base::List& panel, const mesh::Grid& grid, mesh::Placed& placed) {
  if (!panel.has_list("Imperfection")) return;
  const base::List list = panel.list("Imperfection");
  if (grid.across < 2 || grid.along < 2) {
    list.fail("amplitude", "the panel has no inner nodes to move; it needs two elements or more either way");
  }
  const bool is_random = list.word("type") == "random";
  const Offsets offsets = is_random ? random_offsets(grid, list.integer("seed")) : read_waves(list, grid);
  for (std::size_t node = 0; node < offsets.size(); ++node) {
    placed.position[node] += list.real("amplitude") * offsets[node] * placed.normal[node];
  }
}

}  // namespace toile::garment
