#include "verification/mixed_problem.hpp"

#include <random>
#include <stdexcept>

namespace toile::test {
namespace {

/// An empty block of `nodes` nodes an element, else like another.
mesh::Block empty_block(const mesh::Block& like, int nodes) {
  mesh::Block block = like;
  if (nodes == 3) block.name += "-triangles";
  block.nodes_per_element = nodes;
  block.connectivity.clear();
  block.wale_angle.clear();
  block.position.clear();
  return block;
}

/// Adds elements on these nodes in the place of one element of another block.
void add(const std::vector<int>& nodes, const mesh::Block& from, size_t element, mesh::Block& to) {
  to.connectivity.insert(to.connectivity.end(), nodes.begin(), nodes.end());
  to.wale_angle.resize(static_cast<size_t>(to.size()), from.wale_angle[element]);
  to.position.resize(static_cast<size_t>(to.size()), from.position[element]);
}

}  // namespace

MixedProblem::MixedProblem(const solve::Problem& whole) : problem(whole), mesh_(*whole.mesh) {
  if (mesh_.blocks.size() != 1 || !whole.pressures.empty()) throw std::logic_error("one block without pressure is cut");
  const mesh::Block all = mesh_.blocks[0];
  mesh_.blocks = {empty_block(all, 4), empty_block(all, 3)};
  std::mt19937 random(11);
  for (size_t e = 0; e < static_cast<size_t>(all.size()); ++e) {
    const int *n = &all.connectivity[4 * e], a = n[0], b = n[1], c = n[2], d = n[3];
    const auto length = [this](int i, int j) { return (mesh_.pattern[i] - mesh_.pattern[j]).norm(); };
    if (random() % 2 == 0)
      add({a, b, c, d}, all, e, mesh_.blocks[0]);
    else if (length(a, c) < length(b, d))
      add({a, b, c, a, c, d}, all, e, mesh_.blocks[1]);
    else
      add({a, b, d, b, c, d}, all, e, mesh_.blocks[1]);
  }
  problem.mesh = &mesh_;
  problem.models = {whole.models[0], whole.models[0]};
  problem.models[1].element = element::find(whole.models[0].is_shell() ? "shell3" : "membrane3");
  problem.element_rank.clear();
  for (const mesh::Block& block : mesh_.blocks) problem.element_rank.emplace_back(static_cast<size_t>(block.size()), 0);
}

solve::SolveStatistics MixedProblem::run(const scene::Scene& scene, const solve::Simulation::Observer& observer) const {
  solve::Simulation simulation(problem, scene.solver());
  simulation.observe(observer);
  simulation.set_start(scene.start());
  for (const solve::StageOptions& stage : scene.stages()) simulation.run(stage);
  return simulation.statistics();
}

int MixedProblem::triangles() const {
  return mesh_.blocks[1].size();
}

}  // namespace toile::test
