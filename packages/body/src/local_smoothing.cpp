#include "local_smoothing.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "spline_field.hpp"

namespace toile::body {
namespace {

/// Largest smoothing length, in cells, times the square of the angle by which normals stray within a cell and its
/// neighbours, where edges have their mean length. Measured on a real body: with the double the error in the crotch is
/// doubled; with the angle itself instead of its square facets of the thigh show.
constexpr double length_by_bend = 0.065;
constexpr double least_smoothing = 1e-3;  ///< against the modes that no vertex sees

/// Sums over the samples near a cell.
struct Sums {
  Vec3 normals = Vec3::Zero(), points = Vec3::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  ///< of points and normals
  double edges = 0.0;
  double weight = 0.0;

  void add(double share, const Sums& other) {
    normals += share * other.normals;
    points += share * other.points;
    products += share * other.products;
    edges += share * other.edges;
    weight += share * other.weight;
  }
  /// In some direction normals turn towards each other: a fold or a saddle, not a ridge or a tip.
  bool is_concave() const {
    constexpr double clearly = 0.01;
    const Eigen::Matrix3d turning = weight * products - points * normals.transpose();
    const Eigen::Vector3d along =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(turning + turning.transpose(), Eigen::EigenvaluesOnly)
            .eigenvalues();
    return along[0] < -clearly * along.cwiseAbs().maxCoeff();
  }
};

/// Calls visit(unknown, value of its spline) at a place in a cell, t in [0, 1]^3.
template <class Visit>
void for_splines(const SheetGrid::Cell& cell, const Vec3& t, const Visit& visit) {
  const Eigen::Matrix4d x = cubic_splines(t[0]), y = cubic_splines(t[1]), z = cubic_splines(t[2]);
  for (int n = 0; n < 64; ++n) {
    visit(cell.unknowns[n], x(0, n / 16) * y(0, n / 4 % 4) * z(0, n % 4));
  }
}

std::vector<Sums> sums_at_nodes(const SheetGrid& grid, const SurfaceSamples& samples) {
  std::vector<Sums> nodes(grid.unknowns());
  for (int s = 0; s < samples.size(); ++s) {
    const Vec3 local = grid.local(samples.points[s]);
    const int at = grid.cell_of(local, s);
    if (at < 0) continue;  // a vertex that no triangle uses
    const auto& cell = grid.cells()[at];
    for_splines(cell, local - Vec3(cell.at[0], cell.at[1], cell.at[2]), [&](int unknown, double weight) {
      nodes[unknown].add(
          weight, {samples.normals[s], local, local * samples.normals[s].transpose(), samples.edge_lengths[s], 1.0});
    });
  }
  return nodes;
}

}  // namespace

std::vector<double> local_smoothing(const SheetGrid& grid, const SurfaceSamples& samples, double mean_edge,
                                    double smoothing) {
  const std::vector<Sums> nodes = sums_at_nodes(grid, samples);
  std::vector<double> result;
  result.reserve(grid.cells().size());
  for (const auto& cell : grid.cells()) {
    Sums sums;
    for_splines(cell, Vec3::Constant(0.5), [&](int unknown, double weight) { sums.add(weight, nodes[unknown]); });
    if (!sums.is_concave()) {
      result.push_back(smoothing);
      continue;
    }
    // The mean of unit vectors that stray by small angles a from each other is shorter by a^2/2.
    const double bend = std::sqrt(2.0 * std::max(0.0, 1.0 - sums.normals.norm() / sums.weight));
    const double fineness = std::sqrt(sums.edges / sums.weight / mean_edge);
    const double length = length_by_bend * fineness / std::max(bend * bend, 1e-6);
    result.push_back(std::clamp(std::pow(length, 6) / 3.0, std::min(least_smoothing, smoothing), smoothing));
  }
  return result;
}

}  // namespace toile::body
