#pragma once

#include <vector>

#include "equilibrium/kinematics.hpp"
#include "terms/term.hpp"

namespace toile::solve {

/// Forces and moments that keep their direction in space; a moment turns the director of a shell's node.
class DeadLoad : public Term {
 public:
  DeadLoad(const Problem& problem, const Layout& layout, const Kinematics& kinematics);

  void add(const Configuration& at, Forces& forces, double* tangent) override;
  double potential(const Configuration& at, const Configuration& held) override;
  /// Sum of the components of the owned nodes' moments at load 1, N mm.
  double moments() const;

 private:
  const Layout& layout_;
  const Kinematics& kinematics_;
  std::vector<double> force_;  ///< [local cluster][3] at load 1, N
  std::vector<Vec3> moment_;   ///< [local node] at load 1, N mm; empty without shells
};

}  // namespace toile::solve
