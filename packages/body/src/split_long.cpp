#include <Eigen/Geometry>
#include <algorithm>
#include <map>
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

Length longest_edge(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return std::max({length_of(mesh, t[0], t[1]), length_of(mesh, t[1], t[2]), length_of(mesh, t[2], t[0])});
}

double width(const TriangleMesh& mesh, const std::array<int, 3>& t, double longest) {
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / longest;
}

constexpr double short_enough = 15.0;  // mm

bool is_longer(double length, double times, double width_of_triangle) {
  return length > std::max(short_enough, times * width_of_triangle);
}

using Key = std::pair<int, int>;

/// Middles of the edges that are too long and the longest of all triangles that they belong to. `long_ones`: triangles
/// to cut.
std::map<Key, int> place_middles(const std::vector<char>& long_ones, TriangleMesh* mesh) {
  constexpr double wanted = 4.0;  // length for its width
  struct Longest {
    double width = 0.0;
    int triangles = 0;
    bool is_cut = false;
  };
  std::map<Key, Longest> longest;
  for (std::size_t n = 0; n < mesh->triangles.size(); ++n) {
    const Length edge = longest_edge(*mesh, mesh->triangles[n]);
    Longest& entry = longest[{edge.a, edge.b}];
    entry.width = std::max(entry.width, width(*mesh, mesh->triangles[n], edge.length));
    entry.is_cut = entry.is_cut || long_ones[n] != 0;
    ++entry.triangles;
  }
  std::map<Key, int> uses;
  for (const auto& t : mesh->triangles) {
    for (int i = 0; i < 3; ++i) {
      ++uses[std::minmax(t[i], t[(i + 1) % 3])];
    }
  }
  std::map<Key, int> middles;
  for (const auto& [key, entry] : longest) {
    const Vec3 a = mesh->vertices[key.first], b = mesh->vertices[key.second];
    if (entry.is_cut && uses.at(key) == entry.triangles && is_longer((a - b).norm(), wanted, entry.width)) {
      middles[key] = static_cast<int>(mesh->vertices.size());
      mesh->vertices.push_back(0.5 * (a + b));
    }
  }
  return middles;
}

}  // namespace

void split_long_triangles(TriangleMesh* mesh) {
  constexpr double too_long = 10.0;  // for its width; scans and modelled bodies have next to none
  std::vector<char> long_ones;
  for (const auto& t : mesh->triangles) {
    const double longest = longest_edge(*mesh, t).length;
    long_ones.push_back(is_longer(longest, too_long, width(*mesh, t, longest)) ? 1 : 0);
  }
  while (std::count(long_ones.begin(), long_ones.end(), 1) > 0) {
    const std::map<Key, int> middles = place_middles(long_ones, mesh);
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
          long_ones.push_back(long_ones[n]);
          break;
        }
      }
    }
  }
}

}  // namespace toile::body
