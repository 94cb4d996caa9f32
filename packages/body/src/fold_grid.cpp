#include "fold_grid.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace toile::body {
namespace {

/// Round a narrow cell, in cells of the whole body: all splines that the narrow cell sees then are free.
constexpr int margin = 2;
/// Round that, facets whose cells are seen by splines that reach into the folds; they hold these at zero.
constexpr int rim = 2;

using Positions = std::set<SheetGrid::Position>;

/// Positions at most `layers` from the given ones, in each direction.
Positions grown(Positions positions, int layers) {
  for (int axis = 0; axis < 3; ++axis) {
    Positions wider;
    for (SheetGrid::Position p : positions) {
      p[axis] -= layers;
      for (int step = -layers; step <= layers; ++step, ++p[axis]) wider.insert(p);
    }
    positions = std::move(wider);
  }
  return positions;
}

Positions narrow_positions(const SheetGrid& whole, const std::vector<char>& narrow) {
  Positions result;
  for (std::size_t c = 0; c < narrow.size(); ++c) {
    if (narrow[c] != 0) result.insert(whole.cells()[c].at);
  }
  return result;
}

SheetGrid::Position position_of(const SheetGrid& grid, const Vec3& point) {
  const Eigen::Array3i at = grid.local(point).array().floor().cast<int>();
  return {at[0], at[1], at[2]};
}

/// Whether the box round a triangle meets a position.
bool meets(const Positions& positions, const SheetGrid& grid, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto low = position_of(grid, a.cwiseMin(b).cwiseMin(c)), high = position_of(grid, a.cwiseMax(b).cwiseMax(c));
  for (int i = low[0]; i <= high[0]; ++i) {
    for (int j = low[1]; j <= high[1]; ++j) {
      const auto first = positions.lower_bound({i, j, low[2]});
      if (first != positions.end() && *first <= SheetGrid::Position{i, j, high[2]}) return true;
    }
  }
  return false;
}

/// Numbers the triangles that meet the positions; -1: those that do not.
std::vector<int> numbered(const TriangleMesh& mesh, const SheetGrid& whole, const Positions& positions) {
  std::vector<int> numbers;
  numbers.reserve(mesh.triangles.size());
  int count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const bool near = meets(positions, whole, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    numbers.push_back(near ? count++ : -1);
  }
  return numbers;
}

TriangleMesh numbered_facets(const TriangleMesh& mesh, const std::vector<int>& numbers) {
  TriangleMesh facets{mesh.vertices, {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (numbers[t] >= 0) facets.triangles.push_back(mesh.triangles[t]);
  }
  return facets;
}

}  // namespace

FoldGrid::FoldGrid(const TriangleMesh& mesh, const SurfaceSamples& samples, const SheetGrid& whole,
                   const std::vector<char>& narrow)
    : facet_of_(numbered(mesh, whole, grown(narrow_positions(whole, narrow), margin + rim))),
      facets_(numbered_facets(mesh, facet_of_)),
      samples_(facets_, SheetGrid::sample_spacing * 0.5 * whole.cell()),
      grid_(samples_, whole) {
  const Positions folds = grown(narrow_positions(whole, narrow), margin);
  std::vector<int> triangle_of(facets_.triangles.size());
  for (std::size_t t = 0; t < facet_of_.size(); ++t) {
    if (facet_of_[t] >= 0) triangle_of[facet_of_[t]] = static_cast<int>(t);
  }
  const auto places = samples_.places();
  for (const auto& cell : grid_.cells()) {
    const Vec3 middle = whole.local(grid_.point(Vec3(cell.at[0], cell.at[1], cell.at[2]) + Vec3::Constant(0.5)));
    const auto& place = places[cell.sample];
    whole_cells_.push_back(whole.cell_of(middle, samples.nearest(triangle_of[place.triangle], place.barycentric)));
    const Eigen::Array3i at = middle.array().floor().cast<int>();
    inside_.push_back(whole_cells_.back() >= 0 && folds.count({at[0], at[1], at[2]}) > 0 ? 1 : 0);
  }
}

int FoldGrid::cell_at(int triangle, const Vec3& barycentric, const Vec3& point) const {
  const int facet = facet_of_[triangle];
  return facet < 0 ? -1 : grid_.cell_of(grid_.local(point), samples_.nearest(facet, barycentric));
}

std::vector<char> FoldGrid::held() const {
  std::vector<char> result(grid_.unknowns(), 0);
  for (std::size_t c = 0; c < inside_.size(); ++c) {
    if (inside_[c] != 0) continue;
    for (const int unknown : grid_.cells()[c].unknowns) result[unknown] = 1;
  }
  return result;
}

int FoldGrid::inside() const {
  return static_cast<int>(std::count(inside_.begin(), inside_.end(), 1));
}

}  // namespace toile::body
