#pragma once

#include <vector>

#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::result {

struct BodyMapOptions {
  double limit = 5.0;      ///< mm; how far from the body the garment may be, in addition to its distance there
  double agreement = 0.5;  ///< smallest cosine between the normals of the body here and below the garment
};

/// The deformed garment on its body.
struct GarmentOnBody {
  const mesh::Mesh* mesh = nullptr;
  std::vector<mesh::Vec3> position;  ///< [node] mm
  std::vector<int> tied = {};        ///< [node] as in GarmentFields
  std::vector<double> distance;      ///< [node] mm from the body to the mid-surface
  std::vector<mesh::Vec3> normal;    ///< [node] of the body at the closest point
};

/// Carries nodal fields of the garment (for instance the contact pressure) to the body's vertices: linear interpolation
/// where the normal of the vertex meets the garment, added up over the layers that lie over each other there; zero
/// where no garment lies over the body.
///
/// No garment lies over a vertex if it is further than limit + distance, if it lies on another part of the body (the
/// normals disagree: the other leg), or if it ends beside the vertex.
class BodyMap {
 public:
  BodyMap(const GarmentOnBody& garment, const body::TriangleMesh& body, const BodyMapOptions& options = {});
  /// To single points of the body with their outward unit normals, which count as vertices.
  BodyMap(const GarmentOnBody& garment, const std::vector<mesh::Vec3>& points, const std::vector<mesh::Vec3>& normals,
          const BodyMapOptions& options = {});

  /// `nodal`: [node]. Returns [body vertex], unit of `nodal`.
  std::vector<double> map(const std::vector<double>& nodal) const;

 private:
  /// Value at a body vertex: the sum of weight times nodal value.
  struct Term {
    std::size_t vertex;
    std::size_t node;
    double weight;
  };
  std::size_t vertices_;
  std::vector<Term> terms_;
};

}  // namespace toile::result
