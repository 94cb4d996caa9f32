#include "figure/cut_limb.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "pieces.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

/// What is kept of a mesh, with the curve along which it was cut.
class LimbCut {
 public:
  LimbCut(const TriangleMesh& mesh, const std::vector<char>& off, const Vec3& point, const Vec3& normal)
      : mesh_(mesh), off_(off), point_(point), normal_(normal), number_(mesh.vertices.size(), -1) {
    for (const auto& t : mesh.triangles) {
      add(t);
    }
  }
  TriangleMesh kept;
  std::map<int, int> rim;  ///< vertex after vertex, in the direction of the kept facets

 private:
  int vertex(int v) {
    if (number_[v] < 0) {
      number_[v] = static_cast<int>(kept.vertices.size());
      kept.vertices.push_back(mesh_.vertices[v]);
    }
    return number_[v];
  }
  int crossing(int a, int b) {
    const auto [it, added] = crossings_.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (added) {
      // Not nearer to an end than this, for the facets' sake.
      constexpr double least = 0.02;
      const double da = (mesh_.vertices[a] - point_).dot(normal_), db = (mesh_.vertices[b] - point_).dot(normal_);
      const double share = std::clamp(da / (da - db), least, 1.0 - least);
      it->second = static_cast<int>(kept.vertices.size());
      kept.vertices.push_back(mesh_.vertices[a] + share * (mesh_.vertices[b] - mesh_.vertices[a]));
    }
    return it->second;
  }
  void add(const std::array<int, 3>& t) {
    std::vector<int> polygon;
    int enters = -1, leaves = -1;
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (!off_[a]) {
        polygon.push_back(vertex(a));
      }
      if (off_[a] != off_[b]) {
        polygon.push_back(crossing(a, b));
        (off_[a] ? enters : leaves) = polygon.back();
      }
    }
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      kept.triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
    }
    if (leaves >= 0) {
      rim[leaves] = enters;
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<char>& off_;
  Vec3 point_, normal_;
  std::vector<int> number_;
  std::map<std::pair<int, int>, int> crossings_;
};

/// Half of an ellipsoid over the rim.
void add_cap(const std::vector<int>& rim, const Vec3& normal, double height, double edge, TriangleMesh* mesh) {
  Vec3 centre = Vec3::Zero();
  double length = 0.0;
  const int count = static_cast<int>(rim.size());
  for (int i = 0; i < count; ++i) {
    const Vec3 &a = mesh->vertices[rim[i]], &b = mesh->vertices[rim[(i + 1) % count]];
    centre += (b - a).norm() * 0.5 * (a + b);
    length += (b - a).norm();
  }
  centre /= length;
  const double radius = length / (2.0 * M_PI), rise = height * radius;
  const int rings = std::max(2, static_cast<int>(std::ceil(0.5 * M_PI * std::max(radius, rise) / edge)));
  std::vector<int> last = rim;
  for (int k = 1; k < rings; ++k) {
    const double angle = 0.5 * M_PI * k / rings;
    std::vector<int> ring;
    for (const int v : rim) {
      ring.push_back(static_cast<int>(mesh->vertices.size()));
      mesh->vertices.push_back(centre + std::cos(angle) * (mesh->vertices[v] - centre) +
                               std::sin(angle) * rise * normal);
    }
    for (int i = 0; i < count; ++i) {
      const int j = (i + 1) % count;
      mesh->triangles.push_back({last[j], last[i], ring[i]});
      mesh->triangles.push_back({last[j], ring[i], ring[j]});
    }
    last = ring;
  }
  const int pole = static_cast<int>(mesh->vertices.size());
  mesh->vertices.push_back(centre + rise * normal);
  for (int i = 0; i < count; ++i) {
    mesh->triangles.push_back({last[(i + 1) % count], last[i], pole});
  }
}

std::vector<std::vector<int>> closed_curves(std::map<int, int> next) {
  std::vector<std::vector<int>> curves;
  while (!next.empty()) {
    std::vector<int> curve;
    const int first = next.begin()->first;
    int v = first;
    for (auto it = next.find(v); it != next.end(); it = next.find(v)) {
      curve.push_back(v);
      v = it->second;
      next.erase(it);
    }
    if (v == first && curve.size() > 2) {
      curves.push_back(curve);
    }
  }
  return curves;
}

double length_of(const std::vector<int>& curve, const TriangleMesh& mesh) {
  double length = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    length += (mesh.vertices[curve[(i + 1) % curve.size()]] - mesh.vertices[curve[i]]).norm();
  }
  return length;
}

/// The connected piece that holds a vertex.
TriangleMesh piece_of(int vertex, const TriangleMesh& mesh) {
  Pieces pieces(mesh.vertices.size(), mesh.triangles);
  const int wanted = pieces.of({vertex, vertex, vertex});
  TriangleMesh piece;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (auto t : mesh.triangles) {
    if (pieces.of(t) != wanted) {
      continue;
    }
    for (int& v : t) {
      if (number[v] < 0) {
        number[v] = static_cast<int>(piece.vertices.size());
        piece.vertices.push_back(mesh.vertices[v]);
      }
      v = number[v];
    }
    piece.triangles.push_back(t);
  }
  return piece;
}

std::string shown(const Vec3& point) {
  std::ostringstream text;
  text.precision(4);
  text << '(' << point.x() << ", " << point.y() << ", " << point.z() << ") mm";
  return text.str();
}

}  // namespace

std::vector<char> beyond(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal) {
  std::vector<std::vector<int>> neighbours(mesh.vertices.size());
  const auto side = [&](int v) { return (mesh.vertices[v] - point).dot(normal); };
  int start = -1;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      if (side(a) > 0.0 && side(b) > 0.0) {
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
      } else if (side(a) > 0.0 || side(b) > 0.0) {
        const int outer = side(a) > 0.0 ? a : b;
        if (start < 0 || (mesh.vertices[outer] - point).norm() < (mesh.vertices[start] - point).norm()) {
          start = outer;
        }
      }
    }
  }
  std::vector<char> marked(mesh.vertices.size(), 0);
  if (start < 0) {
    return marked;
  }
  std::vector<int> front = {start};
  marked[start] = 1;
  while (!front.empty()) {
    const int v = front.back();
    front.pop_back();
    for (const int other : neighbours[v]) {
      if (!marked[other]) {
        marked[other] = 1;
        front.push_back(other);
      }
    }
  }
  return marked;
}

TriangleMesh cut_off(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal, double height, double edge) {
  LimbCut cut(mesh, beyond(mesh, point, normal), point, normal);
  const std::vector<std::vector<int>> rims = closed_curves(cut.rim);
  const auto longest = std::max_element(rims.begin(), rims.end(), [&cut](const auto& a, const auto& b) {
    return length_of(a, cut.kept) < length_of(b, cut.kept);
  });
  if (longest == rims.end()) {
    throw base::InputError("the body cannot be cut at " + shown(point) + ": its section there is not closed");
  }
  const int rim_vertex = longest->front();
  Pieces pieces(cut.kept.vertices.size(), cut.kept.triangles);
  const auto piece = [&pieces](const std::vector<int>& rim) { return pieces.of({rim[0], rim[0], rim[0]}); };
  for (const std::vector<int>& rim : rims) {
    if (&rim != &*longest && piece(rim) == piece(*longest)) {
      throw base::InputError("the body cannot be cut at " + shown(point) + ": its section there has several parts");
    }
  }
  add_cap(*longest, normal, height, edge, &cut.kept);
  // What is left of hollows, as a throat, is no part of it.
  return piece_of(rim_vertex, cut.kept);
}

}  // namespace toile::body
