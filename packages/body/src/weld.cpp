#include "weld.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "mesh_geometry.hpp"

namespace toile::body {
namespace {

struct Border {
  std::vector<int> points;
  std::set<std::pair<int, int>> edges;
  double length = 0.0;
};

Border border_of(const PolygonSoup& soup) {
  Border border;
  for (const MeshEdge& edge : mesh_edges(soup.polygons)) {
    if (edge.count() == 1) {
      border.points.push_back(edge.a);
      border.points.push_back(edge.b);
      border.edges.emplace(edge.a, edge.b);
      border.length += (soup.points[edge.a] - soup.points[edge.b]).norm();
    }
  }
  std::sort(border.points.begin(), border.points.end());
  border.points.erase(std::unique(border.points.begin(), border.points.end()), border.points.end());
  return border;
}

}  // namespace

double mean_border_edge(const PolygonSoup& soup) {
  const Border border = border_of(soup);
  return border.edges.empty() ? 0.0 : border.length / static_cast<double>(border.edges.size());
}

NearCopies near_copies(PolygonSoup* soup, double distance, bool snap) {
  const Border border = border_of(*soup);
  NearCopies result;
  result.border = static_cast<int>(border.points.size());
  // Sorted along a direction that no face of a body is likely to be square to, only few come into question.
  const Vec3 direction = Vec3(0.5281, 0.7013, 0.4787).normalized();
  std::vector<std::pair<double, int>> sorted;
  for (const int point : border.points) {
    sorted.emplace_back(soup->points[point].dot(direction), point);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> group(soup->points.size());
  std::iota(group.begin(), group.end(), 0);
  const auto first_of = [&group](int point) {
    while (group[point] != point) {
      point = group[point] = group[group[point]];
    }
    return point;
  };
  std::set<int> found;
  for (auto one = sorted.begin(); one != sorted.end(); ++one) {
    for (auto other = one + 1; other != sorted.end() && other->first <= one->first + distance; ++other) {
      const int a = std::min(one->second, other->second), b = std::max(one->second, other->second);
      const double apart = (soup->points[a] - soup->points[b]).norm();
      if (apart <= distance && border.edges.count({a, b}) == 0) {
        const int first = first_of(a), second = first_of(b);
        group[std::max(first, second)] = std::min(first, second);
        found.insert({a, b});
        result.largest = std::max(result.largest, apart);
      }
    }
  }
  result.count = static_cast<int>(found.size());
  if (snap) {
    for (const int point : found) {
      soup->points[point] = soup->points[first_of(point)];
    }
  }
  return result;
}

}  // namespace toile::body
