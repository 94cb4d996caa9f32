#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

/// Axis of a bent limb: the moving average of a polyline, c(t) = 1/(2w) of the integral of P over [t - w, t + w], with
/// both ends of the polyline continued straight. Its tangent is the chord of the polyline over the window, so it turns
/// smoothly and spreads each corner over w to either side. Measured by its arc length (mm): 0 at t = 0, the first point
/// if no corner is nearer to it than w; it goes on straight beyond both ends.
class BentAxis {
 public:
  struct Place {
    Vec3 point;            ///< mm
    Vec3 direction;        ///< unit tangent
    Vec3 curvature;        ///< derivative of the tangent by the arc length, 1/mm
    Eigen::Matrix3d turn;  ///< takes directions at arc 0 to those here, without a twist about the axis
  };

  /// At least two points (mm), neighbours distinct; smoothing w > 0 (mm). Throws InputError where the axis turns back
  /// on itself, so that it has no tangent.
  BentAxis(std::vector<Vec3> points, double smoothing);

  double length() const;  ///< mm, from the arc of the first point to that of the last
  Place at(double arc) const;

 private:
  Vec3 polyline(double t) const;        ///< P
  Vec3 primitive(double t) const;       ///< integral of P from 0
  std::size_t segment(double t) const;  ///< that holds t, the first or the last beyond the ends
  Vec3 point(double t) const;           ///< c
  Vec3 derivative(double t) const;      ///< c'
  double arc_between(double from, double to) const;
  double arc_to(double t) const;       ///< from the first sample
  double parameter(double arc) const;  ///< t

  std::vector<Vec3> points_, directions_;  ///< [segment] unit
  std::vector<double> start_;              ///< [point] t
  std::vector<double> kinks_;              ///< increasing t at which the speed has a kink
  std::vector<Vec3> sum_;                  ///< [point] primitive
  double window_;
  double first_ = 0.0, step_ = 0.0;       ///< t of the first sample and between two
  std::vector<double> arc_;               ///< [sample]
  std::vector<Eigen::Quaterniond> turn_;  ///< [sample] from the first sample
  double zero_ = 0.0;                     ///< arc of t = 0 from the first sample
};

}  // namespace toile::mesh
