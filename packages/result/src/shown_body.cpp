#include "toile/result/shown_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "toile/body/triangle_tree.hpp"
#include "triangulate.hpp"
#include "vertex_normals.hpp"

namespace toile::result {
namespace {

using body::SurfacePoint;
using body::TriangleMesh;
using body::Vec3;
using Edge = std::pair<int, int>;
using Triangle = std::array<int, 3>;

constexpr double beyond = 30.0;     // mm, how far a garment slides from its start, in addition to two sizes
constexpr double too_long = 1.5;    // sizes: halves are no shorter than three quarters of the size then
constexpr double most = 200000.0;   // triangles
constexpr double agreement = 0.5;   // cosine between the normals of the triangles and of the smooth surface
constexpr double round_off = 1e-6;  // mm

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

Vec3 area_vector(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.vertices[at(t[0])];
  return 0.5 * (mesh.vertices[at(t[1])] - a).cross(mesh.vertices[at(t[2])] - a);
}

double mean_side(const mesh::Mesh& garment) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const mesh::Block& block : garment.blocks) {
    const auto per = static_cast<std::size_t>(block.nodes_per_element);
    for (std::size_t i = 0; i < block.connectivity.size(); ++i, ++count) {
      const std::size_t next = (i + 1) % per == 0 ? i + 1 - per : i + 1;
      sum += (garment.placed[at(block.connectivity[i])] - garment.placed[at(block.connectivity[next])]).norm();
    }
  }
  return sum / static_cast<double>(count);
}

/// Divides the triangles of a body.
class Dividing {
 public:
  Dividing(const body::Surface& surface, ShownBody& body) : surface_(surface), mesh_(body.mesh), error_(body.error) {}

  /// Marks the triangles that the garment can come near.
  void find_reach(const mesh::Mesh& garment, double reach) {
    const body::TriangleTree fabric(triangulate(garment, garment.placed).mesh);
    std::vector<bool> near;
    for (const Vec3& vertex : mesh_.vertices) near.push_back(fabric.closest(vertex).distance <= reach);
    for (const Triangle& t : mesh_.triangles) is_near_.push_back(near[at(t[0])] || near[at(t[1])] || near[at(t[2])]);
    if (!starts_on_body(garment, reach)) is_near_.assign(mesh_.triangles.size(), true);
  }

  double area() const {
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (is_near_[t]) sum += area_vector(mesh_, mesh_.triangles[t]).norm();
    return sum;
  }

  void lay_onto_surface() {
    const std::vector<Vec3> normals = vertex_normals(mesh_);
    std::set<int> vertices;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (is_near_[t]) vertices.insert(mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    for (const int v : vertices) mesh_.vertices[at(v)] = laid(mesh_.vertices[at(v)], normals[at(v)]);
  }

  void divide(double size) {
    while (find_middles(too_long * size)) {
      std::vector<Triangle> all;
      std::vector<bool> near;
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        divide(mesh_.triangles[t], all);
        near.resize(all.size(), is_near_[t]);
      }
      mesh_.triangles = std::move(all);
      is_near_ = std::move(near);
    }
  }

 private:
  bool starts_on_body(const mesh::Mesh& garment, double reach) const {
    const body::TriangleTree skin(mesh_);
    const auto on_it = [&](const Vec3& node) { return skin.closest(node).distance <= reach; };
    return 2 * std::count_if(garment.placed.begin(), garment.placed.end(), on_it) >=
           static_cast<std::ptrdiff_t>(garment.placed.size());
  }

  /// Where the smooth surface is not that of the triangles here (a fold, a hole that it closes), they stay.
  Vec3 laid(const Vec3& point, const Vec3& normal) const {
    const SurfacePoint there = surface_.closest(point);
    return there.found && there.normal.dot(normal) >= agreement ? there.closest : point;
  }

  /// Makes a vertex in the middle of each edge that is too long; false if none is.
  bool find_middles(double longest) {
    std::map<Edge, Vec3> normals;  // of both triangles of an edge that is too long
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3 && is_near_[t]; ++k) {
        const Edge edge = std::minmax(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]);
        if ((mesh_.vertices[at(edge.first)] - mesh_.vertices[at(edge.second)]).norm() <= longest) continue;
        normals.try_emplace(edge, Vec3::Zero()).first->second += area_vector(mesh_, mesh_.triangles[t]);
      }
    middle_.clear();
    for (const auto& [edge, normal] : normals) {
      middle_[edge] = static_cast<int>(mesh_.vertices.size());
      const Vec3 between = 0.5 * (mesh_.vertices[at(edge.first)] + mesh_.vertices[at(edge.second)]);
      mesh_.vertices.push_back(laid(between, normal.normalized()));
      error_.push_back(0.5 * (error_[at(edge.first)] + error_[at(edge.second)]));
    }
    return !middle_.empty();
  }

  /// Into one triangle more than sides of it have a middle.
  void divide(const Triangle& t, std::vector<Triangle>& all) const {
    const auto middle_of = [&](int a, int b) {
      const auto found = middle_.find(std::minmax(a, b));
      return found == middle_.end() ? -1 : found->second;
    };
    // Turned so that sides with a middle come first.
    Triangle c = t;
    std::array<int, 3> m{};
    for (int turn = 0; turn < 3; ++turn) {
      m = {middle_of(c[0], c[1]), middle_of(c[1], c[2]), middle_of(c[2], c[0])};
      if (m[0] >= 0 && (m[1] >= 0 || m[2] < 0)) break;
      c = {c[1], c[2], c[0]};
    }
    if (m[0] < 0) {
      all.push_back(t);
    } else if (m[1] < 0) {
      all.insert(all.end(), {{c[0], m[0], c[2]}, {m[0], c[1], c[2]}});
    } else if (m[2] < 0) {
      all.push_back({m[0], c[1], m[1]});
      const auto length = [&](int a, int b) { return (mesh_.vertices[at(a)] - mesh_.vertices[at(b)]).norm(); };
      if (length(c[0], m[1]) < length(m[0], c[2]))
        all.insert(all.end(), {{c[0], m[0], m[1]}, {c[0], m[1], c[2]}});
      else
        all.insert(all.end(), {{c[0], m[0], c[2]}, {m[0], m[1], c[2]}});
    } else {
      all.insert(all.end(), {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}});
    }
  }

  const body::Surface& surface_;
  TriangleMesh& mesh_;
  std::vector<double>& error_;
  std::vector<bool> is_near_;  ///< [triangle]
  std::map<Edge, int> middle_;
};

/// [vertex] mm, how far the surface lies outside of it; empty if it is what the vertices were made from.
std::vector<double> errors_of(const body::Surface& surface, const TriangleMesh& triangles) {
  std::vector<double> errors;
  for (const Vec3& vertex : triangles.vertices) {
    const SurfacePoint point = surface.closest(vertex);
    errors.push_back(point.found ? -point.gap : 0.0);
  }
  const auto none = [](double error) { return std::abs(error) < round_off; };
  if (std::all_of(errors.begin(), errors.end(), none)) errors.clear();
  return errors;
}

}  // namespace

ShownBody shown_body(const body::Surface& surface, TriangleMesh triangles, const mesh::Mesh& garment,
                     std::optional<double> size) {
  ShownBody body{std::move(triangles)};
  body.error = errors_of(surface, body.mesh);
  if (body.error.empty()) return body;
  const double wanted = size.value_or(mean_side(garment));
  Dividing dividing(surface, body);
  dividing.find_reach(garment, beyond + 2.0 * wanted);
  dividing.lay_onto_surface();
  dividing.divide(std::max(wanted, std::sqrt(dividing.area() / (0.25 * std::sqrt(3.0) * most))));
  return body;
}

}  // namespace toile::result
