#include "wearer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toile/base/error.hpp"

namespace toile::dress {
namespace {

using body::SectionPiece;

Vec3 turned(const Vec3& at) {
  return {at.x(), at.z(), -at.y()};
}

/// Length of the taut line over points (y, z) from the highest of them down to the lowest, on the side of larger z.
double taut_length(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.y() > b.y(); });
  std::vector<Vec3> line;
  for (const Vec3& point : points) {
    const auto outside = [&](const Vec3& a, const Vec3& b) {
      return (b.y() - a.y()) * (point.z() - a.z()) - (b.z() - a.z()) * (point.y() - a.y()) < 0.0;
    };
    while (line.size() > 1 && outside(line[line.size() - 2], line.back())) line.pop_back();
    line.push_back(point);
  }
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

}  // namespace

Wearer::Wearer(const body::TriangleMesh& mesh) : triangles_(mesh.triangles), sections_(mesh) {
  for (const Vec3& vertex : mesh.vertices) vertices_.push_back(turned(vertex));
  Vec3 lower = vertices_.front(), upper = lower;
  for (const Vec3& vertex : vertices_) {
    lower = lower.cwiseMin(vertex);
    upper = upper.cwiseMax(vertex);
  }
  lower_ = lower.y();
  upper_ = upper.y();
  middle_ = 0.5 * (lower.x() + upper.x());
  try {
    landmarks_ = body::find_landmarks(mesh);
  } catch (const base::InputError& error) {
    no_landmarks_ = error.what();
  }
  const body::Landmark *left = landmarks_.find("left shoulder"), *right = landmarks_.find("right shoulder");
  if (left != nullptr && right != nullptr) middle_ = 0.5 * (left->point.x() + right->point.x());
  for (const char* side : {"left armpit", "right armpit"})
    if (const body::Landmark* armpit = landmarks_.find(side)) armpits_ = std::min(armpits_, armpit->point.z());
}

std::vector<SectionPiece> Wearer::cut(const Vec3& point, const Vec3& normal) const {
  std::vector<SectionPiece> pieces = sections_.cut(in_space(point), in_space(normal));
  for (SectionPiece& piece : pieces) {
    for (Vec3& at : piece.points) at = turned(at);
    piece.centre = turned(piece.centre);
    const Vec3 a = turned(piece.lower), b = turned(piece.upper);
    piece.lower = a.cwiseMin(b);
    piece.upper = a.cwiseMax(b);
  }
  return pieces;
}

double Wearer::girth(double height) const {
  if (height > armpits_) return 0.0;
  constexpr double step = 2.0;  // mm
  const int key = static_cast<int>(std::lround(height / step));
  const auto known = girths_.find(key);
  if (known != girths_.end()) return known->second;
  // The trunk goes across the middle; of legs, the larger piece on either side is one, and the smaller a hand.
  const SectionPiece *trunk = nullptr, *left = nullptr, *right = nullptr;
  const std::vector<SectionPiece> pieces = cut({0.0, key * step, 0.0}, Vec3::UnitY());
  const auto keep_larger = [](const SectionPiece*& kept, const SectionPiece& piece) {
    if (kept == nullptr || piece.area > kept->area) kept = &piece;
  };
  for (const SectionPiece& piece : pieces) {
    const bool across = piece.lower.x() < middle_ && piece.upper.x() > middle_;
    keep_larger(across ? trunk : piece.centre.x() > middle_ ? left : right, piece);
  }
  std::vector<Vec3> points;
  for (const SectionPiece* piece : {trunk, left, right}) {
    if (piece == nullptr || (trunk != nullptr && piece != trunk)) continue;
    points.insert(points.end(), piece->points.begin(), piece->points.end());
  }
  return girths_[key] = points.empty() ? 0.0 : body::tape_girth(points, Vec3::UnitY());
}

double Wearer::girth(const Arm& arm, double along) const {
  const Vec3 at = arm.shoulder + along * arm.direction;
  double girth = 0.0, nearest = 150.0;  // mm
  for (const SectionPiece& piece : cut(at, arm.direction)) {
    const double distance = (piece.centre - at).norm();
    if (distance > nearest) continue;
    nearest = distance;
    girth = piece.tape_girth;
  }
  return girth;
}

std::optional<double> Wearer::top(double x) const {
  std::optional<double> top;
  for (const SectionPiece& piece : cut({x, 0.0, 0.0}, Vec3::UnitX()))
    if (!top || piece.upper.y() > *top) top = piece.upper.y();
  return top;
}

double Wearer::detour(double x, double height, bool front) const {
  std::vector<Vec3> points;
  Vec3 highest(0.0, -std::numeric_limits<double>::max(), 0.0);
  for (const SectionPiece& piece : cut({x, 0.0, 0.0}, Vec3::UnitX()))
    for (const Vec3& at : piece.points) {
      if (at.y() < height) continue;
      points.emplace_back(0.0, at.y(), front ? at.z() : -at.z());
      if (at.y() > highest.y()) highest = points.back();
    }
  if (points.empty()) return 0.0;
  points.erase(std::remove_if(points.begin(), points.end(), [&](const Vec3& at) { return at.z() < highest.z(); }),
               points.end());
  double furthest = highest.z();
  for (const Vec3& at : points) furthest = std::max(furthest, at.z());
  points.emplace_back(0.0, height, furthest);
  return taut_length(points) - (highest.y() - height);
}

std::optional<double> Wearer::depth(const Vec3& lower, const Vec3& upper, bool front) const {
  std::optional<double> depth;
  for (const std::array<int, 3>& triangle : triangles_) {
    Vec3 least = vertices_[triangle[0]], most = least;
    for (const int v : triangle) {
      least = least.cwiseMin(vertices_[v]);
      most = most.cwiseMax(vertices_[v]);
    }
    if ((least.head<2>().array() > upper.head<2>().array()).any()) continue;
    if ((most.head<2>().array() < lower.head<2>().array()).any()) continue;
    const double z = front ? most.z() : least.z();
    if (!depth || (front ? z > *depth : z < *depth)) depth = z;
  }
  return depth;
}

Arm Wearer::arm(int side) const {
  if (!no_landmarks_.empty()) throw base::InputError(no_landmarks_);
  const std::string name = side > 0 ? "left " : "right ";
  const body::Landmark &shoulder = landmarks_.at(name + "shoulder"), &upper_arm = landmarks_.at(name + "upper arm");
  Vec3 direction = turned(upper_arm.normal).normalized();
  if (direction.y() > 0.0) direction = -direction;
  // The axis of the arm, from where it is nearest to the tip of the shoulder.
  const Vec3 centre = turned(upper_arm.point), tip = turned(shoulder.point);
  return {centre + direction.dot(tip - centre) * direction, direction};
}

std::optional<double> Wearer::shoulder() const {
  const body::Landmark* left = landmarks_.find("left shoulder");
  if (left == nullptr) return {};
  return std::abs(left->point.x() - middle_);
}

}  // namespace toile::dress
