#include "terms/strain.hpp"

#include <algorithm>
#include <cmath>

namespace toile::solve {

namespace {
constexpr int chunk = 128;  // elements a call: the buffers of one call stay in the second-level cache
}

Strain::Strain(const Problem& problem, const Layout& layout, const Graph& graph) : layout_(layout) {
  const auto is_curved = [](const BlockModel& model) { return model.shell.placed_reference; };
  const bool curved = std::any_of(problem.models.begin(), problem.models.end(), is_curved);
  const std::vector<Frame> start = curved ? start_frames(problem) : std::vector<Frame>();
  for (const Layout::BlockPart& local : layout.blocks) parts_.push_back(make_part(problem, local, start, graph));
}

Strain::Part Strain::make_part(const Problem& problem, const Layout::BlockPart& local, const std::vector<Frame>& start,
                               const Graph& graph) {
  const mesh::Block& block = problem.mesh->blocks[local.block];
  Part part(problem.models[local.block], local, block.nodes_per_element, Stencils(layout_, local, graph, true));
  for (const int e : local.elements) {
    part.reference.wale_angle.push_back(block.wale_angle[e]);
    for (int i = 0; i < part.nodes; ++i) {
      const int node = block.connectivity[static_cast<size_t>(e) * part.nodes + i];
      const mesh::Vec2& p = problem.mesh->pattern[node];
      part.reference.pattern.insert(part.reference.pattern.end(), {p[0], p[1]});
      if (!part.shell.placed_reference) continue;
      for (const Vec3& v : {problem.mesh->placed[node], start[node].row(2).transpose().eval()})
        part.reference.directors.insert(part.reference.directors.end(), v.data(), v.data() + 3);
    }
    if (part.material->graduated()) {
      const std::vector<double> values = part.material->params_at(block.position[e]);
      part.reference.params.insert(part.reference.params.end(), values.begin(), values.end());
    }
  }
  if (!part.material->graduated()) part.reference.params = part.material->params();
  const size_t n = local.elements.size(), ndof = static_cast<size_t>(part.element->ndof());
  part.present.x.resize(n * ndof);
  part.results.energy.resize(n);
  part.results.residual.resize(n * ndof);
  part.results.tangent.resize(n * ndof * ndof);
  part.results.status.resize(n);
  if (local.shell) part.present.frames.resize(9 * n * part.nodes);
  part.frozen.now.resize(n * static_cast<size_t>(part.element->frozen_values()));
  part.frozen.first = all_frozen_;
  all_frozen_ += static_cast<size_t>(block.size()) * static_cast<size_t>(part.element->frozen_values());
  return part;
}

void Strain::gather(Part& part, const Configuration& at) const {
  const size_t stride = static_cast<size_t>(part.element->dofs_per_node());
  for (size_t i = 0; i < part.layout->nodes.size(); ++i) {
    const size_t n = static_cast<size_t>(part.layout->nodes[i]);
    std::copy_n(&at.x[3 * n], 3, &part.present.x[stride * i]);
    if (part.layout->shell) std::copy_n(&at.rotation[2 * n], 2, &part.present.x[stride * i + 3]);
  }
}

element::Batch Strain::batch(const Part& part, int first, int count) const {
  element::Batch b;
  const size_t f = static_cast<size_t>(first);
  b.n = count;
  b.pattern = &part.reference.pattern[f * part.nodes * 2];
  b.x = &part.present.x[f * part.element->ndof()];
  b.wale_angle = &part.reference.wale_angle[f];
  b.response = &part.material->response();
  b.graduated = part.material->graduated();
  b.params = b.graduated ? &part.reference.params[f * b.response->n_params()] : part.reference.params.data();
  b.thickness = part.material->thickness();
  if (part.layout->shell) {
    b.frames = &part.present.frames[9 * f * part.nodes];
    b.reference = part.reference.directors.empty() ? nullptr : &part.reference.directors[6 * f * part.nodes];
    b.frozen = &part.frozen.now[f * part.element->frozen_values()];
    b.layers = part.shell.layers;
    b.shear_modulus = part.shell.shear_modulus;
  }
  return b;
}

void Strain::run(Part& part, bool with_tangent) const {
  const int n = static_cast<int>(part.layout->elements.size());
  const size_t ndof = static_cast<size_t>(part.element->ndof());
#pragma omp parallel for schedule(static)
  for (int first = 0; first < n; first += chunk) {
    const size_t f = static_cast<size_t>(first);
    element::Result out;
    out.energy = &part.results.energy[f];
    out.residual = &part.results.residual[f * ndof];
    out.tangent = with_tangent ? &part.results.tangent[f * ndof * ndof] : nullptr;
    out.status = &part.results.status[f];
    part.element->evaluate(batch(part, first, std::min(chunk, n - first)), out);
  }
}

void Strain::add_up(const Part& part, Forces& forces) const {
  const size_t stride = static_cast<size_t>(part.element->dofs_per_node());
  for (size_t i = 0; i < part.layout->nodes.size(); ++i) {
    const size_t n = static_cast<size_t>(part.layout->nodes[i]);
    const size_t c = 3 * static_cast<size_t>(layout_.node_cluster[n]);
    const double* r = &part.results.residual[stride * i];
    for (size_t d = 0; d < 3; ++d) {
      forces.force[c + d] += r[d];
      forces.magnitude[c + d] += std::abs(r[d]);
    }
    for (size_t k = 0; k < 2 && part.layout->shell; ++k) {
      forces.moment[2 * n + k] += r[3 + k];
      forces.moment_magnitude[2 * n + k] += std::abs(r[3 + k]);
    }
  }
  for (size_t e = 0; e < part.layout->elements.size(); ++e) {
    if (!part.layout->owned[e]) continue;
    forces.strain_energy += part.results.energy[e];
    forces.extrapolated += part.results.status[e] == material::point_extrapolated;
  }
}

void Strain::add(const Configuration& at, Forces& forces, double* tangent) {
  for (Part& part : parts_) {
    gather(part, at);
    run(part, tangent != nullptr);
    add_up(part, forces);
    if (tangent != nullptr) part.stencils.add(part.results.tangent.data(), tangent);
  }
}

double Strain::potential(const Configuration& at, const Configuration&) {
  double energy = 0.0;
  for (Part& part : parts_) {
    gather(part, at);
    run(part, false);
    for (size_t e = 0; e < part.layout->elements.size(); ++e)
      if (part.layout->owned[e]) energy += part.results.energy[e];
  }
  return energy;
}

void Strain::set_frames(const std::vector<Frame>& frames) {
  for (Part& part : parts_)
    for (size_t i = 0; i < part.layout->nodes.size() && part.layout->shell; ++i)
      std::copy_n(frames[part.layout->nodes[i]].data(), 9, &part.present.frames[9 * i]);
}

double Strain::find_frozen(const Configuration& at) {
  double change = 0.0;
  for (Part& part : parts_) {
    const size_t per = static_cast<size_t>(part.element->frozen_values()), n = part.layout->elements.size();
    if (per == 0 || n == 0) continue;
    gather(part, at);
    part.frozen.next.resize(part.frozen.now.size());
    part.element->freeze(batch(part, 0, static_cast<int>(n)), part.frozen.next.data());
    const size_t points = static_cast<size_t>(part.element->points());
    for (size_t k = 0; k < n * per; ++k)
      if (k % per < points)  // the first values are the thickness stretches of the points
        change = std::max(change, part.material->thickness() * std::abs(part.frozen.next[k] - part.frozen.now[k]));
  }
  return change;
}

void Strain::adopt_frozen() {
  for (Part& part : parts_) std::swap(part.frozen.now, part.frozen.next);
}

std::vector<double> Strain::frozen() const {
  std::vector<double> all(all_frozen_, 0.0);
  for (const Part& part : parts_) {
    const size_t per = static_cast<size_t>(part.element->frozen_values());
    for (size_t e = 0; e < part.layout->elements.size() && per > 0; ++e)
      if (part.layout->owned[e])
        std::copy_n(&part.frozen.now[per * e], per,
                    &all[part.frozen.first + per * static_cast<size_t>(part.layout->elements[e])]);
  }
  return all;
}

void Strain::set_frozen(const std::vector<double>& all) {
  for (Part& part : parts_) {
    const size_t per = static_cast<size_t>(part.element->frozen_values());
    for (size_t e = 0; e < part.layout->elements.size() && per > 0; ++e)
      std::copy_n(&all[part.frozen.first + per * static_cast<size_t>(part.layout->elements[e])], per,
                  &part.frozen.now[per * e]);
  }
}

double Strain::stabilisation_energy(const Configuration& at) {
  double sum = 0.0;
  for (Part& part : parts_) {
    if (!part.element->stabilised() || part.layout->elements.empty()) continue;
    gather(part, at);
    std::vector<double> energy(part.layout->elements.size());
    part.element->stabilisation_energy(batch(part, 0, static_cast<int>(energy.size())), energy.data());
    for (size_t e = 0; e < energy.size(); ++e)
      if (part.layout->owned[e]) sum += energy[e];
  }
  return sum;
}

std::vector<double> Strain::gradient_products(size_t part) const {
  const Part& of = parts_[part];
  const size_t n = of.layout->elements.size();
  std::vector<double> products(n * static_cast<size_t>(of.nodes * of.nodes));
  if (n > 0) of.element->gradient_products(batch(of, 0, static_cast<int>(n)), products.data());
  return products;
}

std::vector<double> Strain::reference_areas() const {
  std::vector<double> areas(layout_.nodes.size(), 0.0);
  for (const Part& part : parts_) {
    std::vector<double> local(part.layout->nodes.size());
    if (local.empty()) continue;
    part.element->reference_areas(batch(part, 0, static_cast<int>(part.layout->elements.size())), local.data());
    for (size_t i = 0; i < local.size(); ++i) areas[part.layout->nodes[i]] += local[i];
  }
  return areas;
}

std::vector<double> Strain::nodal_thickness(const Configuration& at) {
  std::vector<double> areas(layout_.nodes.size(), 0.0), sum(layout_.nodes.size(), 0.0);
  for (Part& part : parts_) {
    const int n = static_cast<int>(part.layout->elements.size());
    if (n == 0) continue;
    gather(part, at);
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
