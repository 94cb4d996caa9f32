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
///
/// Fabric that lies over a vertex need not lie on it: where it spans a groove, the fabric that the normal of a wall
/// meets presses on the shoulder. It lies on the vertex if it is no further from it than from the body, but for what
/// its facets leave open: twice the sag of a side, side times turn of the body under it / 8, and a tenth of the side.
class BodyMap {
 public:
  BodyMap(const GarmentOnBody& garment, const body::TriangleMesh& body, const BodyMapOptions& options = {});
  /// To single points of the body with their outward unit normals, which count as vertices.
  BodyMap(const GarmentOnBody& garment, const std::vector<mesh::Vec3>& points, const std::vector<mesh::Vec3>& normals,
          const BodyMapOptions& options = {});

  /// Of the fabric that lies on the body. `nodal`: [node]. Returns [body vertex], unit of `nodal`.
  std::vector<double> on(const std::vector<double>& nodal) const;
  /// Of the fabric that lies over the body, on it or not. `nodal`: [node]. Returns [body vertex], unit of `nodal`.
  std::vector<double> over(const std::vector<double>& nodal) const;
  /// Of the fabric that lies over the body and not on it: of a pressure, by how much that at the vertex is not known,
  /// since beside a shoulder fabric may lie on the body or hang over it.
  std::vector<double> beside(const std::vector<double>& nodal) const;
  /// [body vertex] how many layers lie over it.
  const std::vector<int>& layers() const { return layers_; }
  /// [body vertex] mm, of fabric that lies over it, but not on it: what to add to the nodal distance for that of the
  /// vertex from the fabric nearest to it; the sum over the layers.
  const std::vector<double>& excess() const { return excess_; }

 private:
  /// Value at a body vertex: the sum of weight times nodal value.
  struct Term {
    std::size_t vertex;
    std::size_t node;
    double weight;
    bool on;
  };
  std::vector<Term> terms_;
  std::vector<int> layers_;
  std::vector<double> excess_;
};

}  // namespace toile::result
