#include "toile/body/import.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <sstream>

#include "body_file.hpp"
#include "crossings.hpp"
#include "import_checks.hpp"
#include "nested.hpp"
#include "toile/base/error.hpp"
#include "up_axis.hpp"
#include "weld.hpp"

namespace toile::body {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

struct CgalSoup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

CgalSoup to_cgal(PolygonSoup&& plain) {
  CgalSoup soup;
  soup.polygons = std::move(plain.polygons);
  soup.points.reserve(plain.points.size());
  for (const Vec3& p : plain.points) {
    soup.points.emplace_back(p.x(), p.y(), p.z());
  }
  return soup;
}

PolygonSoup to_plain(CgalSoup&& soup) {
  PolygonSoup plain;
  plain.polygons = std::move(soup.polygons);
  plain.points.reserve(soup.points.size());
  for (const Point& p : soup.points) {
    plain.points.emplace_back(p.x(), p.y(), p.z());
  }
  return plain;
}

TriangleMesh to_triangles(const Mesh& mesh) {
  TriangleMesh result;
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    std::array<int, 3> corners{};
    int i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      corners[i++] = static_cast<int>(v.idx());
    }
    result.triangles.push_back(corners);
  }
  return result;
}

/// Pairs of triangles that intersect or touch without being neighbours, by their numbers in to_triangles.
std::vector<std::array<int, 2>> intersecting(const Mesh& mesh) {
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  pmp::self_intersections(mesh, std::back_inserter(pairs));
  std::vector<int> number(mesh.num_faces() + mesh.number_of_removed_faces());
  int count = 0;
  for (const auto f : mesh.faces()) {
    number[f.idx()] = count++;
  }
  std::vector<std::array<int, 2>> result;
  result.reserve(pairs.size());
  for (const auto& [a, b] : pairs) {
    result.push_back({number[a.idx()], number[b.idx()]});
  }
  return result;
}

void note(const std::string& text, std::string* notes) {
  *notes += (notes->empty() ? "" : ", ") + text;
}

/// Removes facets with fewer than three different corners, and repeated points and facets; returns how many facets.
std::size_t clean(PolygonSoup* plain) {
  const std::size_t before = plain->polygons.size();
  CgalSoup soup = to_cgal(std::move(*plain));
  pmp::repair_polygon_soup(soup.points, soup.polygons);
  *plain = to_plain(std::move(soup));
  return before - plain->polygons.size();
}

/// Vertices on borders that were rounded differently in different facets become one.
void weld(const ImportOptions& options, PolygonSoup* soup, std::string* notes) {
  constexpr double part_of_diagonal = 1e-5, part_of_edge = 0.02;
  const double edge = mean_border_edge(*soup);
  const double distance =
      options.weld > 0.0 ? options.weld : std::min(part_of_diagonal * extents(*soup).norm(), part_of_edge * edge);
  const NearCopies copies = near_copies(soup, distance, true);
  if (copies.count == 0) {
    return;
  }
  const std::size_t collapsed = clean(soup);
  std::ostringstream text;
  text.precision(2);
  text << copies.count << " vertices welded that were up to " << copies.largest << " mm apart (allowed " << distance
       << " mm)";
  if (collapsed > 0) {
    text << ", with them " << collapsed << " facets";
  }
  note(text.str(), notes);
}

Mesh build(const std::string& file, CgalSoup soup, std::string* notes) {
  const std::size_t points = soup.points.size();
  pmp::orient_polygon_soup(soup.points, soup.polygons);
  if (soup.points.size() > points) {
    note(std::to_string(soup.points.size() - points) + " vertices where two parts only touch were doubled", notes);
  }
  if (!pmp::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    throw base::InputError(file + ": the facets do not form a surface");
  }
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if (!pmp::triangulate_faces(mesh)) {
    throw base::InputError(file + ": a facet with more than three corners cannot be cut into triangles");
  }
  std::vector<Mesh::Face_index> flat;
  pmp::degenerate_faces(mesh, std::back_inserter(flat));
  if (!flat.empty()) {
    pmp::remove_degenerate_faces(mesh);
    mesh.collect_garbage();
    note(std::to_string(flat.size()) + " facets without area removed", notes);
  }
  return mesh;
}

}  // namespace

Import import_body(const std::string& file, const ImportOptions& options) {
  Import result;
  BodyFile read = read_body_file(file);
  PolygonSoup soup = std::move(read.soup);
  result.notes = std::move(read.notes);
  for (Vec3& point : soup.points) {
    point = options.scale * turned_up(point, options.up);
  }
  check_extents(file, soup, options);
  result.extents = extents(soup);
  if (const std::size_t removed = clean(&soup); removed > 0) {
    note(std::to_string(removed) + " degenerate or repeated facets removed", &result.notes);
  }
  weld(options, &soup, &result.notes);
  check_manifold(file, soup);
  if (options.closed) {
    check_closed(file, soup);
  }
  const bool was_consistent = check_consistent(file, soup, options);
  const Mesh mesh = build(file, to_cgal(std::move(soup)), &result.notes);
  result.mesh = to_triangles(mesh);
  const auto pairs = intersecting(mesh);
  const std::vector<Crossing> crossings = find_crossings(result.mesh, pairs);
  const Nested nested = find_nested(result.mesh, crossings);
  check_apart(file, result.mesh, crossings, nested.inside, options.reach);
  drop(nested, &result.mesh);
  if (nested.cavities + nested.solids > 0) {
    note("pieces inside another left out: " + std::to_string(nested.cavities + nested.solids) +
             " (of them cavities, whose facets look inwards: " + std::to_string(nested.cavities) + ")",
         &result.notes);
  }
  const int turned = orient_outwards(file, options, &result.mesh);
  if (!was_consistent || turned > 0) {
    note("orientation repaired", &result.notes);
  }
  if (!pairs.empty()) {
    note("warning: " + std::to_string(pairs.size()) + " pairs of facets intersect", &result.notes);
  }
  return result;
}

}  // namespace toile::body
