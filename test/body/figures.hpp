#pragma once

#include <vector>

#include "toile/body/surface.hpp"

namespace toile::test {

/// Prism over a closed outline (counter-clockwise seen from above, star-shaped as seen from its first point), standing
/// at `foot`, with a row of vertices every 10 mm or so.
inline body::TriangleMesh closed_tube(const std::vector<body::Vec3>& outline, double height,
                                      const body::Vec3& foot = body::Vec3::Zero()) {
  const int around = static_cast<int>(outline.size()), rows = static_cast<int>(height / 10.0);
  body::TriangleMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (const body::Vec3& p : outline) mesh.vertices.push_back(foot + p + body::Vec3(0.0, 0.0, height * j / rows));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  for (int i = 1; i + 1 < around; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({rows * around, rows * around + i, rows * around + i + 1});
  }
  return mesh;
}

inline body::TriangleMesh joined(body::TriangleMesh first, const body::TriangleMesh& second) {
  const int start = static_cast<int>(first.vertices.size());
  first.vertices.insert(first.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const auto& t : second.triangles) first.triangles.push_back({t[0] + start, t[1] + start, t[2] + start});
  return first;
}

}  // namespace toile::test
