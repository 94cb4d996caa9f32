#include "nested.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "pieces.hpp"

namespace toile::body {
namespace {

constexpr int most_outer = 100;  ///< pieces, the largest ones, that others are looked for in

struct Piece {
  std::vector<int> triangles, vertices;
  Eigen::AlignedBox3d box;
};

std::vector<Piece> collect(const TriangleMesh& mesh, const std::vector<int>& number, int count) {
  std::vector<Piece> pieces(count);
  std::vector<char> seen(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < number.size(); ++t) {
    Piece& piece = pieces[number[t]];
    piece.triangles.push_back(static_cast<int>(t));
    for (const int v : mesh.triangles[t]) {
      if (seen[v] == 0) {
        seen[v] = 1;
        piece.vertices.push_back(v);
        piece.box.extend(mesh.vertices[v]);
      }
    }
  }
  return pieces;
}

/// How often the piece winds round the point: 1 or -1 inside a closed surface, 0 outside; less than one half where an
/// opening is nearer than the surface (van Oosterom, Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125).
double winding(const TriangleMesh& mesh, const Piece& piece, const Vec3& point) {
  double sum = 0.0;
  for (const int t : piece.triangles) {
    const auto& corners = mesh.triangles[t];
    const Vec3 a = mesh.vertices[corners[0]] - point, b = mesh.vertices[corners[1]] - point,
               c = mesh.vertices[corners[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2.0 * M_PI);
}

/// Whether `inner` lies inside `outer`, by as many of its vertices as the work for them allows.
bool holds(const TriangleMesh& mesh, const Piece& outer, const Piece& inner) {
  constexpr double work = 2e7;
  constexpr std::size_t fewest = 16;
  constexpr double least = 0.4, least_mean = 0.6;  // a vertex at an open end has one half
  if (!outer.box.contains(inner.box)) {
    return false;
  }
  const auto most = std::max(fewest, static_cast<std::size_t>(work / static_cast<double>(outer.triangles.size())));
  const std::size_t stride = 1 + (inner.vertices.size() - 1) / most;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < inner.vertices.size(); i += stride) {
    const double turns = std::abs(winding(mesh, outer, mesh.vertices[inner.vertices[i]]));
    if (turns < least) {
      return false;
    }
    sum += turns;
    ++count;
  }
  return sum > least_mean * count;
}

bool cross(const std::vector<Crossing>& crossings, int a, int b) {
  const std::pair wanted(std::min(a, b), std::max(a, b));
  const auto pieces = [](const Crossing& crossing) { return std::pair(crossing.first, crossing.second); };
  const auto at = std::lower_bound(crossings.begin(), crossings.end(), wanted,
                                   [&pieces](const Crossing& c, const auto& pair) { return pieces(c) < pair; });
  return at != crossings.end() && pieces(*at) == wanted;
}

}  // namespace

std::vector<int> number_pieces(const TriangleMesh& mesh, int* count) {
  Pieces pieces(mesh.vertices.size(), mesh.triangles);
  std::map<int, int> numbers;
  std::vector<int> result;
  result.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    result.push_back(numbers.try_emplace(pieces.of(t), static_cast<int>(numbers.size())).first->second);
  }
  *count = static_cast<int>(numbers.size());
  return result;
}

std::vector<double> signed_volumes(const TriangleMesh& mesh, const std::vector<int>& piece, int pieces) {
  std::vector<std::pair<Vec3, int>> centres(pieces, {Vec3::Zero(), 0});
  for (std::size_t t = 0; t < piece.size(); ++t) {
    auto& [sum, count] = centres[piece[t]];
    for (const int v : mesh.triangles[t]) {
      sum += mesh.vertices[v];
      ++count;
    }
  }
  std::vector<double> volumes(pieces, 0.0);
  for (std::size_t t = 0; t < piece.size(); ++t) {
    const Vec3 centre = centres[piece[t]].first / centres[piece[t]].second;
    const auto& corners = mesh.triangles[t];
    const Vec3 &a = mesh.vertices[corners[0]], &b = mesh.vertices[corners[1]], &c = mesh.vertices[corners[2]];
    volumes[piece[t]] += (a - centre).dot((b - centre).cross(c - centre)) / 6.0;
  }
  return volumes;
}

Nested find_nested(const TriangleMesh& mesh, const std::vector<Crossing>& crossings) {
  Nested nested;
  int count = 0;
  const std::vector<int> number = number_pieces(mesh, &count);
  std::vector<char>& inside = nested.inside;
  inside.assign(count, 0);
  if (count < 2) {
    return nested;
  }
  const std::vector<Piece> pieces = collect(mesh, number, count);
  const std::vector<double> volumes = signed_volumes(mesh, number, count);
  std::vector<int> largest(count);
  std::iota(largest.begin(), largest.end(), 0);
  std::sort(largest.begin(), largest.end(),
            [&volumes](int a, int b) { return std::abs(volumes[a]) > std::abs(volumes[b]); });
  for (int i = 0; i < count; ++i) {
    const int inner = largest[i];
    for (int k = 0; k < std::min(i, most_outer) && inside[inner] == 0; ++k) {
      if (holds(mesh, pieces[largest[k]], pieces[inner]) && !cross(crossings, largest[k], inner)) {
        inside[inner] = 1;
        (volumes[inner] * volumes[largest[k]] < 0.0 ? nested.cavities : nested.solids) += 1;
      }
    }
  }
  return nested;
}

void drop(const Nested& nested, TriangleMesh* mesh) {
  int count = 0;
  const std::vector<int> number = number_pieces(*mesh, &count);
  std::vector<std::array<int, 3>> kept;
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (nested.inside[number[t]] == 0) {
      kept.push_back(mesh->triangles[t]);
    }
  }
  mesh->triangles = std::move(kept);
}

}  // namespace toile::body
