#include "import_checks.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <sstream>

#include "mesh_geometry.hpp"
#include "nested.hpp"
#include "toile/base/error.hpp"
#include "up_axis.hpp"
#include "weld.hpp"

namespace toile::body {
namespace {

struct Unit {
  const char* name;
  double mm;
};

constexpr std::array<Unit, 5> units{{{"mm", 1.0}, {"cm", 10.0}, {"inches", 25.4}, {"feet", 304.8}, {"m", 1000.0}}};

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

/// The three axes of the file that a height may lie along, the longest first, as (name, length, the other lengths).
struct Reading {
  const char* up;
  Vec3 lengths;  ///< height last, unit of the file
};

std::vector<Reading> readings(const Vec3& lengths, const ImportOptions& options) {
  const Vec3 raw = in_axes_of_file(lengths, options.up).cwiseAbs() / options.scale;
  std::vector<Reading> result;
  for (const auto& [name, up] : {std::pair("z", Axis::z), {"y", Axis::y}, {"x", Axis::x}}) {
    if (!options.up_is_known || up == options.up) {
      result.push_back({name, turned_up(raw, up).cwiseAbs()});
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Reading& a, const Reading& b) { return a.lengths.z() > b.lengths.z(); });
  return result;
}

/// Every unit and height axis that give an allowed height: a wrong one must not be the only answer.
std::string possible_units(const Vec3& lengths, const ImportOptions& options) {
  std::ostringstream text;
  text.precision(4);
  for (const Reading& reading : readings(lengths, options)) {
    const double widest = std::max(reading.lengths.x(), reading.lengths.y());
    if (widest > 1.5 * reading.lengths.z()) {
      continue;
    }
    for (const Unit& unit : units) {
      const double height = unit.mm * reading.lengths.z();
      if (height >= options.least_height && height <= options.greatest_height) {
        text << (text.str().empty() ? "" : "; ") << unit.name << " with " << reading.up << " up ("
             << shown_extents(unit.mm * reading.lengths) << " mm): \"scale\" = " << unit.mm;
        if (std::string(reading.up) != "z") {
          text << ", \"up\" = \"" << reading.up << "\"";
        }
      }
    }
  }
  return text.str().empty() ? "No usual unit makes a body of it. "
                            : "The file may be in " + text.str() + ": you have to know which. ";
}

}  // namespace

Vec3 extents(const PolygonSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const auto& polygon : soup.polygons) {
    for (const std::size_t corner : polygon) {
      box.extend(soup.points[corner]);
    }
  }
  return box.sizes();
}

std::string shown_extents(const Vec3& lengths) {
  std::ostringstream text;
  text.precision(4);
  text << lengths.x() << " x " << lengths.y() << " x " << lengths.z();
  return text.str();
}

void check_extents(const std::string& file, const PolygonSoup& soup, const ImportOptions& options) {
  constexpr double lying = 1.5;  // a standing body with its arms spread is hardly wider than high
  constexpr double far = 10.0;   // of the greatest height: something lies beside the body
  const Vec3 lengths = extents(soup);
  const double height = lengths.z(), widest = std::max(lengths.x(), lengths.y());
  const bool is_high = height >= options.least_height && height <= options.greatest_height;
  const bool may_lie = options.up_is_known || widest <= lying * height;
  if (is_high && may_lie && widest <= far * options.greatest_height) {
    return;
  }
  std::ostringstream text;
  text.precision(4);
  text << file << ": the body is " << height << " mm high (z); allowed is " << options.least_height << " to "
       << options.greatest_height << " mm. Its extents in x, y, z are " << shown_extents(lengths) << " mm";
  if (options.scale != 1.0 || options.up != Axis::z) {
    text << " after \"scale\" and \"up\"";
  }
  if (!may_lie) {
    text << "; it seems to lie, for " << (lengths.x() > lengths.y() ? "x" : "y") << " is the longest";
  }
  text << ". " << possible_units(lengths, options)
       << "Parameter \"scale\" turns the unit of the file into mm, \"up\" says which axis of the file is the height"
          " (\"up\" = \"z\": it is z, though it is not the longest), \"height range\" what is allowed";
  throw base::InputError(text.str());
}

std::optional<OtherUnit> person_in_another_unit(double height, double scale) {
  constexpr double least = 1400.0, greatest = 2100.0;  // mm
  constexpr double clearly = 1.2;
  if (height > least / clearly && height < greatest * clearly) {
    return std::nullopt;
  }
  for (const Unit& unit : units) {
    const double other = height / scale * unit.mm;
    if (other > least && other < greatest) {
      return OtherUnit{unit.name, unit.mm, other};
    }
  }
  return std::nullopt;
}

void check_manifold(const std::string& file, const PolygonSoup& soup) {
  refuse_edges(
      file, soup, "not manifold, more than two facets meet",
      "Each edge must belong to two facets. Pieces that touch along an edge are to be joined into one, or moved "
      "apart; a wall that is there twice is to be there once.",
      [](const MeshEdge& edge) { return edge.count() > 2; });
}

void check_closed(const std::string& file, PolygonSoup soup) {
  constexpr double near = 0.05;  // of the border's edges
  const NearCopies copies = near_copies(&soup, near * mean_border_edge(soup), false);
  std::ostringstream remedy;
  if (copies.count > 0) {
    remedy.precision(2);
    remedy << copies.count << " of the " << copies.border
           << " vertices on borders nearly coincide with another one (up to " << copies.largest
           << " mm apart): they may be copies of one vertex that were rounded differently. Parameter "
           << "\"weld\" = " << 1.1 * copies.largest << " makes them one. ";
  }
  remedy << "Close it, or set parameter \"closed\" = false if a tube with open ends is meant.";
  refuse_edges(file, soup, "the surface is open, it has a border", remedy.str(),
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
  int pieces = 0;
  const std::vector<int> piece = number_pieces(*mesh, &pieces);
  const std::vector<double> volumes = signed_volumes(*mesh, piece, pieces);
  const auto reversed = std::count_if(volumes.begin(), volumes.end(), [](double volume) { return volume < 0.0; });
  if (reversed > 0 && !options.repair_orientation) {
    throw base::InputError(file + ": the body is reversed (inside-out): the facets of " + std::to_string(reversed) +
                           " of " + std::to_string(pieces) +
                           " connected pieces look inwards. Parameter \"repair orientation\" = true turns them.");
  }
  for (std::size_t t = 0; t < piece.size(); ++t) {
    if (volumes[piece[t]] < 0.0) {
      std::swap(mesh->triangles[t][1], mesh->triangles[t][2]);
    }
  }
  return static_cast<int>(reversed);
}

}  // namespace toile::body
