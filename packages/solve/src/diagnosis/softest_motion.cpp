#include "diagnosis/softest_motion.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace toile::solve {

namespace {

/// [3 clusters] of a vector of the unknowns without multipliers.
std::vector<double> motions(const Layout& layout, const Vector& x, size_t clusters) {
  std::vector<double> mine(3 * clusters, 0.0), all(mine.size());
  const auto data = x.getData();
  for (int c = 0; c < layout.owned_clusters; ++c) {
    Vec3 components = Vec3::Zero();
    for (size_t d = 0; d < 3; ++d)
      if (layout.dof[c][d] >= 0) components[static_cast<Eigen::Index>(d)] = data[layout.dof[c][d]];
    const Vec3 motion = layout.position(c, components);
    std::copy_n(motion.data(), 3, &mine[3 * static_cast<size_t>(layout.clusters[c])]);
  }
  Teuchos::reduceAll(*layout.comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  return all;
}

}  // namespace

SoftestMotion softest_motion(Equilibrium& equilibrium, const Attempt& attempt, size_t clusters) {
  const double damping = equilibrium.damping();
  equilibrium.set_damping(0.0);
  Tangent& tangent = equilibrium.tangent();
  tangent.renew();
  equilibrium.linearise(*attempt.z, attempt.s);
  const RCP<Vector> x = tangent.softest();
  equilibrium.set_damping(damping);
  tangent.renew();
  SoftestMotion softest;
  if (x.is_null()) return softest;
  softest.stiffness = tangent.stiffness_along(*x) / std::abs(equilibrium.measures().stiffness);
  const std::vector<double> all = motions(equilibrium.layout(), *x, clusters);
  double furthest = 0.0;
  for (size_t c = 0; c < clusters; ++c) {
    const Vec3 motion(&all[3 * c]);
    if (motion.norm() <= furthest * (1.0 + 1e-6)) continue;  // of equals the first, on any number of ranks
    furthest = motion.norm();
    softest.cluster = c;
    softest.direction = motion / furthest;
  }
  softest.found = furthest > 0.0;
  Eigen::Index largest = 0;
  softest.direction.cwiseAbs().maxCoeff(&largest);
  if (softest.direction[largest] < 0.0) softest.direction *= -1.0;  // both senses are the same motion
  return softest;
}

}  // namespace toile::solve
