#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "toile/body/import.hpp"

namespace toile::body {
namespace {

/// Of an edge, longest first; the vertices decide between equal lengths, so that there always is one longest.
struct Length {
  double length = 0.0;
  int a = 0, b = 0;
  bool operator<(const Length& other) const {
    return std::tie(length, a, b) < std::tie(other.length, other.a, other.b);
  }
};

Length length_of(const TriangleMesh& mesh, int a, int b) {
  return {(mesh.vertices[a] - mesh.vertices[b]).norm(), std::min(a, b), std::max(a, b)};
}

double width(const TriangleMesh& mesh, const std::array<int, 3>& t, double longest) {
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / longest;
}

constexpr double short_enough = 15.0;  // mm
constexpr double wanted = 4.0;         // length for its width

bool is_longer(double length, double least, double times, double width_of_triangle) {
  return length > std::max(least, times * width_of_triangle);
}

/// Scans and modelled bodies have next to none that are ten times as long as wide, or longer than a hand is wide.
bool is_long(double length, double width_of_triangle) {
  constexpr double slender = 10.0, long_edge = 100.0;  // mm
  return is_longer(length, short_enough, slender, width_of_triangle) ||
         is_longer(length, long_edge, wanted, width_of_triangle);
}

using Key = std::pair<int, int>;

/// The facets at an edge, each with the corner that the edge leaves it from.
using Sides = std::map<Key, std::vector<std::pair<std::size_t, int>>>;

Sides sides_of(const TriangleMesh& mesh) {
  Sides sides;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    for (int i = 0; i < 3; ++i) {
      sides[std::minmax(mesh.triangles[n][i], mesh.triangles[n][(i + 1) % 3])].emplace_back(n, i);
    }
  }
  return sides;
}

Vec3 area_vector(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
}

/// Edges inside a flat face: their middles are no points of a round body, and they can lie otherwise.
std::set<Key> flat_edges(const TriangleMesh& mesh, const Sides& sides) {
  constexpr double flat = 0.5 * M_PI / 180.0;
  std::set<Key> edges;
  for (const auto& [key, facets] : sides) {
    if (facets.size() != 2) {
      continue;
    }
    const Vec3 a = area_vector(mesh, mesh.triangles[facets[0].first]);
    const Vec3 b = area_vector(mesh, mesh.triangles[facets[1].first]);
    if (std::atan2(a.cross(b).norm(), a.dot(b)) < flat) {
      edges.insert(key);
    }
  }
  return edges;
}

/// Of the edges that are not flat; length 0 if all are.
Length longest_edge(const TriangleMesh& mesh, const std::array<int, 3>& t, const std::set<Key>& flat) {
  Length longest;
  for (int i = 0; i < 3; ++i) {
    const Length edge = length_of(mesh, t[i], t[(i + 1) % 3]);
    if (flat.count({edge.a, edge.b}) == 0) {
      longest = std::max(longest, edge);
    }
  }
  return longest;
}

/// Lays flat edges between long triangles along the shorter diagonal of their two facets. Returns whether any was laid.
bool flip_flat_edges(const std::vector<char>& long_ones, TriangleMesh* mesh) {
  constexpr double shorter = 0.999;
  const Sides sides = sides_of(*mesh);
  std::vector<char> touched(mesh->triangles.size(), 0);
  bool any = false;
  for (const Key& key : flat_edges(*mesh, sides)) {
    const auto [n, i] = sides.at(key)[0];
    const auto [m, j] = sides.at(key)[1];
    if (touched[n] != 0 || touched[m] != 0 || long_ones[n] == 0 || long_ones[m] == 0) {
      continue;
    }
    const int a = mesh->triangles[n][i], b = mesh->triangles[n][(i + 1) % 3];
    const int p = mesh->triangles[n][(i + 2) % 3], q = mesh->triangles[m][(j + 2) % 3];
    const Vec3 normal = area_vector(*mesh, mesh->triangles[n]);
    const bool convex =
        area_vector(*mesh, {a, q, p}).dot(normal) > 0.0 && area_vector(*mesh, {q, b, p}).dot(normal) > 0.0;
    if (!convex || sides.count(std::minmax(p, q)) > 0 ||
        length_of(*mesh, p, q).length > shorter * length_of(*mesh, a, b).length) {
      continue;
    }
    mesh->triangles[n] = {a, q, p};
    mesh->triangles[m] = {q, b, p};
    touched[n] = touched[m] = 1;
    any = true;
  }
  return any;
}

/// Edges that are too long and the longest of all triangles that they belong to, with the number of the vertex that
/// will be their middle. `long_ones`: triangles to cut.
std::map<Key, int> edges_to_cut(const std::vector<char>& long_ones, const TriangleMesh& mesh) {
  const Sides sides = sides_of(mesh);
  const std::set<Key> flat = flat_edges(mesh, sides);
  std::vector<Length> longest;
  for (const auto& t : mesh.triangles) {
    longest.push_back(longest_edge(mesh, t, flat));
  }
  std::map<Key, int> middles;
  for (const auto& [key, facets] : sides) {
    double widest = 0.0;
    bool is_cut = false, is_longest = true;
    for (const auto& [n, i] : facets) {
      is_longest = is_longest && key == Key(longest[n].a, longest[n].b);
      is_cut = is_cut || long_ones[n] != 0;
      widest = std::max(widest, width(mesh, mesh.triangles[n], longest[n].length));
    }
    const double length = length_of(mesh, key.first, key.second).length;
    if (is_cut && is_longest && is_longer(length, short_enough, wanted, widest)) {
      const auto vertex = static_cast<int>(mesh.vertices.size() + middles.size());
      middles[key] = vertex;
    }
  }
  return middles;
}

/// Side of a triangle that is cut, or 3.
int cut_side(const std::array<int, 3>& t, const std::map<Key, int>& middles) {
  int i = 0;
  while (i < 3 && middles.count(std::minmax(t[i], t[(i + 1) % 3])) == 0) {
    ++i;
  }
  return i;
}

/// Makes two triangles of one whose side `i` has this middle.
void cut(std::size_t n, int i, int middle, std::vector<char>* long_ones, TriangleMesh* mesh) {
  const std::array<int, 3> t = mesh->triangles[n];
  mesh->triangles[n] = {t[i], middle, t[(i + 2) % 3]};
  mesh->triangles.push_back({middle, t[(i + 1) % 3], t[(i + 2) % 3]});
  long_ones->push_back((*long_ones)[n]);
}

/// Normal of the long triangles at a vertex that face a direction: those of a cap, or beyond a crease, have no say.
Vec3 normal_at(const TriangleMesh& mesh, const std::vector<std::size_t>& long_ones, const Vec3& direction) {
  constexpr double facing = 0.5;  // cosine
  Vec3 sum = Vec3::Zero();
  for (const std::size_t n : long_ones) {
    const Vec3 area = area_vector(mesh, mesh.triangles[n]);
    if (area.dot(direction) > facing * area.norm()) sum += area;
  }
  return sum.normalized();
}

/// How far the middle of an edge between long triangles lies inside a round body that both ends lie on, the largest,
/// mm: length / 8 times what the normal turns along the edge.
double deepest_chord(const TriangleMesh& mesh, const std::vector<char>& long_ones) {
  std::vector<std::vector<std::size_t>> at(mesh.vertices.size());
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    if (long_ones[n] == 0) continue;
    for (const int v : mesh.triangles[n]) at[v].push_back(n);
  }
  const Sides sides = sides_of(mesh);
  const std::set<Key> flat = flat_edges(mesh, sides);
  double deepest = 0.0;
  for (const auto& [key, facets] : sides) {
    if (facets.size() != 2 || long_ones[facets[0].first] == 0 || long_ones[facets[1].first] == 0) continue;
    if (flat.count(key) > 0) continue;
    const Vec3 direction = (area_vector(mesh, mesh.triangles[facets[0].first]).normalized() +
                            area_vector(mesh, mesh.triangles[facets[1].first]).normalized())
                               .normalized();
    const Vec3 along = mesh.vertices[key.second] - mesh.vertices[key.first];
    const Vec3 turn = normal_at(mesh, at[key.second], direction) - normal_at(mesh, at[key.first], direction);
    deepest = std::max(deepest, along.dot(turn) / 8.0);
  }
  return deepest;
}

}  // namespace

double split_long_triangles(TriangleMesh* mesh) {
  std::vector<char> long_ones;
  for (const auto& t : mesh->triangles) {
    const double longest = longest_edge(*mesh, t, {}).length;
    long_ones.push_back(is_long(longest, width(*mesh, t, longest)) ? 1 : 0);
  }
  if (std::count(long_ones.begin(), long_ones.end(), 1) == 0) {
    return 0.0;
  }
  const double deepest = deepest_chord(*mesh, long_ones);
  while (true) {
    while (flip_flat_edges(long_ones, mesh)) {
    }
    const std::map<Key, int> middles = edges_to_cut(long_ones, *mesh);
    if (middles.empty()) {
      return deepest;
    }
    mesh->vertices.resize(mesh->vertices.size() + middles.size());
    for (const auto& [key, middle] : middles) {
      mesh->vertices[middle] = 0.5 * (mesh->vertices[key.first] + mesh->vertices[key.second]);
    }
    const std::size_t count = mesh->triangles.size();
    for (std::size_t n = 0; n < count; ++n) {
      const std::array<int, 3> t = mesh->triangles[n];
      if (const int i = cut_side(t, middles); i < 3) {
        cut(n, i, middles.at(std::minmax(t[i], t[(i + 1) % 3])), &long_ones, mesh);
      }
    }
  }
}

}  // namespace toile::body
