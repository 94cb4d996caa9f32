#include "skin_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toile::scene {

namespace {

using body::Vec3;
using Points = std::vector<Vec3>;

/// The place of a polyline that is closest to a point.
struct Foot {
  size_t segment = 0;  ///< from its point of this number to the next
  Vec3 place;
  double distance = std::numeric_limits<double>::infinity();
};

Foot foot_on(const Points& curve, const Vec3& point) {
  Foot best;
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    const Vec3 side = curve[i + 1] - curve[i];
    const double squared = side.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(side.dot(point - curve[i]) / squared, 0.0, 1.0) : 0.0;
    const Vec3 place = curve[i] + share * side;
    if (const double distance = (place - point).norm(); distance < best.distance) best = {i, place, distance};
  }
  return best;
}

/// The curve's points in order, a closed one with its first at the end as well.
Points curve_of(const body::SectionPiece& piece) {
  Points curve = piece.points;
  if (piece.closed) curve.push_back(curve.front());
  return curve;
}

/// Closed curves: counter-clockwise seen against `normal`.
Points turned(Points curve, const Vec3& normal) {
  Vec3 area = Vec3::Zero();
  for (size_t i = 0; i + 1 < curve.size(); ++i) area += (curve[i] - curve.front()).cross(curve[i + 1] - curve.front());
  if (area.dot(normal) < 0.0) std::reverse(curve.begin(), curve.end());
  return curve;
}

/// A closed curve that starts, and ends, at the foot.
Points starting_at(const Points& curve, const Foot& start) {
  const auto middle = curve.begin() + static_cast<std::ptrdiff_t>(start.segment) + 1;
  Points way = {start.place};
  way.insert(way.end(), middle, curve.end());
  way.insert(way.end(), curve.begin() + 1, middle);
  way.push_back(start.place);
  return way;
}

/// From one foot to a later one of the same curve.
Points between(const Points& curve, const Foot& first, const Foot& last) {
  Points way = {first.place};
  for (size_t i = first.segment + 1; i <= last.segment; ++i) way.push_back(curve[i]);
  way.push_back(last.place);
  return way;
}

}  // namespace

body::SectionPiece nearest_piece(std::vector<body::SectionPiece> pieces, const Vec3& point) {
  size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (size_t p = 0; p < pieces.size(); ++p)
    if (const double distance = foot_on(curve_of(pieces[p]), point).distance; distance < least) {
      least = distance;
      best = p;
    }
  return std::move(pieces[best]);
}

Points way_on_section(const body::SectionPiece& piece, const Vec3& normal, const Vec3& from,
                      const std::optional<Vec3>& to) {
  constexpr double same = 1e-6;  // mm
  Points curve = curve_of(piece);
  const Foot start = foot_on(curve, from), end = foot_on(curve, to.value_or(from));
  if (to && (start.place - end.place).norm() < same) return {};
  if (piece.closed) {
    curve = turned(std::move(curve), normal);
    curve = starting_at(curve, foot_on(curve, from));
    return to ? between(curve, {0, curve.front(), 0.0}, foot_on(curve, *to)) : curve;
  }
  if (!to) {
    if ((curve.back() - from).norm() < (curve.front() - from).norm()) std::reverse(curve.begin(), curve.end());
    return curve;
  }
  const auto along = [&](const Foot& foot) {
    return std::make_pair(foot.segment, (foot.place - curve[foot.segment]).norm());
  };
  if (along(start) < along(end)) return between(curve, start, end);
  Points way = between(curve, end, start);
  std::reverse(way.begin(), way.end());
  return way;
}

Points resampled(const Points& way, double step) {
  Points fine = {way.front()};
  for (size_t i = 1; i < way.size(); ++i) {
    const Vec3 side = way[i] - way[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(side.norm() / step)));
    for (int k = 1; k <= parts; ++k) fine.push_back(way[i - 1] + static_cast<double>(k) / parts * side);
  }
  return fine;
}

std::vector<double> lengths_along(const Points& way) {
  std::vector<double> lengths = {0.0};
  for (size_t i = 1; i < way.size(); ++i) lengths.push_back(lengths.back() + (way[i] - way[i - 1]).norm());
  return lengths;
}

Vec3 point_at(const Points& way, const std::vector<double>& lengths, double length) {
  const auto above = std::upper_bound(lengths.begin(), lengths.end(), length);
  if (above == lengths.end()) return way.back();
  const auto k = static_cast<size_t>(above - lengths.begin());
  const double share = (length - lengths[k - 1]) / (lengths[k] - lengths[k - 1]);
  return (1.0 - share) * way[k - 1] + share * way[k];
}

}  // namespace toile::scene
