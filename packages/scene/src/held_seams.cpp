#include "held_seams.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "start_shape.hpp"
#include "start_text.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::scene {

namespace {

/// A node that a support holds and a seam moves: the furthest one of this support.
struct MovedNode {
  size_t support = 0;
  int node = -1, master = -1;
  std::string direction;  ///< a letter, or words
  double way = 0.0;       ///< mm
  double side = 0.0;      ///< mm, mean side of the elements of its panel
};

/// Supports that have ended when the seams start to close; without a stage that sews they are closed from the start.
std::set<std::string> released_before_sewing(const std::vector<solve::StageOptions>& stages) {
  std::set<std::string> released;
  const auto sews = [](const solve::StageOptions& stage) { return stage.kind->closes_seams(); };
  const auto sewing = std::find_if(stages.begin(), stages.end(), sews);
  const auto last = sewing == stages.end() ? stages.begin() + 1 : sewing + 1;
  for (auto stage = stages.begin(); stage != last; ++stage)
    released.insert(stage->released.begin(), stage->released.end());
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

/// [node] mean side of the elements of its panel, mm.
std::vector<double> sides(const mesh::Mesh& mesh) {
  std::vector<double> side(static_cast<size_t>(mesh.nodes()), 0.0);
  for (const mesh::Block& block : mesh.blocks) {
    const double mean = mean_side(block, mesh.placed);
    for (const int node : block.connectivity) side[node] = mean;
  }
  return side;
}

std::vector<MovedNode> moved_nodes(const Scene& scene) {
  const garment::Garment& garment = scene.garment();
  const solve::Problem& problem = scene.problem();
  constexpr double counts = 0.01;  // of the side of an element
  std::vector<MovedNode> all;
  if (garment.seams.empty() || problem.supports.empty()) return all;
  const std::set<std::string> released = released_before_sewing(scene.stages());
  const std::vector<double> side = sides(garment.mesh);
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const solve::Support& support = problem.supports[s];
    if (released.count(support.name) > 0) continue;
    MovedNode worst;
    for (size_t k = 0; k < support.nodes.size(); ++k)
      for (Eigen::Index d = 0; d < 3; ++d) {
        const int node = support.nodes[k], master = garment.clusters.master(node);
        const double way = std::abs(support.axis(k, d).dot(garment.mesh.placed[master] - garment.mesh.placed[node]));
        if (!support.held[static_cast<size_t>(d)] || way <= std::max(worst.way, counts * side[node])) continue;
        const std::string direction = support.axes.empty() ? std::string(1, "xyz"[d]) : "its direction";
        worst = {s, node, master, direction, way, side[node]};
      }
    if (worst.node >= 0) all.push_back(worst);
  }
  return all;
}

bool is_too_far(const MovedNode& moved) {
  return moved.way > 0.5 * moved.side;
}

std::string text(const Scene& scene, const MovedNode& moved) {
  const garment::Garment& garment = scene.garment();
  const std::string& axis = moved.direction;
  const bool has_body = scene.surface() != nullptr;
  return "contradicts the seam \"" + seam_of(garment, moved.node).name + "\": the support \"" +
         scene.problem().supports[moved.support].name + "\" holds the node at " +
         place_text(garment.mesh.placed[moved.node]) + " in " + axis + ", and the seam moves it by " +
         short_number(moved.way) + " mm in " + axis + ", to the one at " +
         place_text(garment.mesh.placed[moved.master]) + ". A sewn node cannot stay in two places: do not hold " +
         axis + " there" + (has_body ? " (an end that must not slide is held by \"hold\" = \"along the limb\")" : "") +
         ", hold nodes beside the seam, or place the panels so that the sewn nodes meet in " + axis;
}

}  // namespace

std::vector<std::string> held_seam_errors(const Scene& scene, const base::List& list) {
  std::vector<std::string> errors;
  for (const MovedNode& moved : moved_nodes(scene))
    if (is_too_far(moved))
      errors.push_back(message_of(list.list("Supports").entries()[moved.support], "hold", text(scene, moved)));
  return errors;
}

std::vector<std::string> held_seam_warnings(const Scene& scene) {
  std::vector<std::string> warnings;
  for (const MovedNode& moved : moved_nodes(scene))
    if (!is_too_far(moved))
      warnings.push_back("support \"" + scene.problem().supports[moved.support].name + "\" " + text(scene, moved) +
                         ". Beside it the fabric is strained by about " + short_number(100.0 * moved.way / moved.side) +
                         " %");
  return warnings;
}

}  // namespace toile::scene
