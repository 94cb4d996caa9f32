#include "toile/body/section.hpp"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/convex_hull_2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <random>

#include "figure/cgal_mesh.hpp"
#include "mesh_geometry.hpp"
#include "nested.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

using EdgeTree = CGAL::AABB_tree<CGAL::AABB_traits<CgalKernel, CGAL::AABB_halfedge_graph_segment_primitive<CgalMesh>>>;
using FaceTree = CGAL::AABB_tree<CGAL::AABB_traits<CgalKernel, CGAL::AABB_face_graph_triangle_primitive<CgalMesh>>>;
using PathTraits = CGAL::Surface_mesh_shortest_path_traits<CgalKernel, CgalMesh>;
using Paths = CGAL::Surface_mesh_shortest_path<PathTraits>;

/// Two unit vectors across `normal` that turn counter-clockwise seen against it.
std::pair<Vec3, Vec3> in_plane(const Vec3& normal) {
  const Vec3 n = normal.normalized();
  const Vec3 other = std::abs(n.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 first = (other - n.dot(other) * n).normalized();
  return {first, n.cross(first)};
}

void measure(const Vec3& normal, SectionPiece* piece) {
  const auto& points = piece->points;
  const std::size_t count = points.size();
  Vec3 area = Vec3::Zero(), weighted = Vec3::Zero(), along = Vec3::Zero();
  piece->lower = piece->upper = points.front();
  const Vec3 n = normal.normalized();
  for (std::size_t i = 0; i < count; ++i) {
    piece->lower = piece->lower.cwiseMin(points[i]);
    piece->upper = piece->upper.cwiseMax(points[i]);
    if (i + 1 == count && !piece->closed) {
      break;
    }
    const Vec3& next = points[(i + 1) % count];
    const double length = (next - points[i]).norm();
    piece->perimeter += length;
    along += 0.5 * length * (points[i] + next);
    const Vec3 part = 0.5 * (points[i] - points.front()).cross(next - points.front());
    area += part;
    weighted += part.dot(n) * (points.front() + points[i] + next) / 3.0;
  }
  piece->centre = piece->perimeter > 0.0 ? Vec3(along / piece->perimeter) : points.front();
  if (piece->closed) {
    piece->area = std::abs(area.dot(n));
    if (piece->area > 1e-9 * piece->perimeter * piece->perimeter) {
      piece->centre = weighted / area.dot(n);
    }
  }
  piece->tape_girth = tape_girth(points, normal);
}

/// The mesh with each vertex moved by less than 1e-4 mm, which no result shows: CGAL 5.5 goes astray, by some percent,
/// where a way runs along edges or through vertices, as it does on regular meshes.
CgalMesh shaken(CgalMesh mesh, unsigned seed) {
  constexpr double amount = 1e-4;  // mm
  std::minstd_rand random(seed);
  const auto shift = [&] { return amount * (static_cast<double>(random()) / std::minstd_rand::max() - 0.5); };
  for (const auto v : mesh.vertices()) {
    const Vec3 place = to_vec(mesh.point(v));
    const double x = place.x() + shift(), y = place.y() + shift(), z = place.z() + shift();
    mesh.point(v) = CgalPoint(x, y, z);
  }
  return mesh;
}

double length_of(const std::vector<Vec3>& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += (way[i] - way[i - 1]).norm();
  }
  return length;
}

/// Empty between pieces that are not connected; none if the way found is not as long as its length is said to be.
std::optional<std::vector<Vec3>> way_on(const CgalMesh& mesh, const Vec3& from, const Vec3& to) {
  constexpr double same = 1e-6;  // mm
  const FaceTree tree(faces(mesh).first, faces(mesh).second, mesh);
  Paths paths(mesh);
  const auto start = paths.locate(cgal_point(from), tree), end = paths.locate(cgal_point(to), tree);
  paths.add_source_point(start.first, start.second);
  std::vector<CgalPoint> corners;
  const double length =
      paths.shortest_path_points_to_source_points(end.first, end.second, std::back_inserter(corners)).first;
  std::vector<Vec3> way;
  if (length < 0.0) {
    return way;
  }
  std::transform(corners.rbegin(), corners.rend(), std::back_inserter(way),
                 [](const CgalPoint& p) { return to_vec(p); });
  return std::abs(length_of(way) - length) < same ? std::optional(way) : std::nullopt;
}

}  // namespace

struct Sections::Data {
  explicit Data(const TriangleMesh& triangles) : mesh(cgal_mesh(triangles)) {
    const auto all = edges(mesh);
    tree.insert(all.first, all.second, mesh);
    tree.build();
  }
  CgalMesh mesh;
  EdgeTree tree;
};

Sections::Sections(const TriangleMesh& mesh) : data_(std::make_unique<Data>(mesh)) {}
Sections::~Sections() = default;
Sections::Sections(Sections&&) noexcept = default;
Sections& Sections::operator=(Sections&&) noexcept = default;

std::vector<SectionPiece> Sections::cut(const Vec3& point, const Vec3& normal) const {
  const CGAL::Polygon_mesh_slicer<CgalMesh, CgalKernel> slicer(data_->mesh, data_->tree);
  std::vector<std::vector<CgalPoint>> curves;
  const Vec3 n = normal.normalized();
  slicer(CgalKernel::Plane_3(n.x(), n.y(), n.z(), -n.dot(point)), std::back_inserter(curves));
  std::vector<SectionPiece> pieces;
  for (const auto& curve : curves) {
    if (curve.size() < 2) {
      continue;
    }
    SectionPiece piece;
    piece.closed = curve.size() > 3 && curve.front() == curve.back();
    for (std::size_t i = 0; i + (piece.closed ? 1 : 0) < curve.size(); ++i) {
      piece.points.push_back(to_vec(curve[i]));
    }
    measure(n, &piece);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<Vec3> Sections::shortest_way(const Vec3& from, const Vec3& to) const {
  constexpr unsigned tries = 5;
  for (unsigned seed = 1; seed <= tries; ++seed) {
    const auto way = way_on(shaken(data_->mesh, seed), from, to);
    if (way) {
      return *way;
    }
  }
  throw base::InputError(
      "no shortest way on the body was found between two points of it; its facets are too irregular");
}

double Sections::length_on_surface(const Vec3& from, const Vec3& to) const {
  const std::vector<Vec3> way = shortest_way(from, to);
  return way.empty() ? std::numeric_limits<double>::infinity() : length_of(way);
}

double tape_girth(const std::vector<Vec3>& points, const Vec3& normal) {
  const auto [first, second] = in_plane(normal);
  std::vector<CgalKernel::Point_2> flat, hull;
  for (const Vec3& p : points) {
    flat.emplace_back(p.dot(first), p.dot(second));
  }
  CGAL::convex_hull_2(flat.begin(), flat.end(), std::back_inserter(hull));
  double girth = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    girth += std::sqrt(CGAL::squared_distance(hull[i], hull[(i + 1) % hull.size()]));
  }
  return girth;
}

Extent extent_of(const TriangleMesh& mesh) {
  Extent extent;
  extent.lower = extent.upper = mesh.vertices.front();
  for (const Vec3& v : mesh.vertices) {
    extent.lower = extent.lower.cwiseMin(v);
    extent.upper = extent.upper.cwiseMax(v);
  }
  const std::vector<Vec3> areas = area_vectors(mesh);
  const Vec3 centre = 0.5 * (extent.lower + extent.upper);
  for (std::size_t t = 0; t < areas.size(); ++t) {
    extent.area += 0.5 * areas[t].norm();
    extent.volume += areas[t].dot(mesh.vertices[mesh.triangles[t][0]] - centre) / 6.0;
  }
  number_pieces(mesh, &extent.pieces);
  return extent;
}

}  // namespace toile::body
