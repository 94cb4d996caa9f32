#pragma once

#include <memory>
#include <vector>

#include "toile/identify/forward_model.hpp"

namespace toile::identify {

/// A tensile specimen between its clamps, and its mesh.
struct StripSpecimen {
  double length, width;  ///< at rest, mm
  int elements_across;   ///< of the width

  int elements_along() const;
};

class StripEquations;

/// Nominal stress of a tensile test with clamps, by finite elements: a rectangle of fabric, one end held and the other
/// one moved along the axis, both over their whole width; the fabric stays in its plane and carries compression. The
/// stress is force / (width thickness), the stretch 1 + displacement / length.
///
/// Bilinear membranes, graded to the corners, whose singularities would else spoil the order of convergence: with
/// n elements across there are n sqrt(length / width) along, so that elements at the corners are nearly square.
/// The stretches are loaded in their order from rest, by Newton's method with the energy as merit function. With v the
/// derivative of the positions by the displacement u of the clamp, the force is v.R, R the gradient of the energy at
/// fixed parameters, and its derivative by a parameter p at fixed u is v.dR/dp: the equilibrium enters through v alone,
/// which needs one solution with the tangent for all parameters.
///
/// From the first stretch on that cannot be reached, by whatever step, all are NaN. So is a state of which the tangent
/// is not positive definite: no test would show it.
class ClampedStrip final : public ForwardModel {
 public:
  /// `angle` of the strip's axis to the wale, rad; `stretches` > 0, monotone.
  ClampedStrip(const StripSpecimen& specimen, double angle, std::vector<double> stretches);
  ~ClampedStrip() override;

  int size() const override { return static_cast<int>(stretches_.size()); }
  int stress(const material::LawV1& law, const double* params, double* stress) override;
  int stress_and_gradient(const material::LawV1& law, const double* params, double* stress, double* gradient) override;

  /// Tangents factorised since the object was made.
  long factorisations() const;

 private:
  int follow(const material::LawV1& law, const double* params, double* stress, double* gradient);

  std::vector<double> stretches_;
  std::unique_ptr<StripEquations> equations_;
};

}  // namespace toile::identify
