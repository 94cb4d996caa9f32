#include "fields/block_arrays.hpp"

namespace toile::solve {

std::vector<Vec3> node_positions(const Problem& problem, const State& state) {
  std::vector<Vec3> position(static_cast<size_t>(problem.mesh->nodes()));
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int n : problem.clusters[c]) position[n] = node_position(problem, state, static_cast<int>(c), n);
  return position;
}

BlockArrays::BlockArrays(const Problem& problem, size_t b, const State& state, const std::vector<Vec3>& position) {
  const mesh::Block& block = problem.mesh->blocks[b];
  const BlockModel& model = problem.models[b];
  for (const int n : block.connectivity) {
    pattern_.insert(pattern_.end(), {problem.mesh->pattern[n][0], problem.mesh->pattern[n][1]});
    x_.insert(x_.end(), position[n].data(), position[n].data() + 3);
    if (model.is_shell()) x_.insert(x_.end(), {0.0, 0.0});
  }
  params_ = model.material->graduated() ? std::vector<double>() : model.material->params();
  for (int e = 0; e < block.size() && model.material->graduated(); ++e) {
    const std::vector<double> values = model.material->params_at(block.position[e]);
    params_.insert(params_.end(), values.begin(), values.end());
  }
  batch_.n = block.size();
  batch_.pattern = pattern_.data();
  batch_.x = x_.data();
  batch_.wale_angle = block.wale_angle.data();
  batch_.response = &model.material->response();
  batch_.params = params_.data();
  batch_.graduated = model.material->graduated();
  batch_.thickness = model.material->thickness();
  if (model.is_shell()) add_shell(problem, block, model, state);
}

void BlockArrays::add_shell(const Problem& problem, const mesh::Block& block, const BlockModel& model,
                            const State& state) {
  const std::vector<Frame> start = model.shell.placed_reference ? start_frames(problem) : std::vector<Frame>();
  for (const int n : block.connectivity) {
    frames_.insert(frames_.end(), state.frame[n].data(), state.frame[n].data() + 9);
    if (!model.shell.placed_reference) continue;
    const Vec3 director = start[n].row(2);
    for (const Vec3* v : {&problem.mesh->placed[n], &director})
      reference_.insert(reference_.end(), v->data(), v->data() + 3);
  }
  batch_.frames = frames_.data();
  batch_.reference = reference_.empty() ? nullptr : reference_.data();
  batch_.layers = model.shell.layers;
  batch_.shear_modulus = model.shell.shear_modulus;
  frozen_.resize(static_cast<size_t>(block.size()) * static_cast<size_t>(model.element->frozen_values()));
  model.element->freeze(batch_, frozen_.data());
  batch_.frozen = frozen_.data();
}

}  // namespace toile::solve
