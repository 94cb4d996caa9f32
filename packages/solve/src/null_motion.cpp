#include "null_motion.hpp"

#include <Eigen/Geometry>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>

namespace toile::solve {

namespace {

using Motion = Eigen::Matrix<double, 6, 1>;     // translation t, rotation w about `centre`: r = t + w x (x - centre)
using Generator = Eigen::Matrix<double, 3, 6>;  // r at one point, per component of the motion

Generator generator(const Vec3& x, const Vec3& centre, double length) {
  Generator g;
  const Vec3 a = (x - centre) / length;
  g.leftCols<3>().setIdentity();
  g.rightCols<3>() << 0, a[2], -a[1], -a[2], 0, a[0], a[1], -a[0], 0;
  return g;
}

std::string vector_text(const Vec3& v) {
  std::ostringstream out;
  out.precision(3);
  const auto clean = [](double x) { return std::abs(x) < 1e-3 ? 0.0 : x; };
  out << "(" << clean(v[0]) << ", " << clean(v[1]) << ", " << clean(v[2]) << ")";
  return out.str();
}

std::string name_of(const Motion& motion, const Vec3& centre, double length) {
  const Vec3 t = motion.head<3>(), w = motion.tail<3>() / length;
  if (w.norm() * length < 1e-3 * t.norm()) return "translation along " + vector_text(t.normalized());
  const Vec3 through = centre + w.cross(t) / w.squaredNorm();
  Eigen::Index largest = 0;
  w.cwiseAbs().maxCoeff(&largest);
  return "rotation about the axis " + vector_text(w.normalized() * (w[largest] < 0.0 ? -1.0 : 1.0)) + " through " +
         vector_text(through);
}

}  // namespace

std::vector<NullMotion> find_null_motions(const Problem& problem, const State& state,
                                          const Held& held, bool seams_closed) {
  constexpr double touching = 1.0;  // mm: nodes this near count as guided by the body
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : state.position) centre += p / static_cast<double>(state.position.size());
  double length = 1.0;
  for (const Vec3& p : state.position) length = std::max(length, (p - centre).norm());

  Eigen::Matrix<double, 6, 6> resistance = Eigen::Matrix<double, 6, 6>::Zero();
  double scale = 0.0;
  const std::vector<bool> is_shell = shell_nodes(problem);
  for (size_t c = 0; c < state.position.size(); ++c) {
    const Vec3& x = state.position[c];
    const Generator g = generator(x, centre, length);
    scale += g.squaredNorm();
    for (int i = 0; i < 3; ++i)
      if (held.position[c][i].held) resistance += g.row(i).transpose() * g.row(i);
    if (problem.surface != nullptr) {
      const body::SurfacePoint p = problem.surface->closest(x);
      if (p.found && std::abs(p.gap - state.offset[c]) < touching) {
        const Motion normal = g.transpose() * p.normal;
        resistance += normal * normal.transpose();
      }
    }
    for (size_t m = 1; m < problem.clusters[c].size() && !seams_closed; ++m) {
      const Generator apart =
          generator(node_position(problem, state, static_cast<int>(c), problem.clusters[c][m]), centre, length) - g;
      resistance += apart.transpose() * apart;
    }
  }

  // A clamped director resists the rotations that would turn it.
  for (size_t n = 0; n < state.frame.size(); ++n)
    for (Eigen::Index k = 0; k < 2; ++k) {
      if (!is_shell[n] || !held.rotation[n][static_cast<size_t>(k)]) continue;
      Motion turn = Motion::Zero();
      turn.tail<3>() = state.frame[n].row(2).cross(state.frame[n].row(k)).transpose();
      resistance += turn * turn.transpose();
    }

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(resistance);
  std::vector<NullMotion> motions;
  std::vector<std::array<bool, 3>> taken(state.position.size(), {false, false, false});
  for (int k = 0; k < 6; ++k) {
    if (eigen.eigenvalues()[k] > 1e-9 * scale) continue;
    const Motion motion = eigen.eigenvectors().col(k);
    NullMotion found{name_of(motion, centre, length), 0, 0};
    double largest = 0.0;
    for (size_t c = 0; c < state.position.size(); ++c) {
      const Vec3 r = generator(state.position[c], centre, length) * motion;
      for (int i = 0; i < 3; ++i)
        if (!taken[c][i] && !held.position[c][i].held && std::abs(r[i]) > largest * (1.0 + 1e-9)) {
          largest = std::abs(r[i]);
          found.cluster = static_cast<int>(c);
          found.component = i;
        }
    }
    taken[found.cluster][found.component] = true;
    motions.push_back(found);
  }
  return motions;
}

}  // namespace toile::solve
