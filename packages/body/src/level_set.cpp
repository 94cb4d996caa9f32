#include "toile/body/level_set.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <sstream>
#include <utility>

#include "fitted_field.hpp"
#include "mesh_geometry.hpp"
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

/// Second derivatives of the distance to the zero set, on it: P H P / |grad f|.
Mat3 weingarten(const SplineField::Value& field) {
  const double slope = field.gradient.norm();
  const Vec3 normal = field.gradient / slope;
  const Mat3 projector = Mat3::Identity() - normal * normal.transpose();
  return projector * field.hessian * projector / slope;
}

/// Its derivative, seen in the tangent plane. f bends much across its zero set, where no datum is: terms of second
/// order in the turn of the normal would count that as curvature.
Mat3 change_of_weingarten(const SplineField::Value& field, const SplineField::Value& change) {
  const double slope = field.gradient.norm();
  const Vec3 normal = field.gradient / slope;
  const Mat3 projector = Mat3::Identity() - normal * normal.transpose();
  const Vec3 turn = projector * change.gradient / slope, across = projector * field.hessian * normal;
  const Mat3 stretched = normal.dot(change.gradient) / slope * field.hessian;
  const Mat3 turned = turn * across.transpose() + across * turn.transpose();
  return (projector * (change.hessian - stretched) * projector - turned) / slope;
}

/// Smaller eigenvalue of I + g W in the tangent plane (the third one is 1). Beyond a centre of curvature it is
/// negative, and the stationary point no longer the closest one.
double least_tangential_eigenvalue(const Mat3& offset) {
  const double half_sum = 0.5 * (offset.trace() - 1.0);
  return half_sum - std::sqrt(std::max(0.0, half_sum * half_sum - offset.determinant()));
}

/// Of (value, weight), the least value with so much weight at or below it; 0 if there are none.
double quantile(std::vector<std::array<double, 2>> values, double weight) {
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const auto& [value, part] : values) {
    sum += part;
    if (sum >= weight) return value;
  }
  return values.empty() ? 0.0 : values.back()[0];
}

class LevelSetSurface final : public Surface {
 public:
  LevelSetSurface(TriangleMesh mesh, const LevelSetOptions& options, std::string name)
      : mesh_(std::move(mesh)),
        tree_(mesh_),
        edge_(mean_edge_length(mesh_)),
        start_(std::chrono::steady_clock::now()),
        options_(completed(options, edge_)),
        field_(mesh_, tree_, options_.cell, options_.smoothing),
        name_(std::move(name)) {
    report_fit();
  }
  SurfacePoint closest(const Vec3& point) const override;
  SurfaceDoubt doubt(const Vec3& point) const override;
  double range() const override { return range_; }
  TriangleMesh triangles(double) const override { return mesh_; }
  std::string summary() const override { return name_ + ", " + figures_; }

 private:
  /// A place on the zero set of one sheet, and the multiplier of point - y - mu grad f(y) = 0.
  struct Foot {
    FittedField::Place place;
    Vec3 y;
    double mu = 0.0;
    SplineField::Value field;
  };
  /// Newton for y and mu from those of `foot`.
  bool solve(const Vec3& point, Foot* foot) const;
  /// Takes y's cell and evaluates the field there; false where the sheet has no cell.
  bool evaluate(Foot* foot) const;
  /// From the place and multiplier in `foot`. False if there is none, or if it is not the closest point of that sheet.
  bool find_on_sheet(const Vec3& point, Foot* foot, SurfacePoint* result) const;
  /// In a narrow gap the facets of one sheet may be nearer, and the smooth surface of another. `foot`: that `result` is
  /// at, its place is not found: none.
  void try_other_sheets(const Vec3& point, Foot* foot, SurfacePoint* result) const;
  /// The closest point, and where it is; its place is not found if there is none.
  std::pair<SurfacePoint, Foot> find(const Vec3& point) const;
  void report_fit();
  /// What is left out of the surface, as a text.
  std::string slits() const;

  TriangleMesh mesh_;
  TriangleTree tree_;
  double edge_;
  std::chrono::steady_clock::time_point start_;
  LevelSetOptions options_;
  FittedField field_;
  std::string name_;
  std::string figures_;
  double range_ = least_range;
};

bool LevelSetSurface::evaluate(Foot* foot) const {
  foot->place = field_.continued(foot->place, foot->y);
  if (foot->place.found()) {
    foot->field = field_.value(foot->place, foot->y);
  }
  return foot->place.found();
}

bool LevelSetSurface::solve(const Vec3& point, Foot* foot) const {
  constexpr int iterations = 20;
  const double cell = field_.grid().cell();
  const Vec3 start = foot->y;
  double previous = HUGE_VAL;
  for (int i = 0; i < iterations; ++i) {
    if (!evaluate(foot)) {
      return false;
    }
    Eigen::Matrix4d jacobian;
    jacobian.topLeftCorner<3, 3>() = Mat3::Identity() + foot->mu * foot->field.hessian;
    jacobian.topRightCorner<3, 1>() = foot->field.gradient;
    jacobian.bottomLeftCorner<1, 3>() = foot->field.gradient.transpose();
    jacobian(3, 3) = 0.0;
    Eigen::Vector4d right;
    right.head<3>() = point - foot->y - foot->mu * foot->field.gradient;
    right[3] = -foot->field.value;
    const Eigen::Vector4d step = jacobian.partialPivLu().solve(right);
    foot->y += step.head<3>();
    foot->mu += step[3];
    const double size = step.head<3>().norm();
    // Quadratic convergence has reached the round-off level when the step no longer shrinks.
    if (size < 1e-13 * cell || (size < 1e-9 && size >= 0.5 * previous)) {
      return evaluate(foot);
    }
    if (!(size < 100.0 * cell) || (foot->y - start).norm() > 2.0 * cell) {
      return false;
    }
    previous = size;
  }
  return false;
}

bool LevelSetSurface::find_on_sheet(const Vec3& point, Foot* foot, SurfacePoint* result) const {
  if (!solve(point, foot)) {
    return false;
  }
  const double slope = foot->field.gradient.norm();
  const Vec3 normal = foot->field.gradient / slope;
  const Mat3 curvature = weingarten(foot->field);
  const double gap = foot->mu * slope;
  const Mat3 offset = Mat3::Identity() + gap * curvature;
  if (!(least_tangential_eigenvalue(offset) > 1e-2)) {
    return false;
  }
  const Mat3 hessian = curvature * offset.inverse();
  *result = {gap, normal, 0.5 * (hessian + hessian.transpose()), foot->y, true};
  return true;
}

SurfacePoint LevelSetSurface::closest(const Vec3& point) const {
  return find(point).first;
}

std::pair<SurfacePoint, LevelSetSurface::Foot> LevelSetSurface::find(const Vec3& point) const {
  const TriangleTree::Hit hit = tree_.closest(point);
  SurfacePoint result = from_facets(hit, point);
  Foot foot;
  if (hit.distance > range_) {
    return {result, foot};
  }
  foot.place = field_.place(hit);
  foot.y = hit.point;
  foot.mu = hit.signed_distance;
  if (!foot.place.found() || !find_on_sheet(point, &foot, &result)) {
    foot.place = {};
  }
  try_other_sheets(point, &foot, &result);
  return {result, foot};
}

/// By the change of the level set, which it follows without moving the closest point along the surface.
SurfaceDoubt LevelSetSurface::doubt(const Vec3& point) const {
  const auto [at, foot] = find(point);
  if (!at.found) {
    return {};
  }
  const SplineField::Value change = field_.doubt(foot.place, foot.y);
  return {change.value / foot.field.gradient.norm(), change_of_weingarten(foot.field, change)};
}

void LevelSetSurface::try_other_sheets(const Vec3& point, Foot* foot, SurfacePoint* result) const {
  const auto places = field_.places_at(point);
  if (places.size() < 2) {
    return;
  }
  const auto same = foot->place.found() ? field_.continued(foot->place, point) : FittedField::Place();
  for (const auto& place : places) {
    const SplineField::Value field = field_.value(place, point);
    const double distance = field.value / field.gradient.norm();
    if (place == same || !(std::abs(distance) < std::abs(result->gap))) {
      continue;
    }
    Foot there;
    there.place = place;
    there.y = point - distance * field.gradient.normalized();
    there.mu = field.value / field.gradient.squaredNorm();
    SurfacePoint other;
    if (find_on_sheet(point, &there, &other) && std::abs(other.gap) < std::abs(result->gap)) {
      *result = other;
      *foot = there;
    }
  }
}

void LevelSetSurface::report_fit() {
  const auto areas = vertex_areas(mesh_);
  std::vector<std::array<double, 2>> distances;  // size, area
  double squares = 0.0, most_out = 0.0, most_in = 0.0, mean = 0.0, weight = 0.0;
  int lost = 0;
  Vec3 worst = Vec3::Zero();
  for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
    const SurfacePoint point = closest(mesh_.vertices[i]);
    if (!point.found) {
      ++lost;
      continue;
    }
    if (std::abs(point.gap) > std::max(most_out, most_in)) {
      worst = mesh_.vertices[i];
    }
    squares += areas[i] * point.gap * point.gap;
    mean -= areas[i] * point.gap;
    weight += areas[i];
    most_out = std::max(most_out, -point.gap);
    most_in = std::max(most_in, point.gap);
    distances.push_back({std::abs(point.gap), areas[i]});
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  std::ostringstream text;
  text.precision(3);
  text << "smooth surface of " << field_.grid().cells().size() << " cells of " << field_.grid().cell() << " mm";
  if (const int shared = field_.grid().shared_positions(); shared > 0) {
    text << " (at " << shared << " places one for each sheet)";
  }
  if (field_.folds() != nullptr) {
    text << ", in folds " << field_.folds()->inside() << " of " << field_.folds()->grid().cell() << " mm";
  }
  text << ", smoothing " << options_.smoothing << " (mean edge " << edge_ << " mm), fitted in " << seconds.count()
       << " s; distance to the vertices " << std::sqrt(squares / weight) << " mm root mean square, mean "
       << mean / weight << ", below " << quantile(std::move(distances), 0.95 * weight) << " on 95 % of the area, from "
       << -most_in << " to " << most_out << " (positive: outside of the vertex), the largest at ("
       << std::lround(worst.x()) << ", " << std::lround(worst.y()) << ", " << std::lround(worst.z()) << ")";
  if (lost > 0) {
    text << "; " << lost << " vertices have no smooth surface near them";
  }
  text << slits();
  figures_ = text.str();
}

std::string LevelSetSurface::slits() const {
  const std::vector<char>& in_slits = field_.in_slits();
  const auto first = std::find(in_slits.begin(), in_slits.end(), 1);
  if (first == in_slits.end()) return {};
  const Vec3& there = mesh_.vertices[first - in_slits.begin()];
  std::ostringstream text;
  text.precision(2);
  text << "; closes slits narrower than " << field_.slit_width() << " mm above " << std::count(first, in_slits.end(), 1)
       << " vertices, one at (" << std::lround(there.x()) << ", " << std::lround(there.y()) << ", "
       << std::lround(there.z()) << ")";
  return text.str();
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
