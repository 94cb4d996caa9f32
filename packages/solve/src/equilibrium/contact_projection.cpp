#include "equilibrium/contact_projection.hpp"

#include <algorithm>

namespace toile::solve {

ContactProjection::ContactProjection(const Layout& layout, const Graph& graph)
    : layout_(layout),
      normal_(layout.clusters.size(), Vec3::Zero()),
      active_(layout.clusters.size(), 0),
      free_part_(static_cast<size_t>(layout.owned_clusters), 0.0),
      cluster_of_dof_(graph.getColMap()->getNodeNumElements(), -1) {
  for (size_t c = 0; c < layout.clusters.size(); ++c)
    for (const LocalId d : layout.dof[c])
      if (d >= 0) cluster_of_dof_[d] = static_cast<int>(c);
}

void ContactProjection::set(const std::vector<Vec3>& normals) {
  Vector owned(layout_.maps.dof), overlap(layout_.maps.overlap);
  {
    auto data = owned.getDataNonConst();
    for (int c = 0; c < layout_.owned_clusters; ++c) {
      Vec3 free = Vec3::Zero();
      for (int i = 0; i < 3; ++i)
        if (layout_.dof[c][i] >= 0) free[i] = normals[c][i];
      const double length = free_part_[static_cast<size_t>(c)] = free.norm();
      if (length < tangential) continue;
      for (int i = 0; i < 3; ++i)
        if (layout_.dof[c][i] >= 0) data[layout_.dof[c][i]] = free[i] / length;
    }
  }
  overlap.doImport(owned, *layout_.maps.importer, Tpetra::INSERT);
  const auto data = overlap.getData();
  for (size_t c = 0; c < layout_.clusters.size(); ++c) {
    for (int i = 0; i < 3; ++i) normal_[c][i] = layout_.dof[c][i] >= 0 ? data[layout_.dof[c][i]] : 0.0;
    active_[c] = normal_[c].squaredNorm() > 0.5;
  }
}

void ContactProjection::project(const Matrix& from, double stiffness, Matrix& to) const {
  const auto source = from.getLocalMatrixHost();
  const auto target = to.getLocalMatrixHost();
  const auto& row_map = source.graph.row_map;
  const auto& columns = source.graph.entries;
  const LocalId rows = source.numRows();
  for (size_t k = 0; k < source.values.extent(0); ++k) target.values(k) = source.values(k);

  // From the right: in each row, the entries of one column cluster lose their part along its normal.
  for (LocalId row = 0; row < rows; ++row)
    for (size_t k = row_map(row); k < row_map(row + 1);) {
      const int c = cluster_of_dof_[columns(k)];
      size_t end = k;
      while (end < row_map(row + 1) && cluster_of_dof_[columns(end)] == c) ++end;
      if (c >= 0 && active_[c]) {
        double along = 0.0;
        const auto part = [&](size_t e) { return normal_[c][component_of(columns(e), c)]; };
        for (size_t e = k; e < end; ++e) along += target.values(e) * part(e);
        for (size_t e = k; e < end; ++e) target.values(e) -= along * part(e);
      }
      k = end;
    }
  // From the left: the rows of one cluster have the same columns.
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    if (!active_[c]) continue;
    const auto& dof = layout_.dof[c];
    const LocalId some = *std::find_if(dof.begin(), dof.end(), [](LocalId d) { return d >= 0; });
    const size_t count = row_map(some + 1) - row_map(some);
    for (size_t k = 0; k < count; ++k) {
      double along = 0.0;
      for (int i = 0; i < 3; ++i)
        if (dof[i] >= 0) along += normal_[c][i] * target.values(row_map(dof[i]) + k);
      for (int i = 0; i < 3; ++i) {
        if (dof[i] < 0) continue;
        double& value = target.values(row_map(dof[i]) + k);
        value -= normal_[c][i] * along;
        const LocalId column = columns(row_map(dof[i]) + k);
        if (cluster_of_dof_[column] == c) value += stiffness * normal_[c][i] * normal_[c][component_of(column, c)];
      }
    }
  }
}

int ContactProjection::component_of(LocalId dof, int cluster) const {
  const auto& ids = layout_.dof[cluster];
  return dof == ids[0] ? 0 : dof == ids[1] ? 1 : 2;
}

double ContactProjection::component(const Vector& v, int cluster) const {
  const auto data = v.getData();
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
    if (layout_.dof[cluster][i] >= 0) sum += normal_[cluster][i] * data[layout_.dof[cluster][i]];
  return sum;
}

void ContactProjection::add(Vector& v, int cluster, double value) const {
  auto data = v.getDataNonConst();
  for (int i = 0; i < 3; ++i)
    if (layout_.dof[cluster][i] >= 0) data[layout_.dof[cluster][i]] += value * normal_[cluster][i];
}

void ContactProjection::project(Vector& v) const {
  for (int c = 0; c < layout_.owned_clusters; ++c)
    if (active_[c]) add(v, c, -component(v, c));
}

}  // namespace toile::solve
