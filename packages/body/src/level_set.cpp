#include "toile/body/level_set.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "mesh_geometry.hpp"
#include "spline_field.hpp"
#include "toile/base/error.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {
namespace {

constexpr double least_range = 25.0;  ///< mm; fabric further away has no business with the smooth surface

/// Fine enough for the shape, coarse enough to average over the noise of the normals: measured on meshes with edges of
/// 5, 10 and 20 mm (README).
double default_cell(double edge) {
  return edge < 5.0 ? std::max(3.0, 1.4 * edge) : std::max(7.0, 0.55 * edge);
}

/// Waves shorter than 2 pi smoothing lengths, (3 lambda)^(1/6) cells, are taken off the surface. Those of facets are
/// about an edge long, so the smoothing length follows the edge; a fine mesh on a cell of its size needs some smoothing
/// all the same, against the modes that no vertex sees.
double default_smoothing(double edge, double cell) {
  constexpr double length_per_edge = 0.40, least = 1e-3;
  return std::max(least, std::pow(length_per_edge * edge / cell, 6) / 3.0);
}

LevelSetOptions completed(const LevelSetOptions& given, double edge) {
  LevelSetOptions options = given;
  if (options.cell <= 0.0) {
    options.cell = default_cell(edge);
  }
  if (options.smoothing <= 0.0) {
    options.smoothing = default_smoothing(edge, options.cell);
  }
  return options;
}

SurfacePoint from_facets(const TriangleTree::Hit& hit, const Vec3& point) {
  SurfacePoint result;
  result.gap = hit.signed_distance;
  result.normal = hit.distance > 0.0 ? Vec3((point - hit.point) / hit.signed_distance) : hit.pseudo_normal;
  result.closest = hit.point;
  return result;
}

/// Smaller eigenvalue of I + g W in the tangent plane (the third one is 1). Beyond a centre of curvature it is
/// negative, and the stationary point no longer the closest one.
double least_tangential_eigenvalue(const Mat3& offset) {
  const double half_sum = 0.5 * (offset.trace() - 1.0);
  return half_sum - std::sqrt(std::max(0.0, half_sum * half_sum - offset.determinant()));
}

class LevelSetSurface final : public Surface {
 public:
  LevelSetSurface(TriangleMesh mesh, const LevelSetOptions& options, std::string name)
      : mesh_(std::move(mesh)),
        tree_(mesh_),
        edge_(mean_edge_length(mesh_)),
        start_(std::chrono::steady_clock::now()),
        options_(completed(options, edge_)),
        field_(fit_level_set(mesh_, options_.cell, options_.smoothing)),
        name_(std::move(name)) {
    report_fit();
  }
  SurfacePoint closest(const Vec3& point) const override;
  double range() const override { return range_; }
  TriangleMesh triangles(double) const override { return mesh_; }
  std::string summary() const override { return name_ + ", " + fit_; }

 private:
  /// Newton for the closest point y on f = 0 and mu: point - y - mu grad f(y) = 0.
  bool solve(const Vec3& point, Vec3* y, double* mu, SplineField::Value* field) const;
  void report_fit();

  TriangleMesh mesh_;
  TriangleTree tree_;
  double edge_;
  std::chrono::steady_clock::time_point start_;
  LevelSetOptions options_;
  SplineField field_;
  std::string name_;
  std::string fit_;
  double range_ = least_range;
};

bool LevelSetSurface::solve(const Vec3& point, Vec3* y, double* mu, SplineField::Value* field) const {
  constexpr int iterations = 20;
  const Vec3 start = *y;
  double previous = HUGE_VAL;
  for (int i = 0; i < iterations; ++i) {
    if (!field_.evaluate(*y, field)) {
      return false;
    }
    Eigen::Matrix4d jacobian;
    jacobian.topLeftCorner<3, 3>() = Mat3::Identity() + *mu * field->hessian;
    jacobian.topRightCorner<3, 1>() = field->gradient;
    jacobian.bottomLeftCorner<1, 3>() = field->gradient.transpose();
    jacobian(3, 3) = 0.0;
    Eigen::Vector4d right;
    right.head<3>() = point - *y - *mu * field->gradient;
    right[3] = -field->value;
    const Eigen::Vector4d step = jacobian.partialPivLu().solve(right);
    *y += step.head<3>();
    *mu += step[3];
    const double size = step.head<3>().norm();
    // Quadratic convergence has reached the round-off level when the step no longer shrinks.
    if (size < 1e-13 * field_.grid().cell() || (size < 1e-9 && size >= 0.5 * previous)) {
      return field_.evaluate(*y, field);
    }
    if (!(size < 100.0 * field_.grid().cell()) || (*y - start).norm() > 2.0 * field_.grid().cell()) {
      return false;
    }
    previous = size;
  }
  return false;
}

SurfacePoint LevelSetSurface::closest(const Vec3& point) const {
  const TriangleTree::Hit hit = tree_.closest(point);
  SurfacePoint result = from_facets(hit, point);
  if (hit.distance > range_) {
    return result;
  }
  Vec3 y = hit.point;
  double mu = hit.signed_distance;
  SplineField::Value field;
  if (!solve(point, &y, &mu, &field)) {
    return result;
  }
  const double slope = field.gradient.norm();
  const Vec3 normal = field.gradient / slope;
  const Mat3 projector = Mat3::Identity() - normal * normal.transpose();
  const Mat3 weingarten = projector * field.hessian * projector / slope;
  const double gap = mu * slope;
  const Mat3 offset = Mat3::Identity() + gap * weingarten;
  if (!(least_tangential_eigenvalue(offset) > 1e-2)) {
    return result;
  }
  result.gap = gap;
  result.normal = normal;
  result.closest = y;
  const Mat3 hessian = weingarten * offset.inverse();
  result.hessian = 0.5 * (hessian + hessian.transpose());
  result.found = true;
  return result;
}

void LevelSetSurface::report_fit() {
  const auto areas = vertex_areas(mesh_);
  double squares = 0.0, most_out = 0.0, most_in = 0.0, mean = 0.0, weight = 0.0;
  int lost = 0;
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
    const SurfacePoint point = closest(mesh_.vertices[i]);
    if (!point.found) {
      ++lost;
      continue;
    }
    squares += areas[i] * point.gap * point.gap;
    mean -= areas[i] * point.gap;
    weight += areas[i];
    most_out = std::max(most_out, -point.gap);
    most_in = std::max(most_in, point.gap);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  std::ostringstream text;
  text.precision(3);
  text << "smooth surface of " << field_.grid().active_cells() << " cells of " << field_.grid().cell()
       << " mm, smoothing " << options_.smoothing << " (mean edge " << edge_ << " mm), fitted in " << seconds.count()
       << " s; distance to the vertices " << std::sqrt(squares / weight) << " mm root mean square, mean "
       << mean / weight << ", from " << -most_in << " to " << most_out << " (positive: outside of the vertex)";
  if (lost > 0) {
    text << "; " << lost << " vertices have no smooth surface near them";
  }
  fit_ = text.str();
}

class FacetSurface final : public Surface {
 public:
  FacetSurface(TriangleMesh mesh, std::string name) : mesh_(std::move(mesh)), tree_(mesh_), name_(std::move(name)) {}
  SurfacePoint closest(const Vec3& point) const override {
    SurfacePoint result = from_facets(tree_.closest(point), point);
    result.found = std::abs(result.gap) <= range();
    return result;
  }
  double range() const override { return least_range; }
  TriangleMesh triangles(double) const override { return mesh_; }
  std::string summary() const override { return name_ + ", bare facets (pressure shows them)"; }

 private:
  TriangleMesh mesh_;
  TriangleTree tree_;
  std::string name_;
};

}  // namespace

SurfacePtr level_set(TriangleMesh mesh, const LevelSetOptions& options, const std::string& name) {
  if (mesh.triangles.empty()) {
    throw base::InputError(name + ": no triangles to fit a smooth surface to");
  }
  return std::make_shared<LevelSetSurface>(std::move(mesh), options, name);
}

SurfacePtr facet_surface(TriangleMesh mesh, const std::string& name) {
  if (mesh.triangles.empty()) {
    throw base::InputError(name + ": no triangles");
  }
  return std::make_shared<FacetSurface>(std::move(mesh), name);
}

}  // namespace toile::body
