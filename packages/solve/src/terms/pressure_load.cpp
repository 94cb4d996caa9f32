#include "terms/pressure_load.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "terms/follower_pressure.hpp"
#include "terms/pressure_edges.hpp"

namespace toile::solve {

namespace {

using Corners = std::array<double, 12>;  // [node][3] mm

Corners corners(const Configuration& at, const int* nodes, int count) {
  Corners x{};
  for (int i = 0; i < count; ++i) std::copy_n(&at.x[3 * static_cast<size_t>(nodes[i])], 3, &x[3 * i]);
  return x;
}

/// Calls use(i, j) for each edge of the element at which the pressure ends, from corner i to corner j.
template <class Use>
void for_each_edge(std::uint8_t edges, int nodes, const Use& use) {
  for (int i = 0; i < nodes; ++i)
    if ((edges >> i & 1U) != 0) use(i, (i + 1) % nodes);
}

Eigen::Map<const Vec3> corner(const double* x, int i) {
  return Eigen::Map<const Vec3>(x + 3 * i);
}

}  // namespace

PressureLoad::PressureLoad(const Problem& problem, const Layout& layout, const Graph& graph) : layout_(layout) {
  const std::vector<std::vector<std::uint8_t>> edges = find_pressure_edges(problem);
  for (const Layout::BlockPart& local : layout.blocks) {
    double sum = 0.0;
    for (const FollowerPressure& pressure : problem.pressures)
      if (pressure.block == local.block) sum += pressure.pressure;
    if (sum == 0.0) continue;
    Part part{
        &local, problem.mesh->blocks[local.block].nodes_per_element, sum, {}, Stencils(layout, local, graph, false)};
    for (const int e : local.elements) part.edges.push_back(edges[local.block][static_cast<size_t>(e)]);
    parts_.push_back(std::move(part));
  }
}

void PressureLoad::add(const Configuration& at, Forces& forces, double* tangent) {
  for (Part& part : parts_) {
    const size_t nodes = static_cast<size_t>(part.nodes), square = 9 * nodes * nodes;
    const double pressure = at.load * part.pressure;
    if (tangent != nullptr) part.stiffness.assign(square * part.layout->elements.size(), 0.0);
    for (size_t e = 0; e < part.layout->elements.size(); ++e) {
      const int* node = &part.layout->nodes[e * nodes];
      const Corners x = corners(at, node, part.nodes);
      double* own = tangent == nullptr ? nullptr : &part.stiffness[e * square];
      const PressureOnElement p = pressure_on_element(part.nodes, x.data(), pressure, own);
      if (own != nullptr) add_edges(part, e, pressure, x.data(), own);
      for (size_t i = 0; i < nodes; ++i) {
        const size_t c = 3 * static_cast<size_t>(layout_.node_cluster[node[i]]);
        for (size_t d = 0; d < 3; ++d) forces.force[c + d] -= p.force[3 * i + d];
      }
    }
    if (tangent != nullptr) part.stencils.add(part.stiffness.data(), tangent);
  }
}

void PressureLoad::add_edges(const Part& part, size_t element, double pressure, const double* x,
                             double* stiffness) const {
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> K(stiffness, 3 * part.nodes,
                                                                                       3 * part.nodes);
  for_each_edge(part.edges[element], part.nodes, [&](int i, int j) {
    const Eigen::Matrix3d block = pressure * edge_stiffness(corner(x, i), corner(x, j));
    K.block<3, 3>(3 * i, 3 * j) += block;
    K.block<3, 3>(3 * j, 3 * i) += block.transpose();
  });
}

double PressureLoad::potential(const Configuration& at, const Configuration& held) {
  double total = 0.0;
  for (const Part& part : parts_)
    for (size_t e = 0; e < part.layout->elements.size(); ++e) {
      if (!part.layout->owned[e]) continue;
      const int* node = &part.layout->nodes[e * static_cast<size_t>(part.nodes)];
      const Corners x = corners(at, node, part.nodes), x0 = corners(held, node, part.nodes);
      const double volume = pressure_on_element(part.nodes, x.data(), 0.0, nullptr).volume;
      double work = 0.0;
      for_each_edge(part.edges[e], part.nodes, [&](int i, int j) {
        work += edge_work(corner(x0.data(), i), corner(x0.data(), j), corner(x.data(), i), corner(x.data(), j));
      });
      total += at.load * part.pressure * (work - volume);
    }
  return total;
}

}  // namespace toile::solve
