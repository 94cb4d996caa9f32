#include <Eigen/Geometry>
#include <algorithm>
#include <map>

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

Length longest_edge(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return std::max({length_of(mesh, t[0], t[1]), length_of(mesh, t[1], t[2]), length_of(mesh, t[2], t[0])});
}

double width(const TriangleMesh& mesh, const std::array<int, 3>& t, double longest) {
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / longest;
}

using Key = std::pair<int, int>;

/// Middles of the edges that are too long and the longest of all triangles that they belong to.
std::map<Key, int> place_middles(TriangleMesh* mesh) {
  constexpr double long_for_its_width = 4.0;
  constexpr double short_enough = 15.0;  // mm
  struct Longest {
    double width = 0.0;
    int triangles = 0;
  };
  std::map<Key, Longest> longest;
  for (const auto& t : mesh->triangles) {
    const Length edge = longest_edge(*mesh, t);
    Longest& entry = longest[{edge.a, edge.b}];
    entry.width = std::max(entry.width, width(*mesh, t, edge.length));
    ++entry.triangles;
  }
  std::map<Key, int> uses;
  for (const auto& t : mesh->triangles) {
    for (int i = 0; i < 3; ++i) {
      const Key key = std::minmax(t[i], t[(i + 1) % 3]);
      if (longest.count(key) > 0) ++uses[key];
    }
  }
  std::map<Key, int> middles;
  for (const auto& [key, entry] : longest) {
    const Vec3 a = mesh->vertices[key.first], b = mesh->vertices[key.second];
    if ((a - b).norm() > std::max(short_enough, long_for_its_width * entry.width) && uses.at(key) == entry.triangles) {
      middles[key] = static_cast<int>(mesh->vertices.size());
      mesh->vertices.push_back(0.5 * (a + b));
    }
  }
  return middles;
}

}  // namespace

void split_long_triangles(TriangleMesh* mesh) {
  for (;;) {
    const std::map<Key, int> middles = place_middles(mesh);
    if (middles.empty()) {
      return;
    }
    const std::size_t count = mesh->triangles.size();
    for (std::size_t n = 0; n < count; ++n) {
      const auto t = mesh->triangles[n];
      for (int i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
        const auto middle = middles.find(std::minmax(a, b));
        if (middle != middles.end()) {
          mesh->triangles[n] = {a, middle->second, c};
          mesh->triangles.push_back({middle->second, b, c});
          break;
        }
      }
    }
  }
}

}  // namespace toile::body
