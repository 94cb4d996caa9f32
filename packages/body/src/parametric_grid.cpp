#include "parametric_grid.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

void add_rings(int columns, int first_row, int last_row, int rows, const Chart& chart, TriangleMesh* mesh) {
  for (int j = first_row; j <= last_row; ++j) {
    for (int i = 0; i < columns; ++i) {
      mesh->vertices.push_back(chart(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  }
  for (int j = 0; j < last_row - first_row; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * columns + i;
      const int b = j * columns + (i + 1) % columns;
      mesh->triangles.push_back({a, b, b + columns});
      mesh->triangles.push_back({a, b + columns, a + columns});
    }
  }
}

}  // namespace

int divisions(double length, double size, int least) {
  constexpr double most = 2000.0;
  if (!(length / size <= most)) {
    std::ostringstream text;
    text << "triangles of " << size << " mm would cut " << length << " mm of the body into more than " << most
         << " parts";
    throw base::InputError(text.str());
  }
  return std::max(least, static_cast<int>(std::ceil(length / size)));
}

TriangleMesh tube(int columns, int rows, const Chart& chart) {
  TriangleMesh mesh;
  add_rings(columns, 0, rows, rows, chart, &mesh);
  return mesh;
}

TriangleMesh capped_tube(int columns, int rows, const Chart& chart) {
  TriangleMesh mesh;
  add_rings(columns, 1, rows - 1, rows, chart, &mesh);
  const int bottom = static_cast<int>(mesh.vertices.size());
  const int last_ring = bottom - columns;
  mesh.vertices.push_back(chart(0.0, 0.0));
  mesh.vertices.push_back(chart(0.0, 1.0));
  for (int i = 0; i < columns; ++i) {
    const int next = (i + 1) % columns;
    mesh.triangles.push_back({bottom, next, i});
    mesh.triangles.push_back({bottom + 1, last_ring + i, last_ring + next});
  }
  return mesh;
}

}  // namespace toile::body
