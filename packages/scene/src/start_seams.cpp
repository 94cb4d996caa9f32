#include "start_seams.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <set>

#include "start_shape.hpp"

namespace toile::scene {

namespace {

using Edge = std::vector<int>;  // nodes in the order of sewing
using solve::Vec3;

struct Edges {
  Edge first, second;
};

Edge turned(Edge edge) {
  std::reverse(edge.begin(), edge.end());
  return edge;
}

/// The edges of each seam, corners that they share included.
std::vector<Edges> edges_of(const garment::Garment& garment) {
  std::vector<Edges> all;
  for (const garment::Seam& seam : garment.seams) all.push_back({seam.first_nodes, seam.second_nodes});
  return all;
}

double mean_gap(const Edge& a, const Edge& b, const std::vector<Vec3>& placed) {
  double sum = 0.0;
  for (size_t k = 0; k < a.size(); ++k) sum += (placed[a[k]] - placed[b[k]]).norm();
  return sum / static_cast<double>(a.size());
}

/// Correlation of the nodes' places about the middle of each edge.
double likeness(const Edge& a, const Edge& b, const std::vector<Vec3>& placed) {
  const auto middle = [&](const Edge& edge) {
    Vec3 sum = Vec3::Zero();
    for (const int n : edge) sum += placed[n];
    return Vec3(sum / static_cast<double>(edge.size()));
  };
  const Vec3 middle_a = middle(a), middle_b = middle(b);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (size_t k = 0; k < a.size(); ++k) {
    const Vec3 from_a = placed[a[k]] - middle_a, from_b = placed[b[k]] - middle_b;
    ab += from_a.dot(from_b);
    aa += from_a.squaredNorm();
    bb += from_b.squaredNorm();
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

bool crosses_corner(const Edge& a, const Edge& b) {
  for (size_t k = 0; k < a.size(); ++k) {
    const auto same = std::find(b.begin(), b.end(), a[k]);
    if (same != b.end() && static_cast<size_t>(same - b.begin()) == b.size() - 1 - k && a[k] != b[k]) return true;
  }
  return false;
}

/// Whether the straight way between two nodes enters the body steeply at both ends and stays in it.
bool goes_through(const body::Surface& surface, const Vec3& a, const Vec3& b, double& depth) {
  constexpr double steep = 0.8;  // sine of the angle between the way and the surface: ends 106 degrees apart
  constexpr double deep = 0.2;   // of half the way
  const double half = 0.5 * (b - a).norm();
  if (half <= 0.0) return false;
  const Vec3 way = (b - a) / (2.0 * half);
  const double inside = -surface.closest(0.5 * (a + b)).gap;
  depth = std::max(depth, inside);
  if (inside < deep * half) return false;
  const body::SurfacePoint at_a = surface.closest(a), at_b = surface.closest(b);
  return at_a.found && at_b.found && -at_a.normal.dot(way) > steep && at_b.normal.dot(way) > steep;
}

void look_for_nearer_edge(const mesh::Mesh& mesh, const garment::Seam& seam, const Edges& edges, SeamStart& found) {
  constexpr double much = 0.3;  // of the gap as sewn
  found.nearest_gap = much * found.mean_gap;
  for (const auto& [name, nodes] : mesh.edges) {
    if (name == seam.first || name == seam.second || nodes.size() != edges.first.size()) continue;
    const double gap =
        std::min(mean_gap(edges.first, nodes, mesh.placed), mean_gap(edges.first, turned(nodes), mesh.placed));
    if (gap >= found.nearest_gap) continue;
    found.nearest_gap = gap;
    found.nearest_edge = name;
  }
}

/// Whether the boundary of a panel, counter-clockwise in its pattern, runs from node a to node b.
class Boundaries {
 public:
  explicit Boundaries(const mesh::Mesh& mesh) {
    for (const mesh::Block& block : mesh.blocks) {
      const size_t per = static_cast<size_t>(block.nodes_per_element);
      for (size_t i = 0; i < block.connectivity.size(); ++i)
        sides_.insert({block.connectivity[i], block.connectivity[i - i % per + (i + 1) % per]});
    }
  }
  bool run(const Edge& edge) const { return sides_.count({edge[0], edge[1]}) > 0; }

 private:
  std::set<std::pair<int, int>> sides_;
};

/// Panels that seams connect, each with the side that it shows relative to the first one.
class Sides {
 public:
  explicit Sides(size_t panels) : rank_(2 * panels, 0), parent_(2 * panels), sets_(rank_.data(), parent_.data()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  Sides(const Sides&) = delete;
  Sides& operator=(const Sides&) = delete;

  /// False: they are connected already, and the other way.
  bool join(int a, int b, bool flip) {
    if (sets_.find_set(side(a, false)) == sets_.find_set(side(b, !flip))) return false;
    for (const bool back : {false, true}) sets_.union_set(side(a, back), side(b, back != flip));
    return true;
  }

 private:
  /// Each panel stands for two: its right and its wrong side.
  static int side(int panel, bool back) { return 2 * panel + (back ? 1 : 0); }

  std::vector<int> rank_, parent_;
  boost::disjoint_sets<int*, int*> sets_;
};

/// Index of the panel that an edge belongs to.
int panel_index(const mesh::Mesh& mesh, int node) {
  const auto after = std::find_if(mesh.panels.begin(), mesh.panels.end(),
                                  [&](const mesh::MeshedPanel& panel) { return panel.first > node; });
  return static_cast<int>(after - mesh.panels.begin()) - 1;
}

}  // namespace

std::vector<SeamStart> look_at_seams(const Scene& scene) {
  const garment::Garment& garment = scene.garment();
  std::vector<SeamStart> all;
  if (garment.seams.empty()) return all;
  const std::vector<Edges> edges = edges_of(garment);
  const std::vector<Vec3>& placed = garment.mesh.placed;
  for (size_t s = 0; s < edges.size(); ++s) {
    const auto& [first, second] = edges[s];
    const Edge other = turned(second);
    SeamStart seam;
    seam.mean_gap = mean_gap(first, second, placed);
    seam.other_gap = mean_gap(first, other, placed);
    seam.likeness = likeness(first, second, placed);
    seam.other_likeness = likeness(first, other, placed);
    seam.crosses_corner = crosses_corner(first, second);
    int through = 0;
    for (size_t k = 0; k < first.size(); ++k) {
      const Vec3 &a = placed[first[k]], &b = placed[second[k]];
      seam.largest_gap = std::max(seam.largest_gap, (a - b).norm());
      if (scene.surface() != nullptr && goes_through(*scene.surface(), a, b, seam.depth)) ++through;
    }
    seam.through_body = 2 * static_cast<size_t>(through) > first.size();
    if (seam.through_body) look_for_nearer_edge(garment.mesh, garment.seams[s], edges[s], seam);
    all.push_back(seam);
  }
  return all;
}

std::vector<FacingEdges> unsewn_facing_edges(const Scene& scene) {
  constexpr double near = 0.2, alike = 0.9;  // of their length; see SeamStart::likeness
  const garment::Garment& garment = scene.garment();
  const mesh::Mesh& mesh = garment.mesh;
  std::vector<FacingEdges> found;
  if (scene.surface() == nullptr) return found;
  const auto is_free = [&](const std::string& edge) {
    return is_side(edge) && std::none_of(garment.seams.begin(), garment.seams.end(), [&](const garment::Seam& seam) {
             return seam.first == edge || seam.second == edge;
           });
  };
  for (auto first = mesh.edges.begin(); first != mesh.edges.end(); ++first) {
    if (!is_free(first->first)) continue;
    const double length = length_of_line(first->second, mesh.placed);
    for (auto second = std::next(first); second != mesh.edges.end(); ++second) {
      if (!is_free(second->first) || first->second.size() != second->second.size()) continue;
      const double gap = mean_gap(first->second, second->second, mesh.placed);
      if (gap > near * length || likeness(first->second, second->second, mesh.placed) < alike) continue;
      found.push_back({first->first, second->first, gap});
    }
  }
  return found;
}

// Two panels that show the same side run along their common seam in opposite senses.
int moebius_seam(const Scene& scene) {
  const garment::Garment& garment = scene.garment();
  if (garment.seams.empty()) return -1;
  const Boundaries boundaries(garment.mesh);
  Sides sides(garment.mesh.panels.size());
  const std::vector<Edges> edges = edges_of(garment);
  for (size_t s = 0; s < edges.size(); ++s) {
    const bool flip = boundaries.run(edges[s].first) == boundaries.run(edges[s].second);
    if (!sides.join(panel_index(garment.mesh, edges[s].first.front()),
                    panel_index(garment.mesh, edges[s].second.front()), flip))
      return static_cast<int>(s);
  }
  return -1;
}

}  // namespace toile::scene
