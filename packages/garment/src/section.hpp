#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::garment {

/// Straight axis with a frame; angles count counter-clockwise about `direction` from `zero`.
struct Axis {
  body::Vec3 origin;                      ///< height 0, mm
  body::Vec3 direction;                   ///< unit, upwards
  body::Vec3 zero;                        ///< unit, perpendicular to `direction`
  std::string start = "\"axis bottom\"";  ///< what heights count from, for messages

  body::Vec3 at(double height) const { return origin + height * direction; }
  body::Vec3 ray(double angle) const;
};

/// Closed curve round an axis at one height: radius by angle, with a continuous slope.
class Section {
 public:
  /// Radii (mm) at equally spaced angles from 0.
  explicit Section(std::vector<double> radii);

  double girth() const { return arc_.back(); }  ///< mm
  double radius(double angle) const;
  /// Angle (radians, in 0..2 pi) of the point at the arc length `s` (mm) from angle 0; s is taken modulo the girth.
  double angle_at(double s) const;

  /// Where the radius jumps because the curve is not star-shaped: what lies behind the fold is not seen from the axis.
  struct Fold {
    double angle;          ///< radians
    double before, after;  ///< radii, mm
  };
  /// The first fold between two arc lengths (mm, from < to); none if the curve is smooth there.
  std::optional<Fold> fold_between(double from, double to) const;

 private:
  struct Local {
    double radius, slope;
  };
  Local local(double angle) const;
  double arc(double from, double to) const;

  double step_;
  std::vector<double> radii_;
  std::vector<double> slopes_;
  std::vector<double> arc_;  ///< arc length from angle 0 to each sample, the last one is the girth
};

/// Section of the body at one height, `offset` mm outside of its surface, by sphere tracing from the axis outwards.
/// Throws InputError if the axis is not inside the body at this height, or if a ray finds no surface, or none that
/// it ends on, as in a narrow groove.
Section trace_section(const body::Surface& body, const Axis& axis, double height, double offset);

/// Radius (mm) of that section at one angle, exact between its samples too. Throws the same.
double trace_radius(const body::Surface& body, const Axis& axis, double height, double angle, double offset);

}  // namespace toile::garment
