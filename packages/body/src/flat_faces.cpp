#include "flat_faces.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

#include "mesh_geometry.hpp"

namespace toile::body {
namespace {

constexpr double degree = M_PI / 180.0;

/// Facets, and the flat faces that they make together.
class Faces {
 public:
  explicit Faces(std::size_t facets) : parent_(facets) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t facet) {
    while (parent_[facet] != facet) {
      facet = parent_[facet] = parent_[parent_[facet]];
    }
    return facet;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// An edge between two facets.
struct Hinge {
  std::size_t first = 0, second = 0;  ///< facets
  double angle = 0.0;                 ///< between their normals
  double length = 0.0;                ///< mm
};

std::vector<Hinge> hinges(const TriangleMesh& mesh, const std::vector<Vec3>& vectors) {
  std::map<std::pair<int, int>, std::size_t> open;
  std::vector<Hinge> all;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    for (int i = 0; i < 3; ++i) {
      const int a = mesh.triangles[n][i], b = mesh.triangles[n][(i + 1) % 3];
      const auto [at, is_new] = open.try_emplace(std::minmax(a, b), n);
      if (is_new) {
        continue;
      }
      const double angle =
          std::atan2(vectors[n].cross(vectors[at->second]).norm(), vectors[n].dot(vectors[at->second]));
      all.push_back({n, at->second, angle, (mesh.vertices[a] - mesh.vertices[b]).norm()});
    }
  }
  return all;
}

/// [vertex] whether all its facets belong to one face.
std::vector<char> inner_vertices(const TriangleMesh& mesh, Faces* faces) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> face(mesh.vertices.size(), none);
  std::vector<char> inner(mesh.vertices.size(), 1);
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    for (const int v : mesh.triangles[n]) {
      inner[v] = inner[v] != 0 && (face[v] == none || face[v] == faces->of(n)) ? 1 : 0;
      face[v] = faces->of(n);
    }
  }
  return inner;
}

/// A flat face.
struct Face {
  double area = 0.0;   ///< mm^2
  double inner = 0.0;  ///< mm^2, of it the part of the vertices inside
  double rim = 0.0;    ///< mm, edges with other such faces
  double turn = 0.0;   ///< mm radians, at them
};

/// [one of their facets]; edges sharper than `sharpest` are meant to be edges.
std::map<std::size_t, Face> measure(const TriangleMesh& mesh, const std::vector<Vec3>& vectors,
                                    const std::vector<Hinge>& all, Faces* faces) {
  constexpr double sharpest = 80.0 * degree;
  const std::vector<char> inner = inner_vertices(mesh, faces);
  std::map<std::size_t, Face> measured;
  for (std::size_t n = 0; n < vectors.size(); ++n) {
    Face& face = measured[faces->of(n)];
    face.area += 0.5 * vectors[n].norm();
    for (const int v : mesh.triangles[n]) {
      face.inner += inner[v] != 0 ? vectors[n].norm() / 6.0 : 0.0;
    }
  }
  for (const Hinge& hinge : all) {
    Face &a = measured[faces->of(hinge.first)], &b = measured[faces->of(hinge.second)];
    if (&a == &b || hinge.angle > sharpest || a.inner == 0.0 || b.inner == 0.0) {
      continue;
    }
    for (Face* face : {&a, &b}) {
      face->rim += hinge.length;
      face->turn += hinge.length * hinge.angle;
    }
  }
  return measured;
}

}  // namespace

FlatFaces find_flat_faces(const TriangleMesh& mesh) {
  constexpr double flat = 0.5 * degree;
  const std::vector<Vec3> vectors = area_vectors(mesh);
  const std::vector<Hinge> all = hinges(mesh, vectors);
  Faces faces(mesh.triangles.size());
  for (const Hinge& hinge : all) {
    if (hinge.angle < flat) {
      faces.join(hinge.first, hinge.second);
    }
  }
  FlatFaces found;
  double inner = 0.0, total = 0.0;
  for (const auto& [facet, face] : measure(mesh, vectors, all, &faces)) {
    total += face.area;
    if (face.rim > 0.0) {
      inner += face.inner;
      found.angle += face.inner * face.turn / face.rim;
      found.width += face.inner * 2.0 * face.area / face.rim;
    }
  }
  if (inner > 0.0) {
    found = {inner / total, found.angle / inner, found.width / inner};
  }
  return found;
}

bool matter(const FlatFaces& faces) {
  constexpr double least_share = 0.05, least_angle = 7.0 * degree;
  return faces.share > least_share && faces.angle > least_angle;
}

bool prevail(const FlatFaces& faces) {
  constexpr double share = 0.2, angle = 20.0 * degree;
  return faces.share > share && faces.angle > angle;
}

std::string flat_faces_text(const FlatFaces& faces) {
  std::ostringstream text;
  text.precision(2);
  text << "the body is made of coarse flat facets: faces about " << faces.width << " mm wide that meet at "
       << faces.angle / degree << " degrees, cut further, so that there are vertices inside them. A smooth surface "
       << "follows them; a round body lies up to " << faces.width * faces.angle / 8.0 << " mm outside of them ("
       << 100.0 * faces.angle * faces.angle / 8.0 << " % of its radius), and its pressure is wrong (measured on a "
       << "cylinder: 1 % low and waves of 4 % round it at 10 degrees, 4 to 6 % low and waves of 30 % at 15 degrees). "
       << "Export the body with a finer tolerance (a smaller angle between facets), or without cutting its facets "
          "further";
  return text.str();
}

}  // namespace toile::body
