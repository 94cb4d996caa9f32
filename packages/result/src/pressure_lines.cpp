#include "toile/result/pressure_lines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "triangulate.hpp"

namespace toile::result {
namespace {

using mesh::Vec3;

/// Part of a section inside one triangle.
struct Segment {
  std::array<Vec3, 2> point;
  std::array<double, 2> pressure;
  int element;
  double length() const { return (point[1] - point[0]).norm(); }
};

/// Cuts the garment by planes across the axis.
class Cutter {
 public:
  Cutter(const GarmentFields& garment, const Axis& axis)
      : garment_(garment),
        direction_(axis.direction.normalized()),
        surface_(triangulate(*garment.mesh, garment.position)),
        pressure_(at_vertices(*garment.mesh, garment.pressure)) {
    for (const Vec3& vertex : surface_.mesh.vertices) {
      height_.push_back(direction_.dot(vertex - axis.point));
    }
  }

  LevelRow row(const std::string& name, double height) const;
  double lowest() const { return *std::min_element(height_.begin(), height_.end()); }
  double highest() const { return *std::max_element(height_.begin(), height_.end()); }

 private:
  std::vector<Segment> cut(double height) const;
  void add_point(Segment& segment, int k, int from, int to, double height) const;
  /// Part of a full turn that the section covers around the axis, seen from `centre`.
  double turn(const std::vector<Segment>& section, const Vec3& centre) const;

  const GarmentFields& garment_;
  Vec3 direction_;
  GarmentTriangles surface_;
  std::vector<double> pressure_;  ///< [vertex]
  std::vector<double> height_;    ///< [vertex]
};

void Cutter::add_point(Segment& segment, int k, int from, int to, double height) const {
  const auto a = static_cast<std::size_t>(from);
  const auto b = static_cast<std::size_t>(to);
  const double t = (height - height_[a]) / (height_[b] - height_[a]);
  segment.point[static_cast<std::size_t>(k)] = (1.0 - t) * surface_.mesh.vertices[a] + t * surface_.mesh.vertices[b];
  segment.pressure[static_cast<std::size_t>(k)] = (1.0 - t) * pressure_[a] + t * pressure_[b];
}

std::vector<Segment> Cutter::cut(double height) const {
  std::vector<Segment> section;
  // A vertex in the plane counts as above, so that a plane through a row of nodes meets each place once.
  const auto above = [&](int vertex) { return height_[static_cast<std::size_t>(vertex)] >= height; };
  for (std::size_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
    const auto& triangle = surface_.mesh.triangles[t];
    const int count = static_cast<int>(std::count_if(triangle.begin(), triangle.end(), above));
    if (count == 0 || count == 3) {
      continue;
    }
    const auto alone =
        std::find_if(triangle.begin(), triangle.end(), [&](int vertex) { return above(vertex) == (count == 1); });
    const auto k = static_cast<std::size_t>(alone - triangle.begin());
    Segment segment{};
    segment.element = surface_.element[t];
    add_point(segment, 0, triangle[k], triangle[(k + 1) % 3], height);
    add_point(segment, 1, triangle[k], triangle[(k + 2) % 3], height);
    section.push_back(segment);
  }
  return section;
}

double Cutter::turn(const std::vector<Segment>& section, const Vec3& centre) const {
  double angle = 0.0;
  for (const Segment& segment : section) {
    const Vec3 a = segment.point[0] - centre;
    const Vec3 b = segment.point[1] - centre;
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return angle / (2.0 * M_PI);
}

LevelRow Cutter::row(const std::string& name, double height) const {
  LevelRow row;
  row.name = name;
  row.height = height;
  const std::vector<Segment> section = cut(height);
  Vec3 moment = Vec3::Zero();
  double force = 0.0;
  double tension = 0.0;
  row.pressure_min = std::numeric_limits<double>::infinity();
  row.pressure_max = -row.pressure_min;
  row.smallest_stress = row.pressure_min;
  for (const Segment& segment : section) {
    const double length = segment.length();
    const auto element = static_cast<std::size_t>(segment.element);
    const auto [low, high] = std::minmax(segment.pressure[0], segment.pressure[1]);
    row.girth += length;
    moment += 0.5 * length * (segment.point[0] + segment.point[1]);
    force += 0.5 * length * (low + high);
    tension += length * garment_.hoop_tension[element];
    row.pressure_min = std::min(row.pressure_min, low);
    row.pressure_max = std::max(row.pressure_max, high);
    row.at_support = row.at_support || (!garment_.at_support.empty() && garment_.at_support[element]);
    row.smallest_stress = std::min(row.smallest_stress, garment_.smallest_stress[element]);
  }
  if (row.girth <= 0.0) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {name, height, 0.0, 0.0, none, none, none, none, none, none, none};
  }
  row.turn = turn(section, moment / row.girth);
  row.pressure_mean = force / row.girth;
  row.radius = row.girth / (2.0 * M_PI);
  row.hoop_tension = tension / row.girth;
  row.laplace = row.hoop_tension / row.radius;
  return row;
}

}  // namespace

std::vector<LevelRow> levels(const GarmentFields& garment, const Axis& axis, const std::vector<Level>& levels) {
  const Cutter cutter(garment, axis);
  std::vector<LevelRow> rows;
  for (const Level& level : levels) {
    rows.push_back(cutter.row(level.name, level.height));
  }
  return rows;
}

std::vector<LevelRow> pressure_curve(const GarmentFields& garment, const Axis& axis, int stations) {
  assert(stations >= 2);
  constexpr double inset = 1e-6;    // of the length: rounding in the heights of an even end must not open its section
  constexpr double closed = 0.999;  // of a full turn
  const Cutter cutter(garment, axis);
  const double length = cutter.highest() - cutter.lowest();
  std::vector<LevelRow> rows;
  for (int i = 0; i < stations; ++i) {
    const double part = inset + (1.0 - 2.0 * inset) * i / (stations - 1);
    LevelRow row = cutter.row("", cutter.lowest() + part * length);
    if (row.turn > closed) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace toile::result
