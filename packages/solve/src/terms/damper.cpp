#include "terms/damper.hpp"

#include <utility>

namespace toile::solve {

Damper::Damper(const Layout& layout, const Diagonal& diagonal, std::vector<double> mass)
    : layout_(layout), diagonal_(diagonal), mass_(std::move(mass)), cluster_mass_(layout.clusters.size(), 0.0) {
  for (size_t n = 0; n < mass_.size(); ++n) cluster_mass_[layout.node_cluster[n]] += mass_[n];
}

void Damper::add(const Configuration& at, Forces& forces, double* tangent) {
  if (coefficient_ == 0.0) return;
  const double factor = coefficient_ / interval(at.s);
  for (size_t n = 0; n < layout_.nodes.size(); ++n)
    for (size_t d = 0; d < 3; ++d)
      forces.force[3 * static_cast<size_t>(layout_.node_cluster[n]) + d] +=
          factor * mass_[n] * (at.x[3 * n + d] - start_[3 * n + d]);
  if (tangent != nullptr) diagonal_.add_mass(factor, cluster_mass_, tangent);
}

double Damper::potential(const Configuration& at, const Configuration&) {
  return 0.5 * dissipation(at);
}

double Damper::dissipation(const Configuration& at) const {
  if (coefficient_ == 0.0) return 0.0;
  double total = 0.0;
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (size_t d = 0; d < 3; ++d) {
      const double step = at.x[3 * n + d] - start_[3 * n + d];
      total += mass_[n] * step * step;
    }
  }
  return coefficient_ / interval(at.s) * total;
}

void Damper::start_step(const Configuration& at) {
  start_ = at.x;
  step_start_ = at.s;
}

}  // namespace toile::solve
