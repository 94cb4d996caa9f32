#pragma once

#include <boost/container/small_vector.hpp>
#include <memory>
#include <vector>

#include "fit_spline.hpp"
#include "fold_grid.hpp"
#include "surface_samples.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {

/// The level set f of a body as fitted, and what it would change by if the smoothing's weight were six times as large,
/// to first order in its logarithm: a spline on cells that cover the whole body, and in narrow folds a second one, on
/// finer cells, that is added to it. C2 along each sheet.
class FittedField {
 public:
  /// A sheet's cell, and its finer cell there (-1: none).
  struct Place {
    int cell = -1;
    int finer = -1;
    bool found() const { return cell >= 0; }
    bool operator==(const Place& other) const { return cell == other.cell && finer == other.finer; }
  };
  using Places = boost::container::small_vector<Place, 4>;

  /// Least-squares fit to vertices (f = 0) and vertex normals (grad f = n), with the integral of the squared third
  /// derivatives times `smoothing`, less where the surface bends much; see the README. Throws InputError if the grid
  /// would be too large or the system cannot be factorised.
  /// `tree`: of the mesh.
  FittedField(const TriangleMesh& mesh, const TriangleTree& tree, double cell, double smoothing);

  /// Of the sheet of a facet, at a point on it.
  Place place(const TriangleTree::Hit& hit) const;
  /// On the same sheet as `from`, at a point that is near it; not found where the sheet has no cell.
  Place continued(const Place& from, const Vec3& point) const;
  /// Of all sheets at a point.
  Places places_at(const Vec3& point) const;
  SplineField::Value value(const Place& place, const Vec3& point) const;
  SplineField::Value doubt(const Place& place, const Vec3& point) const;

  const SheetGrid& grid() const { return *grid_; }        ///< of the whole body
  const FoldGrid* folds() const { return folds_.get(); }  ///< null: there are no narrow folds
  /// [vertex] 1 in slits that the surface closes.
  const std::vector<char>& in_slits() const { return in_slits_; }
  double slit_width() const;  ///< mm, what is narrower is a slit

 private:
  int finer_cell(int cell, int from, const Vec3& point) const;

  SurfaceSamples samples_;
  std::shared_ptr<const SheetGrid> grid_;
  std::vector<char> in_slits_;
  std::unique_ptr<FittedSplines> whole_;
  std::shared_ptr<const FoldGrid> folds_;
  std::unique_ptr<FittedSplines> in_folds_;
};

}  // namespace toile::body
