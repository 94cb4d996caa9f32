#include "element_assembly.hpp"

#include <algorithm>
#include <cmath>

namespace toile::solve {

namespace {
constexpr int chunk = 128;  // elements a call: the buffers of one call stay in the second-level cache
}

ElementAssembly::ElementAssembly(const Problem& problem, const Layout& layout, const Graph& graph) : layout_(layout) {
  for (const Layout::BlockPart& local : layout.blocks) {
    const mesh::Block& block = problem.mesh->blocks[local.block];
    Part part{};
    part.element = problem.laws[local.block].element;
    part.material = problem.laws[local.block].material;
    part.layout = &local;
    part.nodes = block.nodes_per_element;
    for (const int e : local.elements) {
      part.wale_angle.push_back(block.wale_angle[e]);
      for (int i = 0; i < part.nodes; ++i) {
        const mesh::Vec2& p = problem.mesh->pattern[block.connectivity[static_cast<size_t>(e) * part.nodes + i]];
        part.pattern.insert(part.pattern.end(), {p[0], p[1]});
      }
      if (part.material->graduated()) {
        const std::vector<double> values = part.material->params_at(block.position[e]);
        part.params.insert(part.params.end(), values.begin(), values.end());
      }
    }
    if (!part.material->graduated()) part.params = part.material->params();
    const size_t n = local.elements.size(), ndof = static_cast<size_t>(part.element->ndof());
    part.x.resize(n * ndof);
    part.energy.resize(n);
    part.residual.resize(n * ndof);
    part.tangent.resize(n * ndof * ndof);
    part.status.resize(n);
    find_entries(part, graph);
    parts_.push_back(std::move(part));
  }
}

void ElementAssembly::find_entries(Part& part, const Graph& graph) const {
  const auto local = graph.getLocalGraphHost();
  const LocalId rows = static_cast<LocalId>(layout_.dof_map->getNodeNumElements());
  const int ndof = part.element->ndof();
  part.entry.reserve(part.layout->elements.size() * ndof * ndof);
  std::vector<LocalId> ids(ndof);
  for (size_t e = 0; e < part.layout->elements.size(); ++e) {
    for (int i = 0; i < part.nodes; ++i)
      for (int d = 0; d < 3; ++d)
        ids[3 * i + d] = layout_.dof[layout_.node_cluster[part.layout->nodes[e * part.nodes + i]]][d];
    for (const LocalId row : ids)
      for (const LocalId column : ids) {
        if (row < 0 || row >= rows || column < 0) {
          part.entry.push_back(-1);
          continue;
        }
        const auto* begin = local.entries.data() + local.row_map(row);
        const auto* end = local.entries.data() + local.row_map(row + 1);
        part.entry.push_back(std::lower_bound(begin, end, column) - local.entries.data());
      }
  }
}

void ElementAssembly::gather(Part& part, const std::vector<double>& x) const {
  for (size_t i = 0; i < part.layout->nodes.size(); ++i)
    std::copy_n(&x[3 * static_cast<size_t>(part.layout->nodes[i])], 3, &part.x[3 * i]);
}

element::Batch ElementAssembly::batch(const Part& part, int first, int count) const {
  element::Batch b;
  const size_t f = static_cast<size_t>(first);
  b.n = count;
  b.pattern = &part.pattern[f * part.nodes * 2];
  b.x = &part.x[f * part.element->ndof()];
  b.wale_angle = &part.wale_angle[f];
  b.response = &part.material->response();
  b.graduated = part.material->graduated();
  b.params = b.graduated ? &part.params[f * b.response->n_params()] : part.params.data();
  b.thickness = part.material->thickness();
  return b;
}

void ElementAssembly::run(Part& part, bool with_tangent) const {
  const int n = static_cast<int>(part.layout->elements.size());
  const size_t ndof = static_cast<size_t>(part.element->ndof());
#pragma omp parallel for schedule(static)
  for (int first = 0; first < n; first += chunk) {
    const size_t f = static_cast<size_t>(first);
    element::Result out;
    out.energy = &part.energy[f];
    out.residual = &part.residual[f * ndof];
    out.tangent = with_tangent ? &part.tangent[f * ndof * ndof] : nullptr;
    out.status = &part.status[f];
    part.element->evaluate(batch(part, first, std::min(chunk, n - first)), out);
  }
}

ElementAssembly::Sums ElementAssembly::evaluate(const std::vector<double>& x, double* values) {
  Sums sums;
  sums.force.assign(3 * layout_.clusters.size(), 0.0);
  sums.magnitude.assign(3 * layout_.clusters.size(), 0.0);
  for (Part& part : parts_) {
    gather(part, x);
    run(part, values != nullptr);
    for (size_t i = 0; i < part.layout->nodes.size(); ++i) {
      const size_t c = 3 * static_cast<size_t>(layout_.node_cluster[part.layout->nodes[i]]);
      for (size_t d = 0; d < 3; ++d) {
        sums.force[c + d] += part.residual[3 * i + d];
        sums.magnitude[c + d] += std::abs(part.residual[3 * i + d]);
      }
    }
    for (size_t e = 0; e < part.layout->elements.size(); ++e) {
      if (!part.layout->owned[e]) continue;
      sums.energy += part.energy[e];
      sums.extrapolated += part.status[e] == material::point_extrapolated;
    }
    if (values == nullptr) continue;
    for (size_t k = 0; k < part.entry.size(); ++k)
      if (part.entry[k] >= 0) values[part.entry[k]] += part.tangent[k];
  }
  return sums;
}

std::vector<double> ElementAssembly::reference_areas() const {
  std::vector<double> areas(layout_.nodes.size(), 0.0);
  for (const Part& part : parts_) {
    std::vector<double> local(part.layout->nodes.size());
    if (local.empty()) continue;
    part.element->reference_areas(batch(part, 0, static_cast<int>(part.layout->elements.size())), local.data());
    for (size_t i = 0; i < local.size(); ++i) areas[part.layout->nodes[i]] += local[i];
  }
  return areas;
}

std::vector<double> ElementAssembly::nodal_thickness(const std::vector<double>& x) {
  std::vector<double> areas(layout_.nodes.size(), 0.0), sum(layout_.nodes.size(), 0.0);
  for (Part& part : parts_) {
    const int n = static_cast<int>(part.layout->elements.size());
    if (n == 0) continue;
    gather(part, x);
    const element::Batch all = batch(part, 0, n);
    std::vector<double> local(part.layout->nodes.size());
    part.element->nodal_areas(all, local.data());
    const element::PointFields fields = part.element->fields(all);
    const size_t points = static_cast<size_t>(part.element->points());
    for (size_t i = 0; i < local.size(); ++i) {
      const size_t e = i / part.nodes;
      double mean = 0.0;
      for (size_t q = 0; q < points; ++q) mean += fields.thickness_stretch[e * points + q] / points;
      sum[part.layout->nodes[i]] += local[i] * mean * part.material->thickness();
      areas[part.layout->nodes[i]] += local[i];
    }
  }
  for (size_t n = 0; n < sum.size(); ++n) sum[n] = areas[n] > 0.0 ? sum[n] / areas[n] : 0.0;
  return sum;
}

}  // namespace toile::solve
