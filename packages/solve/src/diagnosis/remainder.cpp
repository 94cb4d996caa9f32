#include "diagnosis/remainder.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <cmath>

#include "watch/watch.hpp"

namespace toile::solve {

namespace {

constexpr size_t left_per_cluster = 4;  // force and opening

std::vector<double> local_values(const Layout& layout, const Vector& f, size_t clusters) {
  std::vector<double> mine(left_per_cluster * clusters, 0.0);
  const auto data = f.getData();
  const size_t first = layout.maps.dof->getNodeNumElements();
  for (int c = 0; c < layout.owned_clusters; ++c) {
    double* at = &mine[left_per_cluster * static_cast<size_t>(layout.clusters[c])];
    for (size_t d = 0; d < 3; ++d)
      if (layout.dof[c][d] >= 0) at[d] = data[layout.dof[c][d]];
    if (layout.contact) at[3] = std::abs(data[first + static_cast<size_t>(c)]);
  }
  return mine;
}

}  // namespace

Remainder remainder_of(Equilibrium& equilibrium, const Attempt& attempt, double damping, size_t clusters) {
  const double now = equilibrium.damping();
  equilibrium.set_damping(damping);
  Vector f(attempt.z->getMap());
  const Evaluation evaluation = equilibrium.residual(*attempt.z, attempt.s, f);
  equilibrium.set_damping(now);
  const Layout& layout = equilibrium.layout();
  const std::vector<double> mine = local_values(layout, f, clusters);
  std::vector<double> all(mine.size());
  Teuchos::reduceAll(*layout.comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  Remainder left;
  for (size_t c = 0; c < clusters; ++c) {
    const double* at = &all[left_per_cluster * c];
    left.force.emplace_back(at[0], at[1], at[2]);
    left.opening.push_back(at[3]);
  }
  left.total = evaluation.imbalance;
  left.s = attempt.s;
  left.damping = damping;
  left.iterations = attempt.iterations;
  left.factorised = !equilibrium.tangent().linear().failed();
  left.finite = std::isfinite(left.total.force) && std::isfinite(left.total.gap);
  if (const Watch* watch = equilibrium.watch()) left.residual = watch->residuals();
  left.state = equilibrium.state(*attempt.z, attempt.s);
  return left;
}

}  // namespace toile::solve
