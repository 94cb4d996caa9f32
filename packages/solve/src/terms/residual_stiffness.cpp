#include "terms/residual_stiffness.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "terms/pattern_areas.hpp"

namespace toile::solve {

namespace {

bool has_some(const BlockModel& model) {
  return model.material->response().residual_stiffness() > 0.0;
}

}  // namespace

bool ResidualStiffness::is_in(const Problem& problem) {
  return std::any_of(problem.models.begin(), problem.models.end(), has_some);
}

ResidualStiffness::ResidualStiffness(const Problem& problem, const Layout& layout, const Graph& graph,
                                     const Strain& strain, const Configuration& start)
    : layout_(layout), start_(start.x) {
  for (size_t b = 0; b < layout.blocks.size(); ++b) {
    const Layout::BlockPart& local = layout.blocks[b];
    const BlockModel& model = problem.models[local.block];
    if (!has_some(model)) continue;
    const material::Material& fabric = *model.material;
    const mesh::Block& block = problem.mesh->blocks[local.block];
    // A shell resists by its bending, which is softer than stretching by that much.
    const std::vector<double> areas = pattern_areas(*problem.mesh, block);
    const double softer =
        model.is_shell() ? fabric.thickness() * fabric.thickness() / std::accumulate(areas.begin(), areas.end(), 0.0)
                         : 1.0;
    const auto factor = [&](const std::vector<double>& params) {
      return fabric.response().residual_stiffness() * softer * fabric.thickness() *
             fabric.response().natural_stiffness(params.data());
    };
    const double even = fabric.graduated() ? 0.0 : factor(fabric.params());
    Part part{&local,
              static_cast<size_t>(block.nodes_per_element),
              Stencils(layout, local, graph, false),
              strain.gradient_products(b),
              {}};
    const size_t square = part.nodes * part.nodes;
    for (size_t e = 0; e < local.elements.size(); ++e) {
      const double here = fabric.graduated() ? factor(fabric.params_at(block.position[local.elements[e]])) : even;
      for (size_t k = 0; k < square; ++k) part.stiffness[square * e + k] *= here;
    }
    parts_.push_back(std::move(part));
  }
}

double ResidualStiffness::moved(int node, size_t component, const Configuration& at) const {
  const size_t place = 3 * static_cast<size_t>(node) + component;
  return at.x[place] - start_[place];
}

void ResidualStiffness::add_forces(const Part& part, size_t element, const Configuration& at, Forces& forces) const {
  const size_t n = part.nodes;
  const int* node = &part.layout->nodes[element * n];
  const double* K = &part.stiffness[element * n * n];
  for (size_t j = 0; j < n; ++j)
    for (size_t d = 0; d < 3; ++d) {
      const double u = moved(node[j], d, at);
      for (size_t i = 0; i < n; ++i)
        forces.force[3 * static_cast<size_t>(layout_.node_cluster[node[i]]) + d] += K[i * n + j] * u;
    }
}

void ResidualStiffness::add(const Configuration& at, Forces& forces, double* tangent) {
  if (!active_) return;
  for (Part& part : parts_) {
    const size_t n = part.nodes, unknowns = 3 * n, elements = part.layout->elements.size();
    for (size_t e = 0; e < elements; ++e) add_forces(part, e, at, forces);
    if (tangent == nullptr) continue;
    part.tangent.assign(unknowns * unknowns * elements, 0.0);
    for (size_t e = 0; e < elements; ++e)
      for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j)
          for (size_t d = 0; d < 3; ++d)
            part.tangent[(unknowns * e + 3 * i + d) * unknowns + 3 * j + d] = part.stiffness[(n * e + i) * n + j];
    part.stencils.add(part.tangent.data(), tangent);
  }
}

double ResidualStiffness::potential(const Configuration& at, const Configuration&) {
  double total = 0.0;
  for (const Part& part : parts_)
    for (size_t e = 0; e < part.layout->elements.size(); ++e) {
      if (!part.layout->owned[e]) continue;
      const size_t n = part.nodes;
      const int* node = &part.layout->nodes[e * n];
      const double* K = &part.stiffness[e * n * n];
      for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < n; ++j)
          for (size_t d = 0; d < 3; ++d) total += 0.5 * K[i * n + j] * moved(node[i], d, at) * moved(node[j], d, at);
    }
  return total;
}

}  // namespace toile::solve
