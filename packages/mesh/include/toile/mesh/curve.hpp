#pragma once

#include <optional>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

enum class Interpolation { smooth, polyline };

/// Plane curve through given points, parametrised by its relative arc length.
///
/// `smooth` is the natural cubic spline (each coordinate a function of the parameter, zero second derivative at both
/// ends), `polyline` joins the points by straight lines. Two points give a straight line either way.
class Curve {
 public:
  /// At least two points (mm), neighbours distinct. The parameter of the spline is the chord length.
  Curve(const std::vector<Vec2>& points, Interpolation interpolation);
  /// Same with the parameter values of the points, strictly increasing: a coordinate that is linear in them stays so.
  Curve(std::vector<Vec2> points, Interpolation interpolation, std::vector<double> parameters);
  /// Exact arc of a circle between two angles (radians, from the x axis towards y), run in either direction.
  static Curve circular(const Vec2& centre, double radius, double from, double to);

  double length() const { return arc_.back(); }  ///< mm
  /// Point at the relative arc length s in 0..1.
  Vec2 at(double s) const;
  Vec2 front() const { return points_.front(); }
  Vec2 back() const { return points_.back(); }

 private:
  struct Circle {
    Vec2 centre;
    double radius, from, to;

    Vec2 at(double s) const;
  };

  explicit Curve(const Circle& circle);
  Vec2 value(int segment, double t) const;
  Vec2 derivative(int segment, double t) const;
  /// Arc length between two parameters of one segment, mm.
  double arc(int segment, double from, double to) const;
  void tabulate_arc_length();

  std::optional<Circle> circle_;  ///< if it is one, the points are its two ends, without knots
  std::vector<Vec2> points_;
  std::vector<double> knots_;
  std::vector<Vec2> second_;  ///< second derivative at the knots
  std::vector<double> arc_;   ///< arc length at the ends of `pieces` equal parts of each segment, mm
};

}  // namespace toile::mesh
