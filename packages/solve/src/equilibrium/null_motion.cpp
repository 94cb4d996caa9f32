#include "equilibrium/null_motion.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <sstream>

#include "toile/solve/connected_parts.hpp"

namespace toile::solve {

namespace {

using Motion = Eigen::Matrix<double, 6, 1>;     // translation t, rotation w about `centre`: r = t + w x (x - centre)
using Generator = Eigen::Matrix<double, 3, 6>;  // r at one point, per component of the motion
using Motions = Eigen::Matrix<double, 6, Eigen::Dynamic>;

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
  constexpr double negligible = 1e-3;
  const Vec3 t = motion.head<3>(), w = motion.tail<3>() / length;
  if (w.norm() * length < negligible * t.norm()) return "translation along " + vector_text(t.normalized());
  const double along = t.dot(w) / w.squaredNorm();  // mm per radian
  std::ostringstream name;
  name.precision(3);
  if (std::abs(along) < negligible * length)
    name << "rotation about the axis ";
  else
    name << "screw of " << 2.0 * std::acos(-1.0) * along << " mm per turn about the axis ";
  name << vector_text(w.normalized()) << " through " << vector_text(centre + w.cross(t) / w.squaredNorm());
  return name.str();
}

/// Mean of the cluster's nodes: where its seam touches the body.
Vec3 mean_position(const Problem& problem, const State& state, int cluster) {
  const std::vector<int>& members = problem.clusters[cluster];
  Vec3 mean = Vec3::Zero();
  for (const int n : members) mean += node_position(problem, state, cluster, n) / static_cast<double>(members.size());
  return mean;
}

/// Null motions of one connected part of the garment.
class PartMotions {
 public:
  PartMotions(const Problem& problem, const State& state, const std::vector<int>& clusters);
  void find(const Held& held, bool seams_closed, const std::vector<bool>& guided);
  std::vector<NullMotion> pinned(const Held& held) const;

 private:
  bool resisted_later(const Held& held, const std::vector<bool>& guided) const;
  Eigen::Matrix<double, 6, 6> resistance_of_directors(const Held& held, int cluster) const;
  Generator generator_at(const Vec3& x) const { return generator(x, centre_, length_); }

  const Problem& problem_;
  const State& state_;
  const std::vector<int>& clusters_;
  const std::vector<bool> is_shell_;  ///< [node]
  Vec3 centre_ = Vec3::Zero();
  double length_ = 1.0;
  Motions null_space_;  ///< orthonormal
};

PartMotions::PartMotions(const Problem& problem, const State& state, const std::vector<int>& clusters)
    : problem_(problem), state_(state), clusters_(clusters), is_shell_(shell_nodes(problem)) {
  for (const int c : clusters) centre_ += state.position[c] / static_cast<double>(clusters.size());
  for (const int c : clusters) length_ = std::max(length_, (state.position[c] - centre_).norm());
}

// A clamped director resists the rotations that would turn it.
Eigen::Matrix<double, 6, 6> PartMotions::resistance_of_directors(const Held& held, int cluster) const {
  Eigen::Matrix<double, 6, 6> resistance = Eigen::Matrix<double, 6, 6>::Zero();
  for (const int n : problem_.clusters[cluster])
    for (Eigen::Index k = 0; k < 2 && is_shell_[n]; ++k) {
      if (!held.rotation[n][static_cast<size_t>(k)]) continue;
      Motion turn = Motion::Zero();
      turn.tail<3>() = state_.frame[n].row(2).cross(state_.frame[n].row(k)).transpose();
      resistance += turn * turn.transpose();
    }
  return resistance;
}

void PartMotions::find(const Held& held, bool seams_closed, const std::vector<bool>& guided) {
  Eigen::Matrix<double, 6, 6> resistance = Eigen::Matrix<double, 6, 6>::Zero();
  double scale = 0.0;
  for (const int c : clusters_) {
    const Generator g = generator_at(state_.position[c]);
    scale += g.squaredNorm();
    for (int i = 0; i < 3; ++i) {
      if (!held.position[c][i].held) continue;
      const Motion component = g.transpose() * held.direction(c, i);
      resistance += component * component.transpose();
    }
    if (guided[c]) {
      const Vec3 x = mean_position(problem_, state_, c);
      const Motion normal = generator_at(x).transpose() * problem_.surface->closest(x).normal;
      resistance += normal * normal.transpose();
    }
    for (size_t m = 1; m < problem_.clusters[c].size() && !seams_closed; ++m) {
      const Generator apart = generator_at(node_position(problem_, state_, c, problem_.clusters[c][m])) - g;
      resistance += apart.transpose() * apart;
    }
    if (!held.rotation.empty()) resistance += resistance_of_directors(held, c);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(resistance);
  const auto count = (eigen.eigenvalues().array() <= 1e-9 * scale).count();
  null_space_ = eigen.eigenvectors().leftCols(count);
  if (resisted_later(held, guided)) null_space_.resize(6, 0);
}

// A rotation that moves every held node along what is free there may still meet its supports to the second order, u = v
// + w x v / 2: a quarter of a tube between two planes of symmetry begins to turn about the line where the normals of
// its edges cross. No equilibrium is left by it: loads work on it, and the stress that they make resists it. A pin
// would carry that work.
bool PartMotions::resisted_later(const Held& held, const std::vector<bool>& guided) const {
  constexpr double negligible = 1e-6;
  if (null_space_.cols() != 1) return false;
  const Motion motion = null_space_.col(0) / null_space_.norm();
  const Vec3 w = motion.tail<3>();
  for (const int c : clusters_) {
    if (guided[c]) return false;  // the body's curvature would have to be known
    const Vec3 second = w.cross(Vec3(generator_at(state_.position[c]) * motion));
    for (int i = 0; i < 3; ++i)
      if (held.position[c][i].held && std::abs(held.direction(c, i).dot(second)) > negligible) return true;
  }
  return false;
}

/// Combines the columns so that each has a one where the others have a zero, in three rows from `first`.
void reduce(Eigen::Ref<Motions> motions, Eigen::Index first) {
  std::array<bool, 3> used{};
  for (Eigen::Index k = 0; k < motions.cols(); ++k) {
    Eigen::Index row = -1, column = k;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = k; j < motions.cols() && !used[i]; ++j)
        if (row < 0 || std::abs(motions(first + i, j)) > (1.0 + 1e-9) * std::abs(motions(first + row, column))) {
          row = i;
          column = j;
        }
    used[row] = true;
    motions.col(k).swap(motions.col(column));
    motions.col(k) /= motions(first + row, k);
    for (Eigen::Index j = 0; j < motions.cols(); ++j)
      if (j != k) motions.col(j) -= motions(first + row, j) * motions.col(k);
  }
}

/// The eigenvectors of a multiple zero are any combinations: the translations among them come out alone here, and the
/// rest has no part along them.
Motions readable(const Motions& null_space) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> turning(null_space.bottomRows<3>(), Eigen::ComputeFullV);
  Motions motions = null_space * turning.matrixV();
  const auto rotations = (turning.singularValues().array() > 1e-3).count();
  reduce(motions.leftCols(rotations), 3);
  reduce(motions.rightCols(motions.cols() - rotations), 0);
  return motions;
}

// Each pin sits where what the earlier ones leave of the null space moves most, so that no two hold the same.
std::vector<NullMotion> PartMotions::pinned(const Held& held) const {
  if (null_space_.cols() == 0) return {};
  const Motions motions = readable(null_space_);
  Motions left = null_space_;
  std::vector<NullMotion> found;
  while (left.cols() > 0) {
    NullMotion pin{name_of(motions.col(motions.cols() - left.cols()), centre_, length_), 0, 0};
    double largest = 0.0;
    Eigen::VectorXd held_motion;
    for (const int c : clusters_) {
      const Generator g = generator_at(state_.position[c]);
      for (int i = 0; i < 3; ++i) {
        const Eigen::VectorXd moves = left.transpose() * Motion(g.transpose() * held.direction(c, i));
        if (held.position[c][i].held || moves.norm() <= largest * (1.0 + 1e-9)) continue;
        largest = moves.norm();
        held_motion = moves;
        pin.cluster = c;
        pin.component = i;
      }
    }
    // The Householder reflection that takes the first column to the held motion takes the others to what is left.
    Eigen::VectorXd mirror = held_motion.normalized();
    mirror[0] += mirror[0] < 0.0 ? -1.0 : 1.0;
    const Motion across = left * mirror * (2.0 / mirror.squaredNorm());
    left -= across * mirror.transpose();
    left = left.rightCols(left.cols() - 1).eval();
    found.push_back(pin);
  }
  return found;
}

}  // namespace

std::vector<bool> near_body(const Problem& problem, const State& state) {
  constexpr double touching = 1.0;  // mm
  std::vector<bool> near(problem.clusters.size(), false);
  for (size_t c = 0; c < near.size() && problem.surface != nullptr; ++c) {
    const body::SurfacePoint p = problem.surface->closest(mean_position(problem, state, static_cast<int>(c)));
    near[c] = p.found && std::abs(p.gap - state.offset[c]) < touching;
  }
  return near;
}

std::vector<bool> in_contact(const State& state) {
  std::vector<bool> touches;
  for (const double force : state.contact_force) touches.push_back(force > 0.0);
  return touches;
}

std::vector<NullMotion> find_null_motions(const Problem& problem, const State& state, const Held& held,
                                          bool seams_closed, const std::vector<bool>& guided) {
  std::vector<NullMotion> all;
  for (const std::vector<int>& clusters : connected_parts(problem)) {
    PartMotions part(problem, state, clusters);
    part.find(held, seams_closed, guided);
    for (const NullMotion& motion : part.pinned(held)) all.push_back(motion);
  }
  return all;
}

}  // namespace toile::solve
