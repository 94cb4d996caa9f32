#include "held_seams.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "start_shape.hpp"

namespace toile::scene {

namespace {

/// Supports that have ended when the seams start to close; without a stage that sews they are closed from the start.
std::set<std::string> released_before_sewing(const base::List& stages) {
  std::set<std::string> released;
  const std::vector<base::List> entries = stages.entries();
  const auto sews = [](const base::List& stage) { return stage.word("type") == "sew"; };
  const auto sewing = std::find_if(entries.begin(), entries.end(), sews);
  const auto last = sewing == entries.end() ? entries.begin() + 1 : sewing + 1;
  for (auto stage = entries.begin(); stage != last; ++stage) {
    const base::Texts& names = stage->words("release");
    released.insert(names.begin(), names.end());
  }
  return released;
}

/// A seam that ties a node to the rest of its cluster.
const garment::Seam& seam_of(const garment::Garment& garment, int node) {
  const auto ties = [node](const garment::Seam& seam) {
    return std::any_of(seam.pairs.begin(), seam.pairs.end(),
                       [node](const auto& pair) { return pair.first == node || pair.second == node; });
  };
  return *std::find_if(garment.seams.begin(), garment.seams.end(), ties);
}

/// mm: a hundredth of the mean side of an element, so that what a seam may move a held node strains the fabric beside
/// it by less than a hundredth.
double allowed_way(const mesh::Mesh& mesh) {
  double sum = 0.0, count = 0.0;
  for (const mesh::Block& block : mesh.blocks) {
    const size_t per = static_cast<size_t>(block.nodes_per_element);
    for (size_t i = 0; i < block.connectivity.size(); ++i) {
      const int next = block.connectivity[i - i % per + (i + 1) % per];
      sum += (mesh.placed[block.connectivity[i]] - mesh.placed[next]).norm();
      count += 1.0;
    }
  }
  return 0.01 * sum / count;
}

std::string problem_text(const garment::Garment& garment, const solve::Support& support, int node, int master,
                         size_t direction) {
  const solve::Vec3 &here = garment.mesh.placed[node], &there = garment.mesh.placed[master];
  const Eigen::Index d = static_cast<Eigen::Index>(direction);
  const std::string axis(1, "xyz"[direction]);
  return "contradicts the seam \"" + seam_of(garment, node).name + "\": the support \"" + support.name +
         "\" holds the node at " + place_text(here) + " in " + axis + ", and the seam moves it by " +
         short_number(std::abs(there[d] - here[d])) + " mm in " + axis + ", to the one at " + place_text(there) +
         ". A sewn node cannot stay in two places: do not hold " + axis +
         " there, hold nodes beside the seam, or place the panels so that the sewn nodes meet in " + axis;
}

}  // namespace

void check_held_seams(const base::List& scene, const garment::Garment& garment, const solve::Problem& problem) {
  if (garment.seams.empty() || problem.supports.empty()) return;
  const std::set<std::string> released = released_before_sewing(scene.list("Stages"));
  const double allowed = allowed_way(garment.mesh);
  const std::vector<base::List> entries = scene.list("Supports").entries();
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const solve::Support& support = problem.supports[s];
    if (released.count(support.name) > 0) continue;
    int worst = -1;
    size_t direction = 0;
    double largest = allowed;
    for (const int node : support.nodes)
      for (size_t d = 0; d < 3; ++d) {
        const solve::Vec3 way = garment.mesh.placed[garment.clusters.master(node)] - garment.mesh.placed[node];
        const double moved = std::abs(way[static_cast<Eigen::Index>(d)]);
        if (!support.held[d] || moved <= largest) continue;
        largest = moved;
        worst = node;
        direction = d;
      }
    if (worst >= 0)
      entries[s].fail("hold", problem_text(garment, support, worst, garment.clusters.master(worst), direction));
  }
}

}  // namespace toile::scene
