#include "terms/dead_load.hpp"

namespace toile::solve {

DeadLoad::DeadLoad(const Problem& problem, const Layout& layout, const Kinematics& kinematics)
    : layout_(layout), kinematics_(kinematics) {
  std::vector<Vec3> force(problem.mesh->nodes(), Vec3::Zero()), moment(force);
  for (const NodalLoad& load : problem.loads)
    for (size_t i = 0; i < load.nodes.size(); ++i)
      (load.moment ? moment : force)[load.nodes[i]] += load.share[i] * load.value;
  force_.assign(3 * layout.clusters.size(), 0.0);
  for (size_t n = 0; n < layout.nodes.size(); ++n)
    for (int d = 0; d < 3; ++d)
      force_[3 * static_cast<size_t>(layout.node_cluster[n]) + d] += force[layout.nodes[n]][d];
  if (!layout.has_shells()) return;
  for (const int node : layout.nodes) moment_.push_back(moment[node]);
}

void DeadLoad::add(const Configuration& at, Forces& forces, double*) {
  for (size_t i = 0; i < force_.size(); ++i) forces.force[i] -= at.load * force_[i];
  for (size_t n = 0; n < moment_.size(); ++n)
    for (int k = 0; k < 2; ++k) forces.moment[2 * n + k] -= at.load * moment_[n].dot(kinematics_.moment_axis(n, k));
}

double DeadLoad::potential(const Configuration& at, const Configuration&) {
  double work = 0.0;
  for (size_t i = 0; i < 3 * static_cast<size_t>(layout_.owned_clusters); ++i) work += force_[i] * at.master[i];
  for (size_t n = 0; n < moment_.size(); ++n)
    for (int k = 0; k < 2 && layout_.node_cluster[n] < layout_.owned_clusters; ++k)
      work += moment_[n].dot(kinematics_.moment_axis(n, k)) * at.rotation[2 * n + k];
  return -at.load * work;
}

double DeadLoad::moments() const {
  double total = 0.0;
  for (size_t n = 0; n < moment_.size(); ++n)
    if (layout_.node_cluster[n] < layout_.owned_clusters) total += moment_[n].lpNorm<1>();
  return total;
}

}  // namespace toile::solve
