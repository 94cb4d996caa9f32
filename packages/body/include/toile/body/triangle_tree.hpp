#pragma once

#include <memory>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Closest facet of a triangle mesh (AABB tree of CGAL). Thread-safe queries; the mesh is copied.
class TriangleTree {
 public:
  struct Hit {
    int triangle = -1;                  ///< index into TriangleMesh::triangles
    Vec3 point = Vec3::Zero();          ///< closest point, mm
    Vec3 barycentric = Vec3::Zero();    ///< of that point: weights of the triangle's corners, sum one
    Vec3 pseudo_normal = Vec3::Zero();  ///< unit; of the facet, edge or vertex that holds the point
    double distance = 0.0;              ///< mm, >= 0
    /// Negative inside, by the pseudo-normal (Baerentzen, Aanaes, IEEE TVCG 11 (2005) 243).
    double signed_distance = 0.0;
  };

  /// `mesh` must have at least one triangle; facets of zero area are left out.
  explicit TriangleTree(const TriangleMesh& mesh);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  Hit closest(const Vec3& point) const;
  /// Where the segment passes through facets, or by round-off beside their edges, from `from` on; distances from there.
  /// A facet in the plane of the segment is not met.
  std::vector<Hit> crossings(const Vec3& from, const Vec3& to) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace toile::body
