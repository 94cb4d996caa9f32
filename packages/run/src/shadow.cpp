#include "toile/run/shadow.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace toile::run {

namespace {

using mesh::Vec2;
using solve::Vec3;

using Triangle = std::array<Vec2, 3>;

std::vector<Triangle> projected(const mesh::Mesh& mesh, const std::vector<Vec3>& position, const Vec3& point,
                                const Vec3& direction) {
  const Vec3 axis = direction.normalized();
  // x, as far as it lies across the axis, else y: light along z leaves x and y.
  const Vec3 across = std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 first = (across - across.dot(axis) * axis).normalized(), second = axis.cross(first);
  const auto place = [&](int node) {
    const Vec3 r = position[static_cast<size_t>(node)] - point;
    return Vec2(r.dot(first), r.dot(second));
  };
  std::vector<Triangle> triangles;
  for (const mesh::Block& block : mesh.blocks) {
    const auto per = static_cast<size_t>(block.nodes_per_element);
    for (size_t e = 0; e < block.connectivity.size(); e += per) {
      const int* node = &block.connectivity[e];
      for (size_t i = 2; i < per; ++i) triangles.push_back({place(node[0]), place(node[i - 1]), place(node[i])});
    }
  }
  return triangles;
}

using Interval = std::pair<double, double>;

/// The part of a ray from the origin along `d` (of unit length) that a triangle covers; empty: second < first.
Interval covered(const Triangle& triangle, const Vec2& d) {
  Interval part{INFINITY, -INFINITY};
  for (size_t i = 0; i < 3; ++i) {
    const Vec2 &a = triangle[i], &b = triangle[(i + 1) % 3];
    const double side_a = d.x() * a.y() - d.y() * a.x(), side_b = d.x() * b.y() - d.y() * b.x();
    if ((side_a > 0.0) == (side_b > 0.0)) continue;
    const double at = d.dot(a + side_a / (side_a - side_b) * (b - a));
    part = {std::min(part.first, at), std::max(part.second, at)};
  }
  return {std::max(part.first, 0.0), part.second};
}

/// Of the sector of one radian about a ray: integral of r over the union of the parts.
double sector(std::vector<Interval>& parts) {
  std::sort(parts.begin(), parts.end());
  double area = 0.0, reached = 0.0;
  for (const auto& [from, to] : parts) {
    const double start = std::max(from, reached);
    if (to <= start) continue;
    area += 0.5 * (to * to - start * start);
    reached = to;
  }
  return area;
}

}  // namespace

Shadow shadow(const mesh::Mesh& mesh, const std::vector<Vec3>& position, const Vec3& point, const Vec3& direction,
              double disc_radius, int directions) {
  const std::vector<Triangle> triangles = projected(mesh, position, point, direction);
  Shadow shadow;
  std::vector<Interval> parts;
  for (int k = 0; k < directions; ++k) {
    const double angle = 2.0 * M_PI * k / directions;
    const Vec2 ray(std::cos(angle), std::sin(angle));
    parts.assign(1, {0.0, disc_radius});
    double furthest = disc_radius;
    for (const Triangle& triangle : triangles) {
      const Interval part = covered(triangle, ray);
      if (part.second <= part.first) continue;
      parts.push_back(part);
      furthest = std::max(furthest, part.second);
    }
    shadow.outline.push_back(furthest);
    shadow.area += 2.0 * M_PI / directions * sector(parts);
  }
  return shadow;
}

int count_folds(const std::vector<double>& outline, double least) {
  const auto start = std::min_element(outline.begin(), outline.end()) - outline.begin();
  int folds = 0;
  bool forward = false;
  double turn = outline[static_cast<size_t>(start)];  // the least since the last fold, or the most of this one
  for (size_t k = 1; k <= outline.size(); ++k) {
    const double here = outline[(static_cast<size_t>(start) + k) % outline.size()];
    turn = forward ? std::max(turn, here) : std::min(turn, here);
    if (forward ? here > turn - least : here < turn + least) continue;
    folds += forward ? 0 : 1;
    forward = !forward;
    turn = here;
  }
  return folds;
}

DrapeReading read_drape(const scene::Scene& scene, const std::vector<Vec3>& position) {
  constexpr double least = 0.02;  // of the overhang: a fold
  const scene::Output& output = scene.output();
  const scene::Drapemeter& drapemeter = *output.drapemeter;
  DrapeReading reading;
  reading.shadow =
      shadow(*scene.problem().mesh, position, output.axis_point, output.axis_direction, drapemeter.disc_radius);
  reading.coefficient = drapemeter.coefficient(reading.shadow.area);
  reading.folds = count_folds(reading.shadow.outline, least * (drapemeter.fabric_radius - drapemeter.disc_radius));
  return reading;
}

}  // namespace toile::run
