#include "fitted_field.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "local_smoothing.hpp"
#include "mesh_geometry.hpp"
#include "toile/body/border.hpp"

namespace toile::body {
namespace {

/// Half of the width of slits that are left out, cells.
constexpr double slit = 0.2;
/// Of the whole body's grid, when there are finer cells in folds: their grid may have eight times as many. A whole
/// person in cells of 5 mm has 1.3e7; with smaller ones folds are rounded by less than 2 mm as they are.
constexpr double most_positions_with_folds = 2e7;

/// Of a mesh whose grid is not too large: the finer the cells, the more samples.
SurfaceSamples samples_of(const TriangleMesh& mesh, double cell) {
  SheetGrid::box_of(mesh.vertices, cell);
  return SurfaceSamples(mesh, SheetGrid::sample_spacing * cell);
}

Eigen::Vector4d value_and_gradient(const SplineField::Value& field) {
  return {field.value, field.gradient.x(), field.gradient.y(), field.gradient.z()};
}

SplineField::Value operator+(const SplineField::Value& a, const SplineField::Value& b) {
  return {a.value + b.value, a.gradient + b.gradient, a.hessian + b.hessian};
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Vertices in slits: a ball of that radius that touched them would be deep in other facets of the same sheet. No
/// spline holds both walls, and no fabric gets there. Where walls have sheets of their own (two thighs), they may be as
/// near to each other as they like.
std::vector<char> slit_vertices(const TriangleMesh& mesh, const TriangleTree& tree, const SurfaceSamples& samples,
                                const SheetGrid& grid, double radius) {
  constexpr double deep = 0.35;  // of the radius: a crease of 40 degrees
  std::vector<char> result(mesh.vertices.size(), 0);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& vertex = mesh.vertices[i];
    const int cell = grid.cell_of(grid.local(vertex), static_cast<int>(i));
    if (cell < 0) continue;
    const auto hit = tree.closest(vertex + radius * samples.normals[i]);
    if (hit.distance > deep * radius) continue;
    const Vec3 there = grid.local(hit.point);
    const int wall = grid.cell_of(there, samples.nearest(hit.triangle, hit.barycentric));
    result[i] = wall >= 0 && wall == grid.continued(cell, there) ? 1 : 0;
  }
  return result;
}

/// Vertices and their normals, those in slits left out.
std::vector<LevelSetDatum> data_of(const TriangleMesh& mesh, const SurfaceSamples& samples, const SheetGrid& grid,
                                   const std::vector<char>& in_slits) {
  const auto areas = vertex_areas(mesh);
  const auto border = border_vertices(mesh);
  std::vector<LevelSetDatum> data;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const int cell = grid.cell_of(grid.local(mesh.vertices[i]), static_cast<int>(i));
    if (cell < 0 || areas[i] == 0.0 || in_slits[i] != 0) continue;  // or a vertex that no triangle uses
    LevelSetDatum datum;
    datum.cell = cell;
    datum.point = mesh.vertices[i];
    datum.wanted.tail<3>() = samples.normals[i];
    datum.area = areas[i];
    datum.has_gradient = border[i] == 0;  // the facets of one side only would tilt the normal
    data.push_back(datum);
  }
  return data;
}

/// The finer splines get what those of the whole body leave to be done.
FittedSplines fit_folds(std::vector<LevelSetDatum> data, const FittedSplines& whole,
                        const std::shared_ptr<const FoldGrid>& folds, const std::vector<double>& smoothing) {
  constexpr double same_length = 64.0;  // the smoothing length in mm, (3 lambda)^(1/6) cells, stays as it is
  const SheetGrid& grid = folds->grid();
  std::vector<double> finer(grid.cells().size(), 0.0);
  for (std::size_t c = 0; c < finer.size(); ++c) {
    const int cell = folds->whole_cell(static_cast<int>(c));
    if (cell >= 0) finer[c] = same_length * smoothing[cell];
  }
  for (LevelSetDatum& datum : data) {
    const int cell = folds->whole_cell(datum.cell);
    if (cell < 0) continue;  // its unknowns are held
    datum.wanted -= value_and_gradient(whole.value.evaluate(cell, datum.point));
    datum.change = -value_and_gradient(whole.doubt.evaluate(cell, datum.point));
  }
  return fit_spline({folds, &grid}, data, finer, sum(vertex_areas(folds->facets())), folds->held());
}

}  // namespace

FittedField::FittedField(const TriangleMesh& mesh, const TriangleTree& tree, double cell, double smoothing)
    : samples_(samples_of(mesh, cell)),
      grid_(std::make_shared<const SheetGrid>(samples_, cell)),
      in_slits_(slit_vertices(mesh, tree, samples_, *grid_, slit * cell)) {
  const auto local = local_smoothing(*grid_, samples_, mean_edge_length(mesh), smoothing);
  whole_ =
      std::make_unique<FittedSplines>(fit_spline(grid_, data_of(mesh, samples_, *grid_, in_slits_), local.weights,
                                                 sum(vertex_areas(mesh)), std::vector<char>(grid_->unknowns(), 0)));
  if (grid_->positions() > most_positions_with_folds || std::count(local.narrow.begin(), local.narrow.end(), 1) == 0)
    return;
  folds_ = std::make_shared<const FoldGrid>(mesh, samples_, *grid_, local.narrow);
  in_folds_ = std::make_unique<FittedSplines>(
      fit_folds(data_of(mesh, samples_, folds_->grid(), in_slits_), *whole_, folds_, local.weights));
}

double FittedField::slit_width() const {
  return 2.0 * slit * grid_->cell();
}

FittedField::Place FittedField::place(const TriangleTree::Hit& hit) const {
  Place result;
  result.cell = grid_->cell_of(grid_->local(hit.point), samples_.nearest(hit.triangle, hit.barycentric));
  if (result.found() && folds_) result.finer = folds_->cell_at(hit.triangle, hit.barycentric, hit.point);
  return result;
}

int FittedField::finer_cell(int cell, int from, const Vec3& point) const {
  if (!folds_ || cell < 0) return -1;
  const SheetGrid& grid = folds_->grid();
  const auto [first, end] = grid.cells_at(grid.local(point));
  int best = -1, most = -1;
  for (int c = first; c < end; ++c) {
    if (folds_->whole_cell(c) != cell) continue;
    const int common = from >= 0 ? grid.common_nodes(from, c) : 0;
    if (common > most) {
      most = common;
      best = c;
    }
  }
  return best;
}

FittedField::Place FittedField::continued(const Place& from, const Vec3& point) const {
  Place result;
  result.cell = grid_->continued(from.cell, grid_->local(point));
  result.finer = finer_cell(result.cell, from.finer, point);
  return result;
}

FittedField::Places FittedField::places_at(const Vec3& point) const {
  Places result;
  const auto [first, end] = grid_->cells_at(grid_->local(point));
  for (int c = first; c < end; ++c) result.push_back({c, -1});
  if (!folds_) return result;
  const auto [finer, finer_end] = folds_->grid().cells_at(folds_->grid().local(point));
  for (int f = finer; f < finer_end; ++f) {
    const Place place{folds_->whole_cell(f), f};
    const auto plain = std::find(result.begin(), result.end(), Place{place.cell, -1});
    if (plain != result.end()) {
      *plain = place;
    } else if (place.found()) {
      result.push_back(place);
    }
  }
  return result;
}

SplineField::Value FittedField::value(const Place& place, const Vec3& point) const {
  const auto value = whole_->value.evaluate(place.cell, point);
  return place.finer < 0 ? value : value + in_folds_->value.evaluate(place.finer, point);
}

SplineField::Value FittedField::doubt(const Place& place, const Vec3& point) const {
  const auto doubt = whole_->doubt.evaluate(place.cell, point);
  return place.finer < 0 ? doubt : doubt + in_folds_->doubt.evaluate(place.finer, point);
}

}  // namespace toile::body
