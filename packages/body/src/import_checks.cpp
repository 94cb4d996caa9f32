#include "import_checks.hpp"

#include <Eigen/Geometry>
#include <map>
#include <sstream>

#include "mesh_geometry.hpp"
#include "pieces.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

std::string at(const Vec3& p) {
  std::ostringstream text;
  text << "(" << p.x() << ", " << p.y() << ", " << p.z() << ")";
  return text.str();
}

/// Throws if any edge is bad: "<file>: <n> <what>; the first runs from (...) to (...). <remedy>".
template <class IsBad>
void refuse_edges(const std::string& file, const PolygonSoup& soup, const std::string& what, const std::string& remedy,
                  const IsBad& is_bad) {
  int bad = 0;
  const MeshEdge* first = nullptr;
  const auto edges = mesh_edges(soup.polygons);
  for (const MeshEdge& edge : edges) {
    if (is_bad(edge)) {
      ++bad;
      first = first == nullptr ? &edge : first;
    }
  }
  if (bad > 0) {
    throw base::InputError(file + ": " + what + ": " + std::to_string(bad) + " edges; the first runs from " +
                           at(soup.points[first->a]) + " to " + at(soup.points[first->b]) + ". " + remedy);
  }
}

}  // namespace

void check_height(const std::string& file, const PolygonSoup& soup, const ImportOptions& options) {
  double lower = HUGE_VAL;
  double upper = -HUGE_VAL;
  for (const Vec3& point : soup.points) {
    lower = std::min(lower, point.z());
    upper = std::max(upper, point.z());
  }
  const double height = upper - lower;
  if (height >= options.least_height && height <= options.greatest_height) {
    return;
  }
  std::ostringstream text;
  text << file << ": the body is " << height << " mm high, allowed is " << options.least_height << " to "
       << options.greatest_height << " mm";
  for (const auto& [factor, unit] : {std::pair(1000.0, "metres"), std::pair(10.0, "centimetres")}) {
    if (height * factor >= 300.0 && height * factor <= 2500.0) {
      text << "; it looks like " << unit << ": set parameter \"scale\" = " << factor * options.scale
           << ", or \"height range\" if the body is that small";
      throw base::InputError(text.str());
    }
  }
  text << "; z must be the height, and parameter \"scale\" turns the unit of the file into mm; "
          "parameter \"height range\" says what is allowed";
  throw base::InputError(text.str());
}

void check_manifold(const std::string& file, const PolygonSoup& soup) {
  refuse_edges(file, soup, "not manifold, more than two facets meet", "Each edge must belong to two facets.",
               [](const MeshEdge& edge) { return edge.count() > 2; });
}

void check_closed(const std::string& file, const PolygonSoup& soup) {
  refuse_edges(file, soup, "the surface is open, it has a border",
               "Close it, or set parameter \"closed\" = false if a tube with open ends is meant.",
               [](const MeshEdge& edge) { return edge.count() == 1; });
}

bool check_consistent(const std::string& file, const PolygonSoup& soup, const ImportOptions& options) {
  const auto clash = [](const MeshEdge& edge) { return edge.forward > 1 || edge.backward > 1; };
  if (!options.repair_orientation) {
    refuse_edges(file, soup, "neighbouring facets look to opposite sides",
                 "Parameter \"repair orientation\" = true turns them.", clash);
    return true;
  }
  const auto edges = mesh_edges(soup.polygons);
  return std::none_of(edges.begin(), edges.end(), clash);
}

int orient_outwards(const std::string& file, const ImportOptions& options, TriangleMesh* mesh) {
  Pieces pieces(mesh->vertices.size(), mesh->triangles);
  std::map<int, std::pair<Vec3, int>> centres;
  for (const auto& t : mesh->triangles) {
    auto& [sum, count] = centres.try_emplace(pieces.of(t), Vec3::Zero(), 0).first->second;
    sum += mesh->vertices[t[0]] + mesh->vertices[t[1]] + mesh->vertices[t[2]];
    count += 3;
  }
  // Seen from its own centre, a tube with open ends has a signed volume as well.
  std::map<int, double> volumes;
  for (const auto& t : mesh->triangles) {
    const int piece = pieces.of(t);
    const Vec3 centre = centres.at(piece).first / centres.at(piece).second;
    const Vec3 &a = mesh->vertices[t[0]], &b = mesh->vertices[t[1]], &c = mesh->vertices[t[2]];
    volumes[piece] += (a - centre).dot((b - centre).cross(c - centre)) / 6.0;
  }
  const auto reversed = std::count_if(volumes.begin(), volumes.end(), [](const auto& v) { return v.second < 0.0; });
  if (reversed > 0 && !options.repair_orientation) {
    throw base::InputError(file + ": the body is reversed (inside-out): the facets of " + std::to_string(reversed) +
                           " of " + std::to_string(volumes.size()) +
                           " connected pieces look inwards. Parameter \"repair orientation\" = true turns them.");
  }
  for (auto& t : mesh->triangles) {
    if (volumes.at(pieces.of(t)) < 0.0) {
      std::swap(t[1], t[2]);
    }
  }
  return static_cast<int>(reversed);
}

}  // namespace toile::body
