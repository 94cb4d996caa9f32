#include "equilibrium/stencils.hpp"

#include <algorithm>

namespace toile::solve {

std::int64_t place_of(const Graph& graph, LocalId row, LocalId column) {
  if (row < 0 || row >= static_cast<LocalId>(graph.getRowMap()->getNodeNumElements()) || column < 0) return -1;
  const auto local = graph.getLocalGraphHost();
  const auto* begin = local.entries.data() + local.row_map(row);
  const auto* end = local.entries.data() + local.row_map(row + 1);
  return std::lower_bound(begin, end, column) - local.entries.data();
}

Stencils::Stencils(const Layout& layout, const Layout::BlockPart& block, const Graph& graph, bool with_rotations)
    : layout_(layout), block_(block) {
  const size_t elements = block.elements.size();
  if (elements == 0) return;
  const size_t nodes = block.nodes.size() / elements;
  nodes_ = static_cast<int>(nodes);
  unknowns_ = nodes_ * (with_rotations && block.shell ? 5 : 3);
  places_.reserve(elements * static_cast<size_t>(unknowns_) * static_cast<size_t>(unknowns_));
  std::vector<LocalId> ids;
  for (size_t e = 0; e < elements; ++e) {
    layout.element_unknowns(block, e, with_rotations, ids);
    for (const LocalId row : ids)
      for (const LocalId column : ids) places_.push_back(place_of(graph, row, column));
    const int* node = &block.nodes[e * nodes];
    if (std::any_of(node, node + nodes, [&](int i) { return layout.is_turned(layout.node_cluster[i]); }))
      turned_.push_back(e);
  }
}

void Stencils::add(double* derivatives, double* values) const {
  for (const size_t e : turned_) turn(e, derivatives);
  for (size_t k = 0; k < places_.size(); ++k)
    if (places_[k] >= 0) values[places_[k]] += derivatives[k];
}

void Stencils::turn(size_t element, double* derivatives) const {
  const Eigen::Index n = unknowns_, stride = unknowns_ / nodes_;
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> own(
      derivatives + element * static_cast<size_t>(n * n), n, n);
  for (Eigen::Index i = 0; i < nodes_; ++i) {
    const int c = layout_.node_cluster[block_.nodes[element * static_cast<size_t>(nodes_) + static_cast<size_t>(i)]];
    if (!layout_.is_turned(c)) continue;
    const Eigen::Matrix3d& along = layout_.basis[c].along;
    own.middleRows<3>(stride * i) = (along.transpose() * own.middleRows<3>(stride * i)).eval();
    own.middleCols<3>(stride * i) = (own.middleCols<3>(stride * i) * along).eval();
  }
}

}  // namespace toile::solve
