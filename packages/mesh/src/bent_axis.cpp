#include "toile/mesh/bent_axis.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::mesh {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 7>;

constexpr double samples_per_window = 32.0;
constexpr double most_samples = 20000.0;
constexpr double least_speed = 0.05;  // |c'|: 0 in a hairpin, 1 where straight

}  // namespace

BentAxis::BentAxis(std::vector<Vec3> points, double smoothing) : points_(std::move(points)), window_(smoothing) {
  start_.push_back(0.0);
  sum_.emplace_back(Vec3::Zero());
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const Vec3 step = points_[k + 1] - points_[k];
    directions_.push_back(step.normalized());
    start_.push_back(start_.back() + step.norm());
    sum_.push_back(sum_.back() + 0.5 * step.norm() * (points_[k] + points_[k + 1]));
  }
  for (const double start : start_) kinks_.insert(kinks_.end(), {start - window_, start + window_});
  std::sort(kinks_.begin(), kinks_.end());
  // Beyond the window outside of both ends the axis is straight.
  first_ = -window_;
  const double range = start_.back() + 2.0 * window_;
  const double count = std::ceil(std::min(range / window_ * samples_per_window, most_samples));
  step_ = range / count;
  arc_.push_back(0.0);
  turn_.push_back(Eigen::Quaterniond::Identity());
  for (double k = 0.0; k < count; k += 1.0) {
    const double from = first_ + k * step_, to = first_ + (k + 1.0) * step_;
    const Vec3 before = derivative(from), after = derivative(to);
    if (after.norm() < least_speed) {
      const Vec3 at = point(to);
      std::ostringstream text;
      text << "the axis turns back on itself near (" << at[0] << ", " << at[1] << ", " << at[2] << ") mm";
      throw base::InputError(text.str());
    }
    arc_.push_back(arc_.back() + arc_between(from, to));
    turn_.push_back(Eigen::Quaterniond::FromTwoVectors(before, after) * turn_.back());
  }
  zero_ = arc_to(0.0);
}

std::size_t BentAxis::segment(double t) const {
  const auto next = std::upper_bound(start_.begin() + 1, start_.end() - 1, t);
  return static_cast<std::size_t>(next - start_.begin()) - 1;
}

Vec3 BentAxis::polyline(double t) const {
  const std::size_t k = segment(t);
  return points_[k] + (t - start_[k]) * directions_[k];
}

Vec3 BentAxis::primitive(double t) const {
  const std::size_t k = segment(t);
  const double u = t - start_[k];
  return sum_[k] + u * (points_[k] + 0.5 * u * directions_[k]);
}

Vec3 BentAxis::point(double t) const {
  return (primitive(t + window_) - primitive(t - window_)) / (2.0 * window_);
}

Vec3 BentAxis::derivative(double t) const {
  return (polyline(t + window_) - polyline(t - window_)) / (2.0 * window_);
}

double BentAxis::arc_between(double from, double to) const {
  const auto speed = [this](double t) { return derivative(t).norm(); };
  double length = 0.0;
  // The speed has a kink wherever an end of the window passes a point of the polyline.
  for (const double kink : kinks_) {
    if (kink <= from || kink >= to) continue;
    length += Gauss::integrate(speed, from, kink);
    from = kink;
  }
  return length + Gauss::integrate(speed, from, to);
}

double BentAxis::parameter(double arc) const {
  if (arc <= 0.0) return first_ + arc;
  const double last = first_ + step_ * static_cast<double>(arc_.size() - 1);
  if (arc >= arc_.back()) return last + arc - arc_.back();
  const auto next = std::upper_bound(arc_.begin(), arc_.end(), arc);
  const std::size_t k = static_cast<std::size_t>(next - arc_.begin()) - 1;
  const double from = first_ + step_ * static_cast<double>(k);
  double t = from + step_ * (arc - arc_[k]) / (arc_[k + 1] - arc_[k]);
  for (int iteration = 0; iteration < 3; ++iteration)
    t -= (arc_[k] + arc_between(from, t) - arc) / derivative(t).norm();
  return t;
}

double BentAxis::arc_to(double t) const {
  const double sample = std::clamp((t - first_) / step_, 0.0, static_cast<double>(arc_.size() - 1));
  const auto k = static_cast<std::size_t>(sample);
  return arc_[k] + arc_between(first_ + step_ * static_cast<double>(k), t);
}

double BentAxis::length() const {
  return arc_to(start_.back()) - zero_;
}

BentAxis::Place BentAxis::at(double arc) const {
  const double t = parameter(arc + zero_);
  const Vec3 first = derivative(t);
  const Vec3 second = (directions_[segment(t + window_)] - directions_[segment(t - window_)]) / (2.0 * window_);
  Place place;
  place.point = point(t);
  place.direction = first.normalized();
  place.curvature = (second - second.dot(place.direction) * place.direction) / first.squaredNorm();
  const auto turn_to = [this](double s) {
    const double sample = std::clamp((s - first_) / step_, 0.0, static_cast<double>(turn_.size() - 1));
    const auto k = static_cast<std::size_t>(sample);
    const Vec3 there = derivative(first_ + step_ * static_cast<double>(k));
    return Eigen::Quaterniond(Eigen::Quaterniond::FromTwoVectors(there, derivative(s)) * turn_[k]);
  };
  place.turn = (turn_to(t) * turn_to(0.0).conjugate()).toRotationMatrix();
  return place;
}

}  // namespace toile::mesh
