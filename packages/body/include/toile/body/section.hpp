#pragma once

#include <memory>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// One curve in which a plane cuts a surface.
struct SectionPiece {
  std::vector<Vec3> points;  ///< in order; a closed curve does not repeat its first point
  bool closed = true;
  double perimeter = 0.0;      ///< length of the curve, mm
  double tape_girth = 0.0;     ///< perimeter of its convex hull: what a tape round it measures, mm
  double area = 0.0;           ///< enclosed, mm^2; 0 of an open curve
  Vec3 centre = Vec3::Zero();  ///< centroid of the enclosed area; of an open curve its own
  Vec3 lower = Vec3::Zero();   ///< corners of its box, mm
  Vec3 upper = Vec3::Zero();
};

/// Sections of a body by planes, and lengths on it. The mesh is copied.
class Sections {
 public:
  /// `mesh`: manifold, with at least one triangle.
  explicit Sections(const TriangleMesh& mesh);
  ~Sections();
  Sections(Sections&&) noexcept;
  Sections& operator=(Sections&&) noexcept;

  /// Every curve in which the plane through `point` across `normal` (any length but zero) cuts the body; none if it
  /// misses it. A facet that lies in the plane is met at its edges.
  std::vector<SectionPiece> cut(const Vec3& point, const Vec3& normal) const;
  /// The shortest way on the facets between the points of the body that are closest to two points: its corners, both
  /// ends among them; right on the facets within 1e-4 mm (Xin, Wang, ACM Trans. Graphics 28 (2009) 104). Empty between
  /// pieces that are not connected.
  std::vector<Vec3> shortest_way(const Vec3& from, const Vec3& to) const;
  /// Its length, mm; infinite if there is none.
  double length_on_surface(const Vec3& from, const Vec3& to) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Perimeter of the convex hull of points that lie in a plane across `normal`, mm.
double tape_girth(const std::vector<Vec3>& points, const Vec3& normal);

/// Size of a body.
struct Extent {
  Vec3 lower = Vec3::Zero();  ///< mm
  Vec3 upper = Vec3::Zero();
  double area = 0.0;    ///< mm^2
  double volume = 0.0;  ///< mm^3; of an open surface seen from its centre
  int pieces = 0;       ///< that are not connected
};
Extent extent_of(const TriangleMesh& mesh);

}  // namespace toile::body
