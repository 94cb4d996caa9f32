#include "imperfection.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace toile::garment {
namespace {

/// Offset of each node over the amplitude, -1..1, zero on the edges.
using Offsets = std::vector<double>;

Offsets random_offsets(const mesh::PanelMesh& flat, int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const std::vector<bool> stays = mesh::on_edges(flat);
  Offsets offsets(flat.nodes.size(), 0.0);
  for (std::size_t n = 0; n < offsets.size(); ++n)
    // The 53 leading bits: the distributions of the standard library differ between platforms.
    if (!stays[n]) offsets[n] = std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0;
  return offsets;
}

/// Relative arc length along the nodes of a line, 0..1.
std::vector<double> fractions(const mesh::PanelMesh& flat, const std::vector<int>& line) {
  std::vector<double> arc{0.0};
  for (std::size_t k = 1; k < line.size(); ++k) {
    arc.push_back(arc.back() + (flat.nodes[line[k]] - flat.nodes[line[k - 1]]).norm());
  }
  for (double& s : arc) s /= arc.back();
  return arc;
}

/// Of a mesh in rows: by the relative arc length along its rows and columns.
Offsets waves_in_rows(const mesh::PanelMesh& flat, int across, int along) {
  Offsets offsets(flat.nodes.size(), 0.0);
  const int last = flat.rows() - 1;
  for (int j = 1; j < last; ++j) {
    std::vector<int> row;
    for (int i = 0; i <= flat.across; ++i) row.push_back(flat.node(i, j));
    const std::vector<double> u = fractions(flat, row);
    for (int i = 1; i < flat.across; ++i) offsets[flat.node(i, j)] = std::sin(across * M_PI * u[i]);
  }
  for (int i = 1; i < flat.across; ++i) {
    std::vector<int> column;
    for (int j = 0; j <= last; ++j) column.push_back(flat.node(i, j));
    const std::vector<double> v = fractions(flat, column);
    for (int j = 1; j < last; ++j) offsets[flat.node(i, j)] *= std::sin(along * M_PI * v[j]);
  }
  return offsets;
}

/// Of a free mesh: by the place in the rectangle round the pattern.
Offsets waves_in_box(const mesh::PanelMesh& flat, int across, int along) {
  Eigen::AlignedBox2d box;
  for (const mesh::Vec2& node : flat.nodes) box.extend(node);
  const std::vector<bool> stays = mesh::on_edges(flat);
  Offsets offsets(flat.nodes.size(), 0.0);
  for (std::size_t n = 0; n < offsets.size(); ++n) {
    const mesh::Vec2 at = (flat.nodes[n] - box.min()).cwiseQuotient(box.sizes());
    if (!stays[n]) offsets[n] = std::sin(across * M_PI * at.x()) * std::sin(along * M_PI * at.y());
  }
  return offsets;
}

Offsets read_waves(const base::List& list, const mesh::PanelMesh& flat) {
  const base::Reals& count = list.reals("half-waves");
  if (count.size() != 2 || count[0] != std::floor(count[0]) || count[1] != std::floor(count[1])) {
    list.fail("half-waves", "needs two whole numbers, from left to right and from bottom to top");
  }
  const int across = static_cast<int>(count[0]), along = static_cast<int>(count[1]);
  if (flat.across == 0) return waves_in_box(flat, across, along);
  if (2 * across > flat.across || 2 * along > flat.rows() - 1) {
    list.fail("half-waves", "the mesh cannot show so many: a half-wave needs at least two elements");
  }
  return waves_in_rows(flat, across, along);
}

}  // namespace

base::Spec imperfection_spec() {
  const base::Spec random =
      base::Spec("random", "An offset of its own for each node, evenly spread.")
          .integer("seed", "Another seed makes another imperfection of the same size.", 1, base::Range::at_least(0));
  const base::Spec waves =
      base::Spec(
          "waves",
          "A product of two sines of the relative arc length in the pattern; of the place in the rectangle round "
          "the pattern in a free mesh.")
          .reals("half-waves", "", "Two whole numbers: half-waves from left to right and from bottom to top.",
                 base::required, base::Range::at_least(1.0));
  return base::Spec(
             "Imperfection",
             "Small offset of the placed panel along its normal, from which wrinkles can grow. Nodes on the edges "
             "stay where they are.")
      .real("amplitude", "mm", "Largest offset.", base::required, base::Range::positive())
      .variant("type", "Shape of the offset.", {random, waves}, std::string("random"));
}

void add_imperfection(const base::List& panel, const mesh::PanelMesh& flat, mesh::Placed& placed) {
  if (!panel.has_list("Imperfection")) return;
  const base::List list = panel.list("Imperfection");
  const std::vector<bool> stays = mesh::on_edges(flat);
  if (std::find(stays.begin(), stays.end(), false) == stays.end()) {
    list.fail("amplitude", "the panel has no inner nodes to move; it needs two elements or more either way");
  }
  const bool is_random = list.word("type") == "random";
  const Offsets offsets = is_random ? random_offsets(flat, list.integer("seed")) : read_waves(list, flat);
  for (std::size_t node = 0; node < offsets.size(); ++node) {
    placed.position[node] += list.real("amplitude") * offsets[node] * placed.normal[node];
  }
}

}  // namespace toile::garment
