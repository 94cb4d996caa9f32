#include "toile/pattern/curve.hpp"

#include <gsl/gsl_spline.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <sstream>

#include "segment.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

/// Parts of a segment between which its arc length is tabulated.
constexpr int parts = 8;

Bezier straight(const Vec2& a, const Vec2& b) {
  return {{a, (2.0 * a + b) / 3.0, (a + 2.0 * b) / 3.0, b}};
}

/// One coordinate of a natural cubic spline.
class Spline {
 public:
  Spline(const std::vector<double>& at, const std::vector<Vec2>& points, int coordinate)
      : spline_(gsl_spline_alloc(at.size() > 2 ? gsl_interp_cspline : gsl_interp_linear, at.size()), gsl_spline_free) {
    std::vector<double> values;
    for (const Vec2& p : points) values.push_back(p[coordinate]);
    gsl_spline_init(spline_.get(), at.data(), values.data(), at.size());
  }
  double slope(double at) const { return gsl_spline_eval_deriv(spline_.get(), at, nullptr); }

 private:
  std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> spline_;
};

Vec2 mirror_image(const Vec2& p, const Vec2& point, const Vec2& direction) {
  const Vec2 d = p - point;
  return point + 2.0 * d.dot(direction) * direction - d;
}

/// Applies a map of points to a segment; `angle` maps the angles of arcs.
template <class Map, class Angle>
Segment mapped(const Segment& segment, const Map& map, const Angle& angle) {
  if (const auto* arc = std::get_if<Arc>(&segment)) {
    return Arc{map(arc->centre), arc->radius, angle(arc->from), angle(arc->to)};
  }
  Bezier bezier = std::get<Bezier>(segment);
  for (Vec2& c : bezier.control) c = map(c);
  return bezier;
}

/// Number of equal parts of a segment whose chords keep within the tolerance: a chord over dt is off by |r''| dt^2 / 8.
int chords(const Segment& segment, double tolerance) {
  const double bend = std::max({second_derivative(segment, 0.0).norm(), second_derivative(segment, 0.5).norm(),
                                second_derivative(segment, 1.0).norm()});
  if (!(bend > 0.0)) return 1;
  return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8.0 * tolerance))), 1.0, 10000.0));
}

void require_distinct(const std::vector<Vec2>& points, const std::vector<double>& parameters) {
  if (points.size() < 2) throw base::InputError("a curve needs at least two points");
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (parameters[i] > parameters[i - 1]) continue;
    std::ostringstream text;
    text << "two points of a curve that follow each other are the same: (" << points[i].x() << ", " << points[i].y()
         << ") mm; neighbours must be distinct";
    throw base::InputError(text.str());
  }
}

/// Length of the polygon up to each point.
std::vector<double> chord_lengths(const std::vector<Vec2>& points) {
  std::vector<double> chord{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) chord.push_back(chord.back() + (points[i] - points[i - 1]).norm());
  return chord;
}

}  // namespace

struct Curve::Place {
  std::size_t segment;
  double t;
};

Curve::Curve(std::vector<Segment> segments) : segments_(std::move(segments)), arc_{0.0} {
  for (const Segment& segment : segments_)
    for (int k = 0; k < parts; ++k)
      arc_.push_back(arc_.back() +
                     arc_length(segment, static_cast<double>(k) / parts, static_cast<double>(k + 1) / parts));
}

Curve Curve::line(const Vec2& from, const Vec2& to) {
  return Curve({straight(from, to)});
}

Curve Curve::polyline(const std::vector<Vec2>& points) {
  require_distinct(points, chord_lengths(points));
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < points.size(); ++i) segments.emplace_back(straight(points[i - 1], points[i]));
  return Curve(std::move(segments));
}

Curve Curve::spline(const std::vector<Vec2>& points) {
  return spline(points, chord_lengths(points));
}

Curve Curve::spline(const std::vector<Vec2>& points, const std::vector<double>& parameters) {
  require_distinct(points, parameters);
  const Spline x(parameters, points, 0), y(parameters, points, 1);
  const auto slope = [&](std::size_t i) { return Vec2(x.slope(parameters[i]), y.slope(parameters[i])); };
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double third = (parameters[i] - parameters[i - 1]) / 3.0;
    segments.emplace_back(
        Bezier{{points[i - 1], points[i - 1] + third * slope(i - 1), points[i] - third * slope(i), points[i]}});
  }
  return Curve(std::move(segments));
}

Curve Curve::quadratic(const Vec2& from, const Vec2& control, const Vec2& to) {
  return Curve({Bezier{{from, (from + 2.0 * control) / 3.0, (to + 2.0 * control) / 3.0, to}}});
}

Curve Curve::cubic(const Vec2& from, const Vec2& control1, const Vec2& control2, const Vec2& to) {
  return Curve({Bezier{{from, control1, control2, to}}});
}

Curve Curve::circular(const Vec2& centre, double radius, double from, double to) {
  return Curve({Arc{centre, radius, from, to}});
}

Curve Curve::circular(const Vec2& from, const Vec2& to, double radius, bool longer, bool counter_clockwise) {
  const Vec2 chord = to - from;
  const double half = 0.5 * chord.norm();
  if (half > radius * (1.0 + 1e-9)) {
    std::ostringstream text;
    text << "a circular arc of radius " << radius << " mm cannot join two points that are " << 2.0 * half
         << " mm apart; allowed is a radius of at least half of that";
    throw base::InputError(text.str());
  }
  const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
  const Vec2 left = Vec2(-chord.y(), chord.x()).normalized();
  // Counter-clockwise along the shorter way, the centre lies to the left of the chord.
  const Vec2 centre = 0.5 * (from + to) + (longer == counter_clockwise ? -height : height) * left;
  const auto angle = [&centre](const Vec2& p) { return std::atan2(p.y() - centre.y(), p.x() - centre.x()); };
  const double start = angle(from);
  double turn = angle(to) - start;
  if (counter_clockwise && turn <= 0.0) turn += 2.0 * M_PI;
  if (!counter_clockwise && turn >= 0.0) turn -= 2.0 * M_PI;
  return circular(centre, radius, start, start + turn);
}

Curve Curve::joined(const std::vector<Curve>& curves) {
  std::vector<Segment> segments;
  for (const Curve& curve : curves) segments.insert(segments.end(), curve.segments_.begin(), curve.segments_.end());
  return Curve(std::move(segments));
}

Curve::Place Curve::place(double s) const {
  if (s <= 0.0) return {0, 0.0};
  if (s >= 1.0) return {segments_.size() - 1, 1.0};
  const double wanted = s * length();
  const auto next = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, wanted);
  const auto k = static_cast<std::size_t>(next - arc_.begin()) - 1;
  const std::size_t segment = k / parts;
  const double from = static_cast<double>(k % parts) / parts, to = from + 1.0 / parts;
  const double guess = from + (wanted - arc_[k]) / (arc_[k + 1] - arc_[k]) / parts;
  const auto miss = [&](double t) {
    return std::make_pair(arc_[k] + arc_length(segments_[segment], from, t) - wanted,
                          derivative(segments_[segment], t).norm());
  };
  std::uintmax_t iterations = 60;
  return {segment, boost::math::tools::newton_raphson_iterate(miss, guess, from, to,
                                                              std::numeric_limits<double>::digits - 4, iterations)};
}

Vec2 Curve::at(double s) const {
  const Place p = place(s);
  return value(segments_[p.segment], p.t);
}

Vec2 Curve::tangent(double s) const {
  const Place p = place(s);
  return direction(segments_[p.segment], p.t);
}

Vec2 Curve::front() const {
  return value(segments_.front(), 0.0);
}

Vec2 Curve::back() const {
  return value(segments_.back(), 1.0);
}

Curve Curve::reversed() const {
  std::vector<Segment> segments;
  for (auto segment = segments_.rbegin(); segment != segments_.rend(); ++segment)
    segments.push_back(pattern::reversed(*segment));
  return Curve(std::move(segments));
}

Curve Curve::mirrored(const Vec2& point, const Vec2& direction) const {
  const double twice = 2.0 * std::atan2(direction.y(), direction.x());
  std::vector<Segment> segments;
  for (const Segment& segment : segments_)
    segments.push_back(mapped(
        segment, [&](const Vec2& p) { return mirror_image(p, point, direction); },
        [&](double a) { return twice - a; }));
  return Curve(std::move(segments));
}

Curve Curve::moved(double angle, const Vec2& shift) const {
  const Eigen::Rotation2Dd turn(angle);
  std::vector<Segment> segments;
  for (const Segment& segment : segments_)
    segments.push_back(mapped(
        segment, [&](const Vec2& p) { return Vec2(turn * p + shift); }, [&](double a) { return a + angle; }));
  return Curve(std::move(segments));
}

Curve Curve::part(double from, double to) const {
  const Place first = place(from), last = place(to);
  std::vector<Segment> segments;
  for (std::size_t p = first.segment; p <= last.segment; ++p) {
    const double start = p == first.segment ? first.t : 0.0, end = p == last.segment ? last.t : 1.0;
    if (end > start) segments.push_back(pattern::part(segments_[p], start, end));
  }
  return Curve(std::move(segments));
}

std::vector<double> Curve::corners(double angle) const {
  std::vector<double> found;
  for (std::size_t p = 1; p < segments_.size(); ++p) {
    const Vec2 in = direction(segments_[p - 1], 1.0), out = direction(segments_[p], 0.0);
    if (std::acos(std::clamp(in.dot(out), -1.0, 1.0)) > angle) found.push_back(arc_[p * parts] / length());
  }
  return found;
}

std::vector<Vec2> Curve::points(double tolerance) const {
  std::vector<Vec2> all{front()};
  for (const Segment& segment : segments_) {
    const int n = chords(segment, tolerance);
    for (int k = 1; k <= n; ++k) all.push_back(value(segment, static_cast<double>(k) / n));
  }
  return all;
}

double nearest(const Curve& curve, const Vec2& point) {
  constexpr int samples = 200;
  const auto distance = [&](double s) { return (curve.at(s) - point).squaredNorm(); };
  int best = 0;
  for (int k = 1; k <= samples; ++k)
    if (distance(static_cast<double>(k) / samples) < distance(static_cast<double>(best) / samples)) best = k;
  const double from = std::max(0, best - 1) / static_cast<double>(samples);
  const double to = std::min(samples, best + 1) / static_cast<double>(samples);
  return boost::math::tools::brent_find_minima(distance, from, to, std::numeric_limits<double>::digits / 2).first;
}

}  // namespace toile::pattern
