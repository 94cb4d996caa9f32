#include "toile/identify/curve_models.hpp"

#include <algorithm>

#include "toile/identify/clamped_strip.hpp"
#include "toile/identify/homogeneous.hpp"

namespace toile::identify {
namespace {

/// Some of the points, with a model of their own.
struct Part {
  std::unique_ptr<ForwardModel> model;
  std::vector<std::size_t> points;  ///< of the model among all
};

/// Several models side by side.
class Parts final : public ForwardModel {
 public:
  explicit Parts(std::vector<Part> parts) : parts_(std::move(parts)) {
    for (const Part& part : parts_) size_ += static_cast<int>(part.points.size());
  }

  int size() const override { return size_; }
  int stress(const material::LawV1& law, const double* params, double* stress) override {
    int bad = 0;
    for (const Part& part : parts_) {
      stress_.resize(part.points.size());
      bad += part.model->stress(law, params, stress_.data());
      spread(part, stress_, 1, stress);
    }
    return bad;
  }
  int stress_and_gradient(const material::LawV1& law, const double* params, double* stress, double* gradient) override {
    int bad = 0;
    for (const Part& part : parts_) {
      stress_.resize(part.points.size());
      gradient_.resize(part.points.size() * static_cast<std::size_t>(law.n_params));
      bad += part.model->stress_and_gradient(law, params, stress_.data(), gradient_.data());
      spread(part, stress_, 1, stress);
      spread(part, gradient_, law.n_params, gradient);
    }
    return bad;
  }

 private:
  /// Rows [rows][points of the part] to [rows][size].
  void spread(const Part& part, const std::vector<double>& from, int rows, double* to) const {
    const std::size_t n = part.points.size();
    for (std::size_t r = 0; r < static_cast<std::size_t>(rows); ++r)
      for (std::size_t i = 0; i < n; ++i) to[r * static_cast<std::size_t>(size_) + part.points[i]] = from[r * n + i];
  }

  std::vector<Part> parts_;
  int size_ = 0;
  std::vector<double> stress_, gradient_;
};

}  // namespace

std::unique_ptr<ForwardModel> forward_model(const std::vector<Curve>& curves, Fidelity fidelity) {
  std::vector<Part> parts;
  std::vector<TestPoint> states;
  std::vector<std::size_t> of_states;
  std::size_t next = 0;
  for (const Curve& curve : curves) {
    const bool is_strip = curve.strip.has_value() && fidelity == Fidelity::as_asked;
    if (is_strip) parts.push_back({std::make_unique<ClampedStrip>(*curve.strip, curve.angle, curve.stretch), {}});
    std::vector<std::size_t>& points = is_strip ? parts.back().points : of_states;
    for (const TestPoint& point : curve.points()) {
      if (!is_strip) states.push_back(point);
      points.push_back(next++);
    }
  }
  if (parts.empty()) return std::make_unique<Homogeneous>(states);
  if (!states.empty()) parts.insert(parts.begin(), {std::make_unique<Homogeneous>(states), of_states});
  return std::make_unique<Parts>(std::move(parts));
}

}  // namespace toile::identify
