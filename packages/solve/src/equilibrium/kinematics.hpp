#pragma once

#include <vector>

#include "equilibrium/layout.hpp"
#include "terms/configuration.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

/// From the unknowns of a stage to its nodes: what supports prescribe, seams that close, directors that turn.
///
/// Rotations of directors count from their frames at the start of the step.
class Kinematics {
 public:
  Kinematics(const Problem& problem, const Layout& layout, const Drive& drive, const State& start);

  const Drive& drive() const { return drive_; }
  /// At the unknowns z. Collective.
  Configuration at(const Vector& z, double s) const;
  /// Of the master of a cluster, from the unknowns of this rank.
  Vec3 position(int cluster, const double* unknowns, double s) const;

  void start_step(const Configuration& at);

  /// [local node] of the directors at the start of the step; empty without shells.
  const std::vector<Frame>& frames() const { return frames_; }
  /// [local node][2] theta that belongs to them.
  const std::vector<double>& theta() const { return theta_; }
  double step_start() const { return step_start_; }  ///< s there
  /// Sets them, of all nodes of the mesh.
  void resume(double s, const std::vector<Frame>& frames, const std::vector<double>& theta);

  Frame frame(size_t node, const Configuration& at) const;
  /// Axis in space about which the unknown w_k turns a node's director, d_n x t_k. Exact at w = 0 and, for a director
  /// that turns about one axis, at any w.
  Vec3 moment_axis(size_t node, int k) const;

 private:
  std::array<double, 2> held_rotation(size_t node, double load) const;

  const Problem& problem_;
  const Layout& layout_;
  Drive drive_;
  std::vector<Frame> frames_;
  std::vector<double> theta_;
  double step_start_ = 0.0;
};

}  // namespace toile::solve
