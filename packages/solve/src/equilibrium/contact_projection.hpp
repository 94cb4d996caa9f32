#pragma once

#include <cstdint>
#include <vector>

#include "equilibrium/layout.hpp"

namespace toile::solve {

/// The active contact conditions n.dx = given, eliminated from the tangent's system without a penalty.
///
/// With P = I - n n^T on every cluster in contact (n: the body's normal in the free components, of unit length there)
/// the system P K P + k n n^T, k a stiffness of K's size, moves the clusters along the surface only. It is as well
/// conditioned as K, positive definite where K is so along the surface, and its negative pivots are those of the
/// constrained problem.
class ContactProjection {
 public:
  /// Least length of a unit normal's part in the free components; with less, the cluster cannot be moved along it.
  static constexpr double tangential = 1e-3;

  /// The graph's columns of the position of one cluster follow one another (Layout numbers them so).
  ContactProjection(const Layout& layout, const Graph& graph);

  /// Sets the conditions: one normal per owned cluster, zero where there is none. Collective.
  void set(const std::vector<Vec3>& normals);

  bool active(int cluster) const { return active_[cluster]; }
  /// Length of the normal's part in the free components, as it was set, of an owned cluster.
  double free_part(int cluster) const { return free_part_[static_cast<size_t>(cluster)]; }
  /// Unit normal in the free components of an owned cluster, zero where no condition is active.
  const Vec3& normal(int cluster) const { return normal_[cluster]; }

  /// to = P from P + stiffness n n^T, both on the graph.
  void project(const Matrix& from, double stiffness, Matrix& to) const;
  /// v <- P v.
  void project(Vector& v) const;
  /// Sum over components of an owned cluster: normal . v.
  double component(const Vector& v, int cluster) const;
  /// v <- v + value * normal of an owned cluster.
  void add(Vector& v, int cluster, double value) const;

 private:
  int component_of(LocalId dof, int cluster) const;

  const Layout& layout_;
  std::vector<Vec3> normal_;         ///< [local cluster]
  std::vector<char> active_;         ///< [local cluster]
  std::vector<double> free_part_;    ///< [owned cluster]
  std::vector<int> cluster_of_dof_;  ///< -1: a rotation, which contact does not see
};

}  // namespace toile::solve
