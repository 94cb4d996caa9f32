#include "element_assembly.hpp"

#include <algorithm>
#include <cmath>

#include "follower_pressure.hpp"
#include "pressure_edges.hpp"

namespace toile::solve {

namespace {
constexpr int chunk = 128;  // elements a call: the buffers of one call stay in the second-level cache
}

ElementAssembly::ElementAssembly(const Problem& problem, const Layout& layout, const Graph& graph) : layout_(layout) {
  const auto is_curved = [](const BlockLaw& law) { return law.shell.placed_reference; };
  const bool curved = std::any_of(problem.laws.begin(), problem.laws.end(), is_curved);
  const std::vector<Frame> start = curved ? start_frames(problem) : std::vector<Frame>();
  const std::vector<std::vector<std::uint8_t>> edges = find_pressure_edges(problem);
  for (const std::vector<std::uint8_t>& block : edges)
    has_pressure_edges_ = has_pressure_edges_ || std::any_of(block.begin(), block.end(), [](auto e) { return e != 0; });
  for (const Layout::BlockPart& local : layout.blocks) {
    const mesh::Block& block = problem.mesh->blocks[local.block];
    Part part{};
    part.element = problem.laws[local.block].element;
    part.material = problem.laws[local.block].material;
    part.layout = &local;
    part.shell = problem.laws[local.block].shell;
    part.nodes = block.nodes_per_element;
    for (const FollowerPressure& pressure : problem.pressures)
      if (pressure.block == local.block) part.pressure += pressure.pressure;
    for (const int e : local.elements) {
      part.wale_angle.push_back(block.wale_angle[e]);
      if (part.pressure != 0.0) part.pressure_edges.push_back(edges[local.block][static_cast<size_t>(e)]);
      for (int i = 0; i < part.nodes; ++i) {
        const mesh::Vec2& p = problem.mesh->pattern[block.connectivity[static_cast<size_t>(e) * part.nodes + i]];
        part.pattern.insert(part.pattern.end(), {p[0], p[1]});
        if (!part.shell.placed_reference) continue;
        const int node = block.connectivity[static_cast<size_t>(e) * part.nodes + i];
        for (const Vec3& v : {problem.mesh->placed[node], start[node].row(2).transpose().eval()})
          part.reference.insert(part.reference.end(), v.data(), v.data() + 3);
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
    if (local.shell) part.frames.resize(9 * n * part.nodes);
    part.frozen.resize(n * static_cast<size_t>(part.element->frozen_values()));
    part.first_frozen = all_frozen_;
    all_frozen_ += static_cast<size_t>(block.size()) * static_cast<size_t>(part.element->frozen_values());
    for (size_t e = 0; e < n; ++e) {
      const int* node = &local.nodes[e * static_cast<size_t>(part.nodes)];
      if (std::any_of(node, node + part.nodes, [&](int i) { return layout.is_turned(layout.node_cluster[i]); }))
        part.turned.push_back(e);
    }
    find_entries(part, graph);
    has_pressure_ = has_pressure_ || part.pressure != 0.0;
    parts_.push_back(std::move(part));
  }
}

void ElementAssembly::find_entries(Part& part, const Graph& graph) const {
  const auto local = graph.getLocalGraphHost();
  const LocalId rows = static_cast<LocalId>(layout_.dof_map->getNodeNumElements());
  const int ndof = part.element->ndof();
  part.entry.reserve(part.layout->elements.size() * ndof * ndof);
  std::vector<LocalId> ids;
  for (size_t e = 0; e < part.layout->elements.size(); ++e) {
    layout_.element_unknowns(*part.layout, e, ids);
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

void ElementAssembly::gather(Part& part, const Configuration& at) const {
  const size_t stride = static_cast<size_t>(part.element->dofs_per_node());
  for (size_t i = 0; i < part.layout->nodes.size(); ++i) {
    const size_t n = static_cast<size_t>(part.layout->nodes[i]);
    std::copy_n(&at.x[3 * n], 3, &part.x[stride * i]);
    if (part.layout->shell) std::copy_n(&at.rotation[2 * n], 2, &part.x[stride * i + 3]);
  }
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
  if (part.layout->shell) {
    b.frames = &part.frames[9 * f * part.nodes];
    b.reference = part.reference.empty() ? nullptr : &part.reference[6 * f * part.nodes];
    b.frozen = &part.frozen[f * part.element->frozen_values()];
    b.layers = part.shell.layers;
    b.shear_modulus = part.shell.shear_modulus;
  }
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

void ElementAssembly::add_pressure(Part& part, double load, bool with_tangent, Sums& sums) const {
  const size_t stride = static_cast<size_t>(part.element->dofs_per_node()), nodes = static_cast<size_t>(part.nodes);
  const size_t ndof = stride * nodes;
  std::vector<double> stiffness(9 * nodes * nodes);
  for (size_t e = 0; e < part.layout->elements.size(); ++e) {
    std::fill(stiffness.begin(), stiffness.end(), 0.0);
    const PressureOnElement p = pressure_on_element(part.nodes, static_cast<int>(stride), &part.x[e * ndof],
                                                    load * part.pressure, with_tangent ? stiffness.data() : nullptr);
    const double of_edges =
        add_pressure_edges(part, e, load * part.pressure, with_tangent ? stiffness.data() : nullptr);
    if (part.layout->owned[e]) sums.pressure_potential += load * part.pressure * (of_edges - p.volume);
    for (size_t i = 0; i < nodes; ++i) {
      const size_t c = 3 * static_cast<size_t>(layout_.node_cluster[part.layout->nodes[e * nodes + i]]);
      for (size_t d = 0; d < 3; ++d) sums.pressure_force[c + d] += p.force[3 * i + d];
    }
    if (!with_tangent) continue;
    for (size_t r = 0; r < 3 * nodes; ++r)
      for (size_t q = 0; q < 3 * nodes; ++q)
        part.tangent[(e * ndof + r / 3 * stride + r % 3) * ndof + q / 3 * stride + q % 3] +=
            stiffness[r * 3 * nodes + q];
  }
}

// From derivatives by x, y and z to those by the components of the clusters.
void ElementAssembly::turn_tangents(Part& part) const {
  const Eigen::Index stride = part.element->dofs_per_node(), ndof = part.element->ndof();
  for (const size_t e : part.turned) {
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> tangent(
        &part.tangent[e * static_cast<size_t>(ndof * ndof)], ndof, ndof);
    for (Eigen::Index i = 0; i < part.nodes; ++i) {
      const size_t place = e * static_cast<size_t>(part.nodes) + static_cast<size_t>(i);
      const int c = layout_.node_cluster[part.layout->nodes[place]];
      if (!layout_.is_turned(c)) continue;
      const Eigen::Matrix3d& along = layout_.basis[c].along;
      tangent.middleRows<3>(stride * i) = (along.transpose() * tangent.middleRows<3>(stride * i)).eval();
      tangent.middleCols<3>(stride * i) = (tangent.middleCols<3>(stride * i) * along).eval();
    }
  }
}

double ElementAssembly::add_pressure_edges(const Part& part, size_t element, double pressure, double* stiffness) const {
  const size_t nodes = static_cast<size_t>(part.nodes), stride = static_cast<size_t>(part.element->dofs_per_node());
  double work = 0.0;
  for (size_t i = 0; i < nodes; ++i) {
    if ((part.pressure_edges[element] >> i & 1U) == 0) continue;
    const size_t j = (i + 1) % nodes, first = element * nodes;
    const Eigen::Map<const Vec3> a(&part.x[stride * (first + i)]), b(&part.x[stride * (first + j)]);
    if (!part.edge_x.empty()) {
      const Eigen::Map<const Vec3> a0(&part.edge_x[3 * (first + i)]), b0(&part.edge_x[3 * (first + j)]);
      work += edge_work(a0, b0, a, b);
    }
    if (stiffness == nullptr) continue;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> K(stiffness, 3 * part.nodes,
                                                                                         3 * part.nodes);
    const Eigen::Matrix3d block = pressure * edge_stiffness(a, b);
    K.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j)) += block;
    K.block<3, 3>(3 * static_cast<Eigen::Index>(j), 3 * static_cast<Eigen::Index>(i)) += block.transpose();
  }
  return work;
}

void ElementAssembly::hold_pressure_edges(const Configuration& at) {
  for (Part& part : parts_) {
    if (part.pressure_edges.empty()) continue;
    part.edge_x.resize(3 * part.layout->nodes.size());
    for (size_t i = 0; i < part.layout->nodes.size(); ++i)
      std::copy_n(&at.x[3 * static_cast<size_t>(part.layout->nodes[i])], 3, &part.edge_x[3 * i]);
  }
}

void ElementAssembly::add_up(const Part& part, Sums& sums) const {
  const size_t stride = static_cast<size_t>(part.element->dofs_per_node());
  for (size_t i = 0; i < part.layout->nodes.size(); ++i) {
    const size_t n = static_cast<size_t>(part.layout->nodes[i]);
    const size_t c = 3 * static_cast<size_t>(layout_.node_cluster[n]);
    const double* r = &part.residual[stride * i];
    for (size_t d = 0; d < 3; ++d) {
      sums.force[c + d] += r[d];
      sums.magnitude[c + d] += std::abs(r[d]);
    }
    for (size_t k = 0; k < 2 && part.layout->shell; ++k) {
      sums.moment[2 * n + k] += r[3 + k];
      sums.moment_magnitude[2 * n + k] += std::abs(r[3 + k]);
    }
  }
  for (size_t e = 0; e < part.layout->elements.size(); ++e) {
    if (!part.layout->owned[e]) continue;
    sums.energy += part.energy[e];
    sums.extrapolated += part.status[e] == material::point_extrapolated;
  }
}

ElementAssembly::Sums ElementAssembly::evaluate(const Configuration& at, double load, double* values) {
  Sums sums;
  sums.force.assign(3 * layout_.clusters.size(), 0.0);
  sums.magnitude.assign(3 * layout_.clusters.size(), 0.0);
  if (layout_.has_shells()) {
    sums.moment.assign(2 * layout_.nodes.size(), 0.0);
    sums.moment_magnitude.assign(2 * layout_.nodes.size(), 0.0);
  }
  if (has_pressure_) sums.pressure_force.assign(3 * layout_.clusters.size(), 0.0);
  for (Part& part : parts_) {
    gather(part, at);
    run(part, values != nullptr);
    add_up(part, sums);
    if (part.pressure != 0.0) add_pressure(part, load, values != nullptr, sums);
    if (values == nullptr) continue;
    turn_tangents(part);
    for (size_t k = 0; k < part.entry.size(); ++k)
      if (part.entry[k] >= 0) values[part.entry[k]] += part.tangent[k];
  }
  return sums;
}

void ElementAssembly::set_frames(const std::vector<Frame>& frames) {
  for (Part& part : parts_)
    for (size_t i = 0; i < part.layout->nodes.size() && part.layout->shell; ++i)
      std::copy_n(frames[part.layout->nodes[i]].data(), 9, &part.frames[9 * i]);
}

double ElementAssembly::find_frozen(const Configuration& at) {
  double change = 0.0;
  for (Part& part : parts_) {
    const size_t per = static_cast<size_t>(part.element->frozen_values()), n = part.layout->elements.size();
    if (per == 0 || n == 0) continue;
    gather(part, at);
    part.next_frozen.resize(part.frozen.size());
    part.element->freeze(batch(part, 0, static_cast<int>(n)), part.next_frozen.data());
    const size_t points = static_cast<size_t>(part.element->points());
    for (size_t k = 0; k < n * per; ++k)
      if (k % per < points)  // the first values are the thickness stretches of the points
        change = std::max(change, part.material->thickness() * std::abs(part.next_frozen[k] - part.frozen[k]));
  }
  return change;
}

void ElementAssembly::adopt_frozen() {
  for (Part& part : parts_) std::swap(part.frozen, part.next_frozen);
}

std::vector<double> ElementAssembly::frozen() const {
  std::vector<double> all(all_frozen_, 0.0);
  for (const Part& part : parts_) {
    const size_t per = static_cast<size_t>(part.element->frozen_values());
    for (size_t e = 0; e < part.layout->elements.size() && per > 0; ++e)
      if (part.layout->owned[e])
        std::copy_n(&part.frozen[per * e], per,
                    &all[part.first_frozen + per * static_cast<size_t>(part.layout->elements[e])]);
  }
  return all;
}

void ElementAssembly::set_frozen(const std::vector<double>& all) {
  for (Part& part : parts_) {
    const size_t per = static_cast<size_t>(part.element->frozen_values());
    for (size_t e = 0; e < part.layout->elements.size() && per > 0; ++e)
      std::copy_n(&all[part.first_frozen + per * static_cast<size_t>(part.layout->elements[e])], per,
                  &part.frozen[per * e]);
  }
}

double ElementAssembly::stabilisation_energy(const Configuration& at) {
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

std::vector<double> ElementAssembly::nodal_thickness(const Configuration& at) {
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
