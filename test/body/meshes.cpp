#include "body/meshes.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <random>

namespace toile::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
using body::Vec3;

/// Points (s, z) of the unrolled tube, moved by up to 35 % of the edge; those at the ends move along the end only.
std::vector<Kernel::Point_2> scatter(const TubeShape& shape, double edge, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.35, 0.35);
  const int columns = static_cast<int>(std::lround(shape.perimeter / edge));
  const int rows = static_cast<int>(std::lround(shape.height / (edge * std::sqrt(0.75))));
  std::vector<Kernel::Point_2> points;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double s = (i + 0.5 * (j % 2) + shift(random)) / columns;
      const double dz = j == 0 || j == rows ? 0.0 : shift(random);
      points.emplace_back((s - std::floor(s)) * shape.perimeter, shape.height * (j + dz) / rows);
    }
  }
  return points;
}

}  // namespace

TubeShape elliptic_tube(double a, double b, double height) {
  constexpr int steps = 20000;
  std::vector<double> arc(steps + 1, 0.0);
  for (int i = 0; i < steps; ++i) {
    const double t = 2.0 * M_PI * (i + 0.5) / steps;
    arc[i + 1] = arc[i] + std::hypot(a * std::sin(t), b * std::cos(t)) * 2.0 * M_PI / steps;
  }
  const double perimeter = arc.back();
  const auto chart = [a, b, arc, perimeter](double u, double z) -> Vec3 {
    const double s = (u - std::floor(u)) * perimeter;
    const auto next = std::upper_bound(arc.begin() + 1, arc.end() - 1, s) - arc.begin();
    const double t = 2.0 * M_PI * (next - 1 + (s - arc[next - 1]) / (arc[next] - arc[next - 1])) / steps;
    return {a * std::cos(t), b * std::sin(t), z};
  };
  return {chart, perimeter, height};
}

TubeShape lobed_tube(double height) {
  const auto chart = [](double u, double z) {
    Vec3 point;
    lobed_curvature(2.0 * M_PI * u, z, &point);
    return point;
  };
  return {chart, 2.0 * M_PI * 60.0, height};
}

double lobed_curvature(double theta, double z, Vec3* point) {
  const double p = 2.0 * theta + z / 60.0, q = 5.0 * theta - z / 50.0;
  const double r = 60.0 + 3.0 * std::cos(p) + 1.2 * std::cos(q);
  const double rt = -6.0 * std::sin(p) - 6.0 * std::sin(q);
  const double rz = -3.0 / 60.0 * std::sin(p) + 1.2 / 50.0 * std::sin(q);
  const double rtt = -12.0 * std::cos(p) - 30.0 * std::cos(q);
  const double rtz = -6.0 / 60.0 * std::cos(p) + 6.0 / 50.0 * std::cos(q);
  const double rzz = -3.0 / 3600.0 * std::cos(p) - 1.2 / 2500.0 * std::cos(q);
  const Vec3 e(std::cos(theta), std::sin(theta), 0.0), t(-std::sin(theta), std::cos(theta), 0.0), k = Vec3::UnitZ();
  *point = r * e + z * k;
  const Vec3 xt = rt * e + r * t, xz = rz * e + k;
  const Vec3 n = xt.cross(xz).normalized();
  Eigen::Matrix2d first, second;
  first << xt.dot(xt), xt.dot(xz), xt.dot(xz), xz.dot(xz);
  const double mixed = -n.dot(rtz * e + rz * t);
  second << -n.dot((rtt - r) * e + 2.0 * rt * t), mixed, mixed, -n.dot(rzz * e);
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(second, first).eigenvalues()[1];
}

body::TriangleMesh random_triangulation(const TubeShape& shape, double edge, unsigned seed) {
  const auto points = scatter(shape, edge, seed);
  std::vector<std::pair<Kernel::Point_2, int>> copies;  // one period to either side closes the tube
  body::TriangleMesh mesh;
  for (std::size_t i = 0; i < points.size(); ++i) {
    mesh.vertices.push_back(shape.chart(points[i].x() / shape.perimeter, points[i].y()));
    for (const int period : {-1, 0, 1}) {
      copies.emplace_back(Kernel::Point_2(points[i].x() + period * shape.perimeter, points[i].y()), i);
    }
  }
  const Delaunay delaunay(copies.begin(), copies.end());
  for (const auto& face : delaunay.finite_face_handles()) {
    const double s = CGAL::centroid(delaunay.triangle(face)).x();
    if (s >= 0.0 && s < shape.perimeter) {
      mesh.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
  }
  return mesh;
}

std::string write_obj(const std::string& name, const body::TriangleMesh& mesh, double scale) {
  const std::string path = testing::TempDir() + "toile-body-" + name + ".obj";
  std::ofstream out(path);
  out << std::setprecision(17);
  for (const Vec3& v : mesh.vertices) {
    out << "v " << scale * v.x() << ' ' << scale * v.y() << ' ' << scale * v.z() << '\n';
  }
  for (const auto& t : mesh.triangles) {
    out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return path;
}

}  // namespace toile::test
