#include "terms/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::solve {

BodyContact::BodyContact(const Problem& problem, const Layout& layout, const Graph& graph, const Diagonal& diagonal,
                         const Kinematics& kinematics, const State& start)
    : problem_(problem),
      layout_(layout),
      diagonal_(diagonal),
      kinematics_(kinematics),
      law_(*problem.contact.law),
      projection_(layout, graph) {
  const size_t values = static_cast<size_t>(law_.history_values());
  for (int c = 0; c < layout.owned_clusters; ++c) {
    offset_.push_back(start.offset[layout.clusters[c]]);
    for (size_t k = 0; k < values; ++k) {
      const size_t place = values * static_cast<size_t>(layout.clusters[c]) + k;
      history_.push_back(start.contact_history.empty() ? 0.0 : start.contact_history[place]);
    }
  }
  known_.resize(size());
  find_open_seams();
}

const body::SurfacePoint& BodyContact::surface_at(size_t c, const Vec3& point) const {
  Known& known = known_[c];
  if (known.asked && known.point == point) return known.surface;
  known = {true, point, problem_.surface->closest(point)};
  return known.surface;
}

// The distance to the body changes no faster than the point moves (twice as fast leaves room for a surface that is not
// quite a distance): a point that was far is asked for again only where it may have come near.
bool BodyContact::is_far(size_t c, const Vec3& point, double multiplier) const {
  constexpr double margin = 1.0;  // mm
  const Known& known = known_[c];
  if (!known.asked) return false;
  const double least = known.surface.gap - 2.0 * (point - known.point).norm() - margin;
  return least > 0.0 && multiplier < stiffness_ * (least - offset_[c]);
}

// An open seam touches the body at the mean of its nodes. When placed, that mean lies inside the body by the sagitta of
// the opening's chord, which fades with the square of the opening; at closing the condition is exact.
void BodyContact::find_open_seams() {
  mean_separation_.assign(size(), Vec3::Zero());
  placed_depth_.assign(size(), 0.0);
  for (size_t c = 0; c < size(); ++c) {
    const std::vector<int>& members = problem_.clusters[layout_.clusters[c]];
    if (members.size() == 1) continue;
    const Vec3& master = problem_.mesh->placed[members.front()];
    for (const int n : members)
      mean_separation_[c] += (problem_.mesh->placed[n] - master) / static_cast<double>(members.size());
    placed_depth_[c] = std::min(0.0, problem_.surface->closest(master + mean_separation_[c]).gap);
  }
}

double BodyContact::length_of_free_part(size_t cluster, const Vec3& direction) const {
  const int c = static_cast<int>(cluster);
  const Vec3 part = layout_.components_of_force(c, direction);
  double squared = 0.0;
  for (int d = 0; d < 3; ++d)
    if (layout_.dof[c][d] >= 0) squared += part[d] * part[d];
  return std::sqrt(squared);
}

contact::Touch BodyContact::touch(size_t c, const Vec3& position, double opening, double multiplier) const {
  contact::Touch touch;
  touch.surface = surface_at(c, position + opening * mean_separation_[c]);
  touch.offset = offset_[c] + opening * opening * placed_depth_[c];
  touch.multiplier = multiplier;
  touch.stiffness = stiffness_;
  if (!step_start_.empty()) touch.step = position - step_start_[c];
  if (!history_.empty()) touch.history = &history_[c * static_cast<size_t>(law_.history_values())];
  return touch;
}

contact::NodeContact BodyContact::contact(size_t c, const Vec3& position, double opening, double multiplier) const {
  contact::NodeContact held;  // its support carries it, wherever it lies
  held.complementarity = multiplier / stiffness_;
  const std::array<LocalId, 3>& dof = layout_.dof[c];
  if (std::all_of(dof.begin(), dof.end(), [](LocalId d) { return d < 0; })) return held;
  if (is_far(c, position + opening * mean_separation_[c], multiplier)) {
    contact::NodeContact far = held;
    far.energy = -0.5 * multiplier * multiplier / stiffness_;
    far.gap = std::numeric_limits<double>::infinity();
    return far;
  }
  const contact::NodeContact free = law_.evaluate(touch(c, position, opening, multiplier));
  return length_of_free_part(c, free.normal) < ContactProjection::tangential * free.normal.norm() ? held : free;
}

// The tangent has the curvature of the body under the contact forces, and what a law does along the surface.
void BodyContact::add(const Configuration& at, Forces& forces, double* tangent) {
  std::vector<Vec3> normals(tangent == nullptr ? 0 : size(), Vec3::Zero());
  forces.gap.resize(size());
  for (size_t c = 0; c < size(); ++c) {
    const contact::NodeContact here = contact(c, at.position(c), at.opening, at.multiplier[c]);
    for (size_t d = 0; d < 3; ++d) forces.force[3 * c + d] += here.residual[static_cast<Eigen::Index>(d)];
    forces.gap[c] = here.complementarity;
    if (tangent == nullptr || !here.active) continue;
    normals[c] = layout_.components_of_force(static_cast<int>(c), here.normal);
    diagonal_.add(c, here.tangent, tangent);
  }
  if (tangent != nullptr) projection_.set(normals);
}

double BodyContact::potential(const Configuration& at, const Configuration& held) {
  double total = 0.0;
  for (size_t c = 0; c < size(); ++c) total += contact(c, at.position(c), at.opening, held.multiplier[c]).energy;
  return total;
}

void BodyContact::start_step(const Configuration& at) {
  if (!law_.follows_steps()) return;
  step_start_.clear();
  for (size_t c = 0; c < size(); ++c) step_start_.push_back(at.position(c));
}

std::vector<double> BodyContact::history_after(const Configuration& at) const {
  std::vector<double> history = history_;
  const size_t values = static_cast<size_t>(law_.history_values());
  for (size_t c = 0; c < size() && values > 0; ++c)
    law_.end_step(touch(c, at.position(c), at.opening, at.multiplier[c]), &history[c * values]);
  return history;
}

void BodyContact::resume(const std::vector<Vec3>& normals, const std::vector<double>& offsets,
                         const std::vector<double>& history) {
  const size_t values = static_cast<size_t>(law_.history_values());
  std::vector<Vec3> own;
  for (size_t c = 0; c < size(); ++c) {
    const size_t global = static_cast<size_t>(layout_.clusters[c]);
    own.push_back(normals[global]);
    offset_[c] = offsets[global];
    std::copy_n(&history[global * values], values, &history_[c * values]);
  }
  projection_.set(own);
}

bool BodyContact::retract(Vector& z, double s) const {
  auto data = z.getDataNonConst();
  bool any = false;
  for (size_t c = 0; c < size(); ++c) {
    if (!projection_.active(static_cast<int>(c))) continue;
    retract_cluster(c, s, data.getRawPtr());
    any = true;
  }
  return any;
}

void BodyContact::retract_cluster(size_t cluster, double s, double* z) const {
  constexpr int rounds = 3;         // the gap's error falls by its square
  constexpr double closed = 1e-13;  // mm
  const int c = static_cast<int>(cluster);
  const double opening = 1.0 - kinematics_.drive().seam(s);
  for (int round = 0; round < rounds; ++round) {
    const contact::NodeContact at = contact(cluster, kinematics_.position(c, z, s), opening, 0.0);
    if (std::abs(at.gap) < closed) return;
    const double free = length_of_free_part(cluster, at.normal);
    if (free < ContactProjection::tangential) return;
    const Vec3 normal = layout_.components_of_force(c, at.normal);
    for (int d = 0; d < 3; ++d)
      if (layout_.dof[c][d] >= 0) z[layout_.dof[c][d]] -= at.gap * normal[d] / (free * free);
  }
}

void BodyContact::balance(const Configuration& at, const Forces& forces, double least, Vector& z) const {
  constexpr double touching = 2.0;  // mm: placed nodes this near are taken to lie on the body
  auto data = z.getDataNonConst();
  const size_t first = layout_.maps.dof->getNodeNumElements();
  for (size_t c = 0; c < size(); ++c) {
    const Vec3 internal(forces.force[3 * c], forces.force[3 * c + 1], forces.force[3 * c + 2]);
    const contact::NodeContact here = contact(c, at.position(c), at.opening, 0.0);
    const double multiplier = contact::balancing_multiplier(here, internal, touching);
    data[first + c] = multiplier > least ? multiplier : 0.0;
    if (data[first + c] > 0.0) retract_cluster(c, at.s, data.getRawPtr());
  }
}

std::vector<double> BodyContact::pressing_forces(const Configuration& at) const {
  std::vector<double> forces;
  for (size_t c = 0; c < size(); ++c)
    forces.push_back(contact(c, at.position(c), at.opening, at.multiplier[c]).active ? at.multiplier[c] : 0.0);
  return forces;
}

}  // namespace toile::solve
