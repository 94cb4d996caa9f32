#include "toile/body/import.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <filesystem>

#include "import_checks.hpp"
#include "toile/base/error.hpp"

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

CgalSoup read_soup(const std::string& file) {
  namespace fs = std::filesystem;
  if (!fs::is_regular_file(file)) {
    throw base::InputError(file + ": there is no such body file");
  }
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (extension != ".obj" && extension != ".stl" && extension != ".ply" && extension != ".off") {
    throw base::InputError(file + ": a body file must end in .obj, .stl, .ply or .off, found '" + extension + "'");
  }
  CgalSoup soup;
  const bool read = CGAL::IO::read_polygon_soup(file, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  const auto is_damaged = [&soup](const std::vector<std::size_t>& polygon) {
    return std::any_of(polygon.begin(), polygon.end(), [&](std::size_t i) { return i >= soup.points.size(); });
  };
  if (!read || soup.polygons.empty() || std::any_of(soup.polygons.begin(), soup.polygons.end(), is_damaged)) {
    throw base::InputError(file + ": cannot be read as " + extension.substr(1) +
                           " (no facets, corners that are not there, or damaged text)");
  }
  return soup;
}

PolygonSoup to_plain(const CgalSoup& soup, double scale) {
  PolygonSoup plain;
  plain.polygons = soup.polygons;
  for (const Point& p : soup.points) {
    plain.points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
  }
  return plain;
}

TriangleMesh to_triangles(const Mesh& mesh, double scale) {
  TriangleMesh result;
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    result.vertices.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
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

void note(const std::string& text, std::string* notes) {
  *notes += (notes->empty() ? "" : ", ") + text;
}

/// Facets with fewer than three different corners, and repeated points and facets.
void clean(CgalSoup* soup, std::string* notes) {
  pmp::merge_duplicate_points_in_polygon_soup(soup->points, soup->polygons);
  const std::size_t before = soup->polygons.size();
  pmp::repair_polygon_soup(soup->points, soup->polygons);
  if (soup->polygons.size() < before) {
    note(std::to_string(before - soup->polygons.size()) + " degenerate or repeated facets removed", notes);
  }
}

Mesh build(const std::string& file, CgalSoup* soup, std::string* notes) {
  const std::size_t points = soup->points.size();
  pmp::orient_polygon_soup(soup->points, soup->polygons);
  if (soup->points.size() > points) {
    note(std::to_string(soup->points.size() - points) + " vertices where two parts only touch were doubled", notes);
  }
  if (!pmp::is_polygon_soup_a_polygon_mesh(soup->polygons)) {
    throw base::InputError(file + ": the facets do not form a surface");
  }
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup->points, soup->polygons, mesh);
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
  CgalSoup soup = read_soup(file);
  clean(&soup, &result.notes);
  const PolygonSoup plain = to_plain(soup, options.scale);
  check_height(file, plain, options);
  check_manifold(file, plain);
  if (options.closed) {
    check_closed(file, plain);
  }
  const bool was_consistent = check_consistent(file, plain, options);
  Mesh mesh = build(file, &soup, &result.notes);
  result.mesh = to_triangles(mesh, options.scale);
  const int turned = orient_outwards(file, options, &result.mesh);
  if (!was_consistent || turned > 0) {
    note("orientation repaired", &result.notes);
  }
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  pmp::self_intersections(mesh, std::back_inserter(pairs));
  if (!pairs.empty()) {
    note("warning: " + std::to_string(pairs.size()) + " pairs of facets intersect", &result.notes);
  }
  return result;
}

}  // namespace toile::body
