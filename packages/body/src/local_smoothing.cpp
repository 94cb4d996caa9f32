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
/// Radians by which normals turn towards each other from one cell to the next, averaged over four: more is too narrow a
/// fold. Above it lie the bottoms of armpit, crotch and clefts of a real body, below it its other hollows.
constexpr double most_hollow = 0.5;

/// Sums over the samples near a cell.
struct Sums {
  Vec3 normals = Vec3::Zero(), points = Vec3::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  ///< of points and normals
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();   ///< of points
  double edges = 0.0;
  double weight = 0.0;

  void add(double share, const Sums& other) {
    normals += share * other.normals;
    points += share * other.points;
    products += share * other.products;
    squares += share * other.squares;
    edges += share * other.edges;
    weight += share * other.weight;
  }
  /// By how much normals turn towards each other, radians a cell: a fold or a saddle, not a ridge or a tip; 0: nowhere.
  double hollowness() const {
    constexpr double clearly = 0.01;
    const Eigen::Matrix3d turning = weight * products - points * normals.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> turn(turning + turning.transpose());
    if (turn.eigenvalues()[0] >= -clearly * turn.eigenvalues().cwiseAbs().maxCoeff()) return 0.0;
    const Vec3 across = turn.eigenvectors().col(0);
    const double spread = across.dot((weight * squares - points * points.transpose()) * across);
    return -0.5 * turn.eigenvalues()[0] / spread;
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
      nodes[unknown].add(weight, {samples.normals[s], local, local * samples.normals[s].transpose(),
                                  local * local.transpose(), samples.edge_lengths[s], 1.0});
    });
  }
  return nodes;
}

}  // namespace

LocalSmoothing local_smoothing(const SheetGrid& grid, const SurfaceSamples& samples, double mean_edge,
                               double smoothing) {
  const std::vector<Sums> nodes = sums_at_nodes(grid, samples);
  const std::size_t cells = grid.cells().size();
  LocalSmoothing result{std::vector<double>(cells, smoothing), std::vector<char>(cells, 0)};
  for (std::size_t c = 0; c < cells; ++c) {
    Sums sums;
    for_splines(grid.cells()[c], Vec3::Constant(0.5),
                [&](int unknown, double weight) { sums.add(weight, nodes[unknown]); });
    const double hollowness = sums.hollowness();
    if (hollowness == 0.0) continue;
    // The mean of unit vectors that stray by small angles a from each other is shorter by a^2/2.
    const double bend = std::sqrt(2.0 * std::max(0.0, 1.0 - sums.normals.norm() / sums.weight));
    const double fineness = std::sqrt(sums.edges / sums.weight / mean_edge);
    const double length = length_by_bend * fineness / std::max(bend * bend, 1e-6);
    result.weights[c] = std::clamp(std::pow(length, 6) / 3.0, std::min(least_smoothing, smoothing), smoothing);
    result.narrow[c] = hollowness > most_hollow ? 1 : 0;
  }
  return result;
}

}  // namespace toile::body
