#include "nearest_point.hpp"

#include <Eigen/QR>
#include <vector>

namespace toile::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double roundoff = 1e-13;

/// The least |E u - f| over u >= 0: the active-set method of Lawson and Hanson, chapter 23, algorithm NNLS.
VectorXd non_negative_least_squares(const MatrixXd& E, const VectorXd& f) {
  const Index m = E.cols();
  VectorXd u = VectorXd::Zero(m);
  std::vector<Index> positive;
  std::vector<bool> refused(static_cast<std::size_t>(m), false);
  const Index most_changes = 10 * m;
  for (Index change = 0; change < most_changes; ++change) {
    const VectorXd slope = E.transpose() * (f - E * u);
    Index next = -1;
    for (Index i = 0; i < m; ++i)
      if (u[i] == 0.0 && !refused[static_cast<std::size_t>(i)] && slope[i] > roundoff &&
          (next < 0 || slope[i] > slope[next]))
        next = i;
    if (next < 0) break;
    positive.push_back(next);
    for (bool is_first = true; !positive.empty(); is_first = false) {
      const VectorXd wanted = E(Eigen::all, positive).colPivHouseholderQr().solve(f);
      // A column that is a combination of the others brings no gain.
      if (is_first && wanted[wanted.size() - 1] <= 0.0) {
        refused[static_cast<std::size_t>(next)] = true;
        positive.pop_back();
        break;
      }
      double part = 1.0;
      for (std::size_t k = 0; k < positive.size(); ++k) {
        const double now = u[positive[k]], then = wanted[static_cast<Index>(k)];
        if (then <= 0.0) part = std::min(part, now / (now - then));
      }
      std::vector<Index> kept;
      for (std::size_t k = 0; k < positive.size(); ++k) {
        double& value = u[positive[k]];
        value += part * (wanted[static_cast<Index>(k)] - value);
        if (wanted[static_cast<Index>(k)] <= 0.0 && value <= roundoff) value = 0.0;
        if (value > 0.0) kept.push_back(positive[k]);
      }
      const bool is_done = kept.size() == positive.size();
      positive = kept;
      if (is_done) {
        refused.assign(refused.size(), false);
        break;
      }
    }
  }
  return u;
}

}  // namespace

std::optional<VectorXd> nearest_point(const VectorXd& to, Inequalities limits) {
  // Distances beyond the limits, of unit normals, over the largest of them.
  VectorXd excess = limits.G * to - limits.h;
  if ((excess.array() <= 0.0).all()) return to;
  for (Index i = 0; i < excess.size(); ++i) {
    const double size = limits.G.row(i).norm();
    if (size == 0.0) continue;
    limits.G.row(i) /= size;
    excess[i] /= size;
  }
  const double unit = excess.maxCoeff();
  excess /= unit;
  const Index n = to.size();
  MatrixXd E(n + 1, excess.size());
  E.topRows(n) = -limits.G.transpose();
  E.row(n) = excess.transpose();
  VectorXd f = VectorXd::Zero(n + 1);
  f[n] = 1.0;
  const VectorXd rest = E * non_negative_least_squares(E, f) - f;
  if (std::abs(rest[n]) <= roundoff) return std::nullopt;
  return to - unit / rest[n] * rest.head(n);
}

}  // namespace toile::identify
