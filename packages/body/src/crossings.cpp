#include "crossings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "meets.hpp"
#include "nested.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

using Triangle = std::array<int, 3>;

std::vector<Eigen::AlignedBox3d> boxes(const TriangleMesh& mesh, const std::vector<int>& number, int count) {
  std::vector<Eigen::AlignedBox3d> result(count);
  for (std::size_t t = 0; t < number.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      result[number[t]].extend(mesh.vertices[v]);
    }
  }
  return result;
}

bool have_common_corner(const TriangleMesh& mesh, const Triangle& a, const Triangle& b) {
  for (const int v : a) {
    for (const int w : b) {
      if (mesh.vertices[v] == mesh.vertices[w]) {
        return true;
      }
    }
  }
  return false;
}

/// Centre of the smaller triangle.
Vec3 place_of(const TriangleMesh& mesh, const Triangle& a, const Triangle& b) {
  const auto corner = [&mesh](const Triangle& t, int i) { return mesh.vertices[t[i]]; };
  const auto area = [&corner](const Triangle& t) {
    return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
  };
  const Triangle& small = area(a) < area(b) ? a : b;
  return (corner(small, 0) + corner(small, 1) + corner(small, 2)) / 3.0;
}

std::vector<char> in_reach(const TriangleMesh& mesh, const std::vector<int>& number, int count, const Region& reach) {
  std::vector<char> result(count, 0);
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (result[number[t]] == 0 && meets(mesh, mesh.triangles[t], reach, reach.margin)) {
      result[number[t]] = 1;
    }
  }
  return result;
}

std::string piece_text(int piece, const std::vector<int>& number, const Eigen::AlignedBox3d& box) {
  std::ostringstream text;
  text.precision(4);
  text << "piece " << piece + 1 << " (" << std::count(number.begin(), number.end(), piece) << " triangles";
  for (int i = 0; i < 3; ++i) {
    text << ", "
         << "xyz"[i] << " " << box.min()[i] << " to " << box.max()[i];
  }
  return text.str() + " mm)";
}

}  // namespace

std::vector<Crossing> find_crossings(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& pairs) {
  int count = 0;
  const std::vector<int> number = number_pieces(mesh, &count);
  const auto box = boxes(mesh, number, count);
  std::map<std::pair<int, int>, Crossing> found;
  for (const auto& [s, t] : pairs) {
    const auto [first, second] = std::minmax({number[s], number[t]});
    if (first == second) {
      continue;
    }
    const Triangle &a = mesh.triangles[s], &b = mesh.triangles[t];
    if (have_common_corner(mesh, a, b) && !box[first].contains(box[second]) && !box[second].contains(box[first])) {
      continue;
    }
    Crossing& crossing =
        found.try_emplace({first, second}, Crossing{first, second, 0, place_of(mesh, a, b)}).first->second;
    ++crossing.pairs;
  }
  std::vector<Crossing> result;
  for (const auto& entry : found) {
    result.push_back(entry.second);
  }
  return result;
}

void check_apart(const std::string& file, const TriangleMesh& mesh, const std::vector<Crossing>& crossings,
                 const std::vector<char>& inside, const Region& reach) {
  constexpr std::size_t most_named = 4;
  if (crossings.empty()) {
    return;
  }
  int count = 0, pairs = 0;
  const std::vector<int> number = number_pieces(mesh, &count);
  const std::vector<char> reached = in_reach(mesh, number, count, reach);
  const Crossing* first = nullptr;
  std::set<int> pieces;
  for (const Crossing& crossing : crossings) {
    const auto counts = [&](int piece) { return reached[piece] != 0 && inside[piece] == 0; };
    if (counts(crossing.first) && counts(crossing.second)) {
      first = first == nullptr ? &crossing : first;
      pairs += crossing.pairs;
      pieces.insert({crossing.first, crossing.second});
    }
  }
  if (first == nullptr) {
    return;
  }
  const auto box = boxes(mesh, number, count);
  std::ostringstream text;
  text.precision(4);
  text << file << ": " << pieces.size() << " of the " << count << " connected pieces intersect or touch each other: ";
  std::size_t named = 0;
  for (const int piece : pieces) {
    if (++named > most_named) {
      text << " and " << pieces.size() - most_named << " more";
      break;
    }
    text << (named > 1 ? ", " : "") << piece_text(piece, number, box[piece]);
  }
  text << ". " << pairs << " pairs of facets of different pieces intersect, one of them near (" << first->place.x()
       << ", " << first->place.y() << ", " << first->place.z()
       << ") mm. Which facets are the skin cannot be told. Join the pieces into one closed surface (union) in the "
          "program that made them, or leave all but one of them out of the file. Pieces without a facet where the "
          "garment can reach (list Reach) do not count";
  throw base::InputError(text.str());
}

}  // namespace toile::body
