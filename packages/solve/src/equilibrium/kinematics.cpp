#include "equilibrium/kinematics.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace toile::solve {

Kinematics::Kinematics(const Problem& problem, const Layout& layout, const Drive& drive, const State& start)
    : problem_(problem), layout_(layout), drive_(drive) {
  if (!layout.has_shells()) return;
  for (const int node : layout.nodes) {
    frames_.push_back(start.frame[node]);
    theta_.insert(theta_.end(), start.rotation[node].begin(), start.rotation[node].end());
  }
}

Vec3 Kinematics::position(int c, const double* unknowns, double s) const {
  Vec3 components;
  for (int i = 0; i < 3; ++i) {
    const HeldComponent& h = layout_.held[c][i];
    const double load = drive_.load(s);
    components[i] = !h.held ? unknowns[layout_.dof[c][i]]
                            : h.position(h.support < 0 ? load : problem_.supports[h.support].path.share(load));
  }
  return layout_.position(c, components);
}

Configuration Kinematics::at(const Vector& z, double s) const {
  const RCP<const Vector> owned = z.offsetView(layout_.maps.dof, 0)->getVector(0);
  Vector overlap(layout_.maps.overlap);
  overlap.doImport(*owned, *layout_.maps.importer, Tpetra::INSERT);
  const auto data = overlap.getData();
  Configuration at;
  at.s = s;
  at.load = drive_.load(s);
  at.opening = 1.0 - drive_.seam(s);
  at.master.resize(3 * layout_.clusters.size());
  for (size_t c = 0; c < layout_.clusters.size(); ++c) {
    const Vec3 y = position(static_cast<int>(c), data.getRawPtr(), s);
    std::copy_n(y.data(), 3, &at.master[3 * c]);
  }
  at.x.resize(3 * layout_.nodes.size());
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    const size_t c = static_cast<size_t>(layout_.node_cluster[n]);
    const int master = problem_.clusters[layout_.clusters[c]].front();
    const std::vector<Vec3>& placed = problem_.mesh->placed;
    const Vec3 p = at.position(c) + at.opening * (placed[layout_.nodes[n]] - placed[master]);
    std::copy_n(p.data(), 3, &at.x[3 * n]);
  }
  at.rotation.resize(2 * layout_.rotation.size());
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    const std::array<double, 2> held = held_rotation(n, at.load);
    for (size_t k = 0; k < 2; ++k) {
      const LocalId d = layout_.rotation[n][k];
      at.rotation[2 * n + k] = d >= 0 ? data[d] - theta_[2 * n + k] : held[k];
    }
  }
  const auto all = z.getData();
  const size_t first = layout_.maps.dof->getNodeNumElements();
  at.multiplier.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  return at;
}

// Of a held director since the start of the step: none, unless its clamp turns.
std::array<double, 2> Kinematics::held_rotation(size_t node, double load) const {
  const int support = layout_.turned_by.empty() ? -1 : layout_.turned_by[node];
  if (support < 0) return {0.0, 0.0};
  const Support& clamp = problem_.supports[static_cast<size_t>(support)];
  const double since = clamp.path.share(load) - clamp.path.share(drive_.load(step_start_));
  const Vec3 before = frames_[node].row(2);
  return rotation_to(frames_[node], Eigen::AngleAxisd(since * clamp.turn->angle, clamp.turn->axis) * before);
}

void Kinematics::start_step(const Configuration& at) {
  step_start_ = at.s;
  for (size_t n = 0; n < frames_.size(); ++n) {
    frames_[n] = frame(n, at);
    for (size_t k = 0; k < 2; ++k) theta_[2 * n + k] += at.rotation[2 * n + k];
  }
}

void Kinematics::resume(double s, const std::vector<Frame>& frames, const std::vector<double>& theta) {
  step_start_ = s;
  for (size_t n = 0; n < frames_.size(); ++n) {
    const size_t node = static_cast<size_t>(layout_.nodes[n]);
    frames_[n] = frames[node];
    std::copy_n(&theta[2 * node], 2, &theta_[2 * n]);
  }
}

Frame Kinematics::frame(size_t node, const Configuration& at) const {
  return rotated(frames_[node], at.rotation[2 * node], at.rotation[2 * node + 1]);
}

Vec3 Kinematics::moment_axis(size_t node, int k) const {
  const Frame& frame = frames_[node];
  return frame.row(2).transpose().cross(frame.row(k).transpose());
}

}  // namespace toile::solve
