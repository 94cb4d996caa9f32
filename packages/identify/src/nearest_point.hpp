#pragma once

#include <Eigen/Core>
#include <optional>

namespace toile::identify {

/// G y <= h.
struct Inequalities {
  Eigen::MatrixXd G;  ///< [m][n]
  Eigen::VectorXd h;  ///< [m]
};

/// The point y [n] within the limits that is nearest to `to` [n]: least-distance programming (Lawson and Hanson,
/// Solving Least Squares Problems, 1974, chapter 23). Empty if the limits contradict each other.
std::optional<Eigen::VectorXd> nearest_point(const Eigen::VectorXd& to, Inequalities limits);

}  // namespace toile::identify
