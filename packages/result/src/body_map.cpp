#include "toile/result/body_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "toile/body/triangle_tree.hpp"
#include "triangulate.hpp"
#include "vertex_normals.hpp"

namespace toile::result {
namespace {

using body::Vec3;
using Hit = body::TriangleTree::Hit;

/// Value at a place inside a triangle.
template <class T>
T interpolate(const std::array<int, 3>& triangle, const Vec3& weights, const std::vector<T>& values) {
  T result = weights[0] * values[static_cast<std::size_t>(triangle[0])];
  for (int k = 1; k < 3; ++k) {
    result += weights[k] * values[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
  }
  return result;
}

/// The closest point lies along the garment's normal; beyond a free edge it lies sideways.
bool faces(const Hit& hit, const Vec3& vertex) {
  constexpr double smallest_cosine = 0.9;
  const double along = std::abs(hit.pseudo_normal.dot(hit.point - vertex));
  return hit.distance < 1e-9 || along >= smallest_cosine * hit.distance;
}

/// A place on the garment over a point of the body.
struct Layer {
  Hit hit;
  double excess = 0.0;  ///< mm, if it lies off the point: what to add to its distance from the body
  bool on = false;      ///< it lies on the point
};

/// Finds the garment over points of the body.
class Finder {
 public:
  Finder(const GarmentOnBody& garment, const BodyMapOptions& options)
      : options_(options),
        triangles_(triangulate(*garment.mesh, positions(garment))),
        tree_(triangles_.mesh),
        distance_(at_vertices(*garment.mesh, garment.distance)),
        normal_(at_vertices(*garment.mesh, garment.normal)) {
    tied_.resize(triangles_.mesh.vertices.size());
    std::iota(tied_.begin(), tied_.end(), 0);
    std::copy(garment.tied.begin(), garment.tied.end(), tied_.begin());
    reach_ = options.limit + std::max(0.0, *std::max_element(distance_.begin(), distance_.end()));
    for (const Vec3& vertex : triangles_.mesh.vertices) {
      box_.extend(vertex);
    }
  }

  /// One place on each layer over a point of the body with this normal.
  std::vector<Layer> over(const Vec3& point, const Vec3& normal) const {
    std::vector<Layer> layers;
    if (box_.exteriorDistance(point) > reach_) {
      return layers;
    }
    for (const Hit& hit : tree_.crossings(point - reach_ * normal, point + reach_ * normal)) {
      const bool is_new = std::none_of(layers.begin(), layers.end(), [&](const Layer& l) { return touch(l.hit, hit); });
      if (is_new && lies_over(hit, (hit.point - point).norm(), normal)) {
        layers.push_back(layer(hit, (hit.point - point).norm(), point, normal));
      }
    }
    if (layers.empty()) {  // beside the edge of a facet that the body's is not parallel to
      const Hit hit = tree_.closest(point);
      if (lies_over(hit, hit.distance, normal) && faces(hit, point)) {
        layers.push_back(layer(hit, hit.distance, point, normal));
      }
    }
    return layers;
  }

  const GarmentTriangles& triangles() const { return triangles_; }

 private:
  /// Both sides of a closed seam at the very same place, so that no ray passes between them.
  static std::vector<Vec3> positions(const GarmentOnBody& garment) {
    std::vector<Vec3> positions = garment.position;
    for (std::size_t n = 0; n < garment.tied.size(); ++n) {
      positions[n] = garment.position[static_cast<std::size_t>(garment.tied[n])];
    }
    return positions;
  }

  const std::array<int, 3>& corners(const Hit& hit) const {
    return triangles_.mesh.triangles[static_cast<std::size_t>(hit.triangle)];
  }

  /// Places on one layer: their triangles are the same or neighbours.
  bool touch(const Hit& a, const Hit& b) const {
    for (const int i : corners(a)) {
      for (const int j : corners(b)) {
        if (tied_[static_cast<std::size_t>(i)] == tied_[static_cast<std::size_t>(j)]) {
          return true;
        }
      }
    }
    return false;
  }

  /// From the body, mm.
  double usual(const Hit& hit) const { return std::max(0.0, interpolate(corners(hit), hit.barycentric, distance_)); }

  bool lies_over(const Hit& hit, double distance, const Vec3& normal) const {
    const Vec3 below = interpolate(corners(hit), hit.barycentric, normal_);
    return distance <= options_.limit + usual(hit) && below.dot(normal) >= options_.agreement * below.norm();
  }

  /// Facets over an edge of the body cut through it: fabric below the point lies on it.
  Layer layer(const Hit& hit, double distance, const Vec3& point, const Vec3& normal) const {
    if ((hit.point - point).dot(normal) <= 0.0 || distance <= usual(hit) + slack(hit)) {
      return {hit, 0.0, true};
    }
    return {hit, tree_.closest(point).distance - usual(hit), false};
  }

  /// What facets leave open, mm.
  double slack(const Hit& hit) const {
    constexpr double of_side = 0.1, of_turn = 0.25;
    double most = 0.0;
    for (const int i : corners(hit)) {
      for (const int j : corners(hit)) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        const double side = (triangles_.mesh.vertices[a] - triangles_.mesh.vertices[b]).norm();
        most = std::max(most, side * (of_side + of_turn * (normal_[a] - normal_[b]).norm()));
      }
    }
    return most;
  }

  BodyMapOptions options_;
  GarmentTriangles triangles_;
  body::TriangleTree tree_;
  std::vector<double> distance_;  ///< [vertex]
  std::vector<Vec3> normal_;      ///< [vertex]
  std::vector<int> tied_;         ///< [vertex]
  double reach_ = 0.0;
  Eigen::AlignedBox3d box_;
};

/// [vertex of the triangles] the nodes whose mean it is.
std::vector<std::vector<int>> nodes_of_vertices(const mesh::Mesh& garment) {
  std::vector<std::vector<int>> nodes(static_cast<std::size_t>(garment.nodes()));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    nodes[n] = {static_cast<int>(n)};
  }
  for (const mesh::Block& block : garment.blocks) {
    for (std::size_t i = 0; block.nodes_per_element == 4 && i < block.connectivity.size(); i += 4) {
      nodes.emplace_back(&block.connectivity[i], &block.connectivity[i] + 4);
    }
  }
  return nodes;
}

}  // namespace

BodyMap::BodyMap(const GarmentOnBody& garment, const body::TriangleMesh& body, const BodyMapOptions& options)
    : BodyMap(garment, body.vertices, vertex_normals(body), options) {}

BodyMap::BodyMap(const GarmentOnBody& garment, const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                 const BodyMapOptions& options)
    : layers_(points.size(), 0), excess_(points.size(), 0.0) {
  const Finder finder(garment, options);
  const std::vector<std::vector<int>> nodes = nodes_of_vertices(*garment.mesh);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Layer& layer : finder.over(points[i], normals[i])) {
      ++layers_[i];
      excess_[i] += layer.excess;
      for (int k = 0; k < 3; ++k) {
        const auto& corners = finder.triangles().mesh.triangles[static_cast<std::size_t>(layer.hit.triangle)];
        const std::vector<int>& of = nodes[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
        for (const int node : of) {
          const double weight = layer.hit.barycentric[k] / static_cast<double>(of.size());
          terms_.push_back({i, static_cast<std::size_t>(node), weight, layer.on});
        }
      }
    }
  }
}

std::vector<double> BodyMap::on(const std::vector<double>& nodal) const {
  std::vector<double> result(layers_.size(), 0.0);
  for (const Term& term : terms_) {
    if (term.on) {
      result[term.vertex] += term.weight * nodal[term.node];
    }
  }
  return result;
}

std::vector<double> BodyMap::over(const std::vector<double>& nodal) const {
  std::vector<double> result(layers_.size(), 0.0);
  for (const Term& term : terms_) {
    result[term.vertex] += term.weight * nodal[term.node];
  }
  return result;
}

std::vector<double> BodyMap::beside(const std::vector<double>& nodal) const {
  std::vector<double> result = over(nodal);
  const std::vector<double> lies_on = on(nodal);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= lies_on[i];
  return result;
}

}  // namespace toile::result
