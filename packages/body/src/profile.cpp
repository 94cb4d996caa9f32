#include "toile/body/profile.hpp"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace toile::body {
namespace {

class LinearProfile final : public Profile {
 public:
  LinearProfile(double radius, double slope) : radius_(radius), slope_(slope) {}
  Value at(double z) const override { return {radius_ + slope_ * z, slope_, 0.0}; }
  double variation() const override { return std::numeric_limits<double>::infinity(); }

 private:
  double radius_, slope_;
};

class CosineProfile final : public Profile {
 public:
  CosineProfile(double radius, double amplitude, double period)
      : radius_(radius), amplitude_(amplitude), wave_number_(2.0 * M_PI / period), period_(period) {}
  Value at(double z) const override {
    const double c = amplitude_ * std::cos(wave_number_ * z);
    const double s = amplitude_ * std::sin(wave_number_ * z);
    return {radius_ + c, -wave_number_ * s, -wave_number_ * wave_number_ * c};
  }
  double variation() const override { return period_ / 16.0; }

 private:
  double radius_, amplitude_, wave_number_, period_;
};

/// Natural cubic spline: no curvature at its ends, so that the straight continuation is C2. A mirrored lower end is the
/// natural spline through the levels and their mirror images, which has slope zero at the mirror by symmetry.
class SplineProfile final : public Profile {
 public:
  SplineProfile(std::vector<double> levels, std::vector<double> radii) {
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
      variation_ = std::min(variation_, 0.25 * (levels[i + 1] - levels[i]));
    }
    lower_ = levels.front();
    upper_ = levels.back();
    const auto* type = levels.size() > 2 ? gsl_interp_cspline : gsl_interp_linear;
    spline_.reset(gsl_spline_alloc(type, levels.size()), gsl_spline_free);
    gsl_spline_init(spline_.get(), levels.data(), radii.data(), levels.size());
  }
  Value at(double z) const override {
    const double inside = std::clamp(z, lower_, upper_);
    // No accelerator: it would be state shared between threads.
    Value value{gsl_spline_eval(spline_.get(), inside, nullptr), gsl_spline_eval_deriv(spline_.get(), inside, nullptr),
                0.0};
    if (z == inside) {
      value.bend = gsl_spline_eval_deriv2(spline_.get(), inside, nullptr);
    }
    value.radius += value.slope * (z - inside);
    return value;
  }
  double variation() const override { return variation_; }

 private:
  std::shared_ptr<gsl_spline> spline_;
  double lower_ = 0.0, upper_ = 0.0;
  double variation_ = std::numeric_limits<double>::infinity();
};

}  // namespace

ProfilePtr linear_profile(double radius, double slope) {
  return std::make_shared<LinearProfile>(radius, slope);
}

ProfilePtr cosine_profile(double radius, double amplitude, double period) {
  return std::make_shared<CosineProfile>(radius, amplitude, period);
}

ProfilePtr spline_profile(const std::vector<double>& levels, const std::vector<double>& radii, LowerEnd lower_end) {
  assert(levels.size() >= 2 && levels.size() == radii.size());
  if (lower_end == LowerEnd::straight) {
    return std::make_shared<SplineProfile>(levels, radii);
  }
  std::vector<double> z, r;
  for (std::size_t i = levels.size() - 1; i > 0; --i) {
    z.push_back(2.0 * levels.front() - levels[i]);
    r.push_back(radii[i]);
  }
  z.insert(z.end(), levels.begin(), levels.end());
  r.insert(r.end(), radii.begin(), radii.end());
  return std::make_shared<SplineProfile>(z, r);
}

}  // namespace toile::body
