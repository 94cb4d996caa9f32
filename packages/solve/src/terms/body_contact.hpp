#pragma once

#include <vector>

#include "equilibrium/contact_projection.hpp"
#include "equilibrium/diagonal.hpp"
#include "equilibrium/kinematics.hpp"
#include "terms/term.hpp"
#include "toile/contact/law.hpp"

namespace toile::solve {

/// Contact of the garment with the rigid body, one condition and one multiplier a cluster, by the scene's law.
class BodyContact : public Term {
 public:
  BodyContact(const Problem& problem, const Layout& layout, const Graph& graph, const Diagonal& diagonal,
              const Kinematics& kinematics, const State& start);

  /// With a tangent, the conditions that are active here become those of the projection. Collective then.
  void add(const Configuration& at, Forces& forces, double* tangent) override;
  double potential(const Configuration& at, const Configuration& held) override;
  void end_step(const Configuration& at) override { history_ = history_after(at); }
  void start_step(const Configuration& at) override;

  /// The active conditions of the last tangent, which are not in it.
  const ContactProjection& projection() const { return projection_; }
  /// Augmentation, N/mm; to be set before anything is asked.
  void set_stiffness(double stiffness) { stiffness_ = stiffness; }
  double stiffness() const { return stiffness_; }

  /// [owned cluster] of the contact surface inside the mid-surface, mm.
  const std::vector<double>& offsets() const { return offset_; }
  void set_offsets(const std::vector<double>& offsets) { offset_ = offsets; }

  /// Puts the clusters of the last tangent's conditions back onto the surface, along their normal. False: this rank has
  /// none of them.
  bool retract(Vector& z, double s) const;
  /// Multipliers that balance `forces` at touching clusters, which are put onto the surface if they press it with more
  /// than `least` (N).
  void balance(const Configuration& at, const Forces& forces, double least, Vector& z) const;

  /// [owned cluster] N; what the iteration leaves on a cluster that hovers is round-off, not a force.
  std::vector<double> pressing_forces(const Configuration& at) const;
  /// [owned cluster][contact::Law::history_values] what the law keeps of the steps before this one, and what it keeps
  /// if this one ends here.
  const std::vector<double>& history() const { return history_; }
  std::vector<double> history_after(const Configuration& at) const;
  /// What the equations of a step remember: normals of the active conditions, offsets and history, of all clusters.
  void resume(const std::vector<Vec3>& normals, const std::vector<double>& offsets, const std::vector<double>& history);

 private:
  /// What the body said of a point: an iteration asks for the same one several times.
  struct Known {
    bool asked = false;
    Vec3 point = Vec3::Zero();
    body::SurfacePoint surface;
  };

  contact::NodeContact contact(size_t cluster, const Vec3& position, double opening, double multiplier) const;
  contact::Touch touch(size_t cluster, const Vec3& position, double opening, double multiplier) const;
  const body::SurfacePoint& surface_at(size_t cluster, const Vec3& point) const;
  bool is_far(size_t cluster, const Vec3& point, double multiplier) const;
  double length_of_free_part(size_t cluster, const Vec3& direction) const;
  void retract_cluster(size_t cluster, double s, double* z) const;
  void find_open_seams();
  size_t size() const { return offset_.size(); }

  const Problem& problem_;
  const Layout& layout_;
  const Diagonal& diagonal_;
  const Kinematics& kinematics_;
  const contact::Law& law_;
  ContactProjection projection_;
  double stiffness_ = 1.0;
  std::vector<double> offset_;         ///< [owned cluster] mm
  std::vector<Vec3> mean_separation_;  ///< [owned cluster] of the placed nodes from their master, mm
  std::vector<double> placed_depth_;   ///< [owned cluster] depth of that mean inside the body when placed, mm <= 0
  std::vector<Vec3> step_start_;       ///< [owned cluster] of its position, mm; empty if the law does not follow steps
  std::vector<double> history_;        ///< [owned cluster][value]
  mutable std::vector<Known> known_;   ///< [owned cluster] of the last place that was asked for
};

}  // namespace toile::solve
