#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <variant>
#include <vector>

namespace toile::pattern {

using Vec2 = Eigen::Vector2d;

/// Cubic Bezier segment: `control[0]` and `control[3]` are its ends, mm.
struct Bezier {
  std::array<Vec2, 4> control;
};

/// Arc of a circle between two angles (radians, from the x axis towards y), run in either direction.
struct Arc {
  Vec2 centre;  ///< mm
  double radius = 0.0;
  double from = 0.0, to = 0.0;
};

using Segment = std::variant<Bezier, Arc>;

/// Plane curve of any of the kinds that patterns have, parametrised by its relative arc length. Lines, polylines,
/// splines and Bezier curves are kept as exact cubic segments, circular arcs as arcs.
class Curve {
 public:
  /// Segments one after another; each starts where the one before ends.
  explicit Curve(std::vector<Segment> segments);
  static Curve line(const Vec2& from, const Vec2& to);
  /// Straight lines through at least two points, neighbours distinct (else InputError).
  static Curve polyline(const std::vector<Vec2>& points);
  /// Natural cubic spline through at least two points, neighbours distinct: each coordinate a function of the chord
  /// length, zero second derivative at both ends.
  static Curve spline(const std::vector<Vec2>& points);
  /// Same with the parameter values of the points, strictly increasing: a coordinate that is linear in them stays so.
  static Curve spline(const std::vector<Vec2>& points, const std::vector<double>& parameters);
  static Curve quadratic(const Vec2& from, const Vec2& control, const Vec2& to);
  static Curve cubic(const Vec2& from, const Vec2& control1, const Vec2& control2, const Vec2& to);
  /// From angle `from` to angle `to`, radians; the radius is positive and the angles differ.
  static Curve circular(const Vec2& centre, double radius, double from, double to);
  /// Arc from one point to another, counter-clockwise or not, the longer way round or not. Throws InputError if the
  /// points are further apart than the circle is wide.
  static Curve circular(const Vec2& from, const Vec2& to, double radius, bool longer, bool counter_clockwise);
  /// Several curves one after another; each starts where the one before ends.
  static Curve joined(const std::vector<Curve>& curves);

  double length() const { return arc_.back(); }  ///< mm
  /// Point at the relative arc length s; s outside 0..1 counts as the nearer end.
  Vec2 at(double s) const;
  /// Unit tangent there, of the segment that ends at s where two segments meet with a corner.
  Vec2 tangent(double s) const;
  Vec2 front() const;
  Vec2 back() const;

  Curve reversed() const;
  /// Its image in the line through `point` along the unit vector `direction`.
  Curve mirrored(const Vec2& point, const Vec2& direction) const;
  /// Moved by a rotation of `angle` (radians) about the origin, then by `shift`.
  Curve moved(double angle, const Vec2& shift) const;
  /// Between two relative arc lengths, from < to.
  Curve part(double from, double to) const;

  const std::vector<Segment>& segments() const& { return segments_; }
  std::vector<Segment> segments() && { return std::move(segments_); }
  /// Relative arc lengths of inner points where the tangent jumps by more than `angle` (radians).
  std::vector<double> corners(double angle) const;
  /// Points along the curve, its ends included, no further from it than `tolerance` (mm).
  std::vector<Vec2> points(double tolerance) const;

 private:
  struct Place;
  Place place(double s) const;

  std::vector<Segment> segments_;
  std::vector<double> arc_;  ///< [segments * parts + 1] arc length from the start, mm
};

/// Relative arc length of the point of the curve that is nearest to a point.
double nearest(const Curve& curve, const Vec2& point);

}  // namespace toile::pattern
