#pragma once

#include <cstdint>
#include <string>

#include "toile/material/material.hpp"

namespace toile::material {

enum class WrinkleState : std::uint8_t { taut = 0, wrinkled = 1, slack = 2 };

/// What an element asks of a fabric: the energy of its law, or one derived from it (PlainResponse, RelaxedResponse).
///
/// Thread-safe, never throws. All arrays have the layouts of LawV1; params are [n_params][n] with param_stride = 1
/// or [n_params] with param_stride = 0.
class Response {
 public:
  virtual ~Response() = default;

  virtual int n_params() const = 0;
  /// W [n] and S [3][n] in MPa, D [6][n] (or null) in MPa, thickness_stretch [n], status [n] of n points C [3][n].
  /// Returns the number of points that are not admissible; these are NaN.
  virtual int evaluate(int n, const double* C, const double* params, int param_stride, double* W, double* S, double* D,
                       double* thickness_stretch, std::uint8_t* status) const = 0;
  /// Shear modulus D33 (MPa) of the law itself in its natural state C = I, for `params` [n_params].
  virtual double natural_shear_modulus(const double* params) const = 0;
  /// Mean of D11 and D22 (MPa) there.
  double natural_stiffness(const double* params) const;

  /// Whether fabric wrinkles instead of carrying compression. If not, it is taut everywhere.
  virtual bool relaxes() const { return false; }
  /// The word of parameter "compression" that asks for it.
  virtual std::string compression() const { return "full"; }
  /// What keeps fabric in its place that carries nothing, as a part of the stiffness of undeformed fabric. It is no
  /// part of evaluate().
  virtual double residual_stiffness() const { return 0.0; }
  /// state [n] and direction [2][n] of the wrinkles' crests in the material frame: a unit vector of the reference,
  /// zero where the fabric is not wrinkled (slack fabric has no direction) or not admissible.
  virtual void wrinkles(int n, const double* C, const double* params, int param_stride, WrinkleState* state,
                        double* direction) const;
};

/// A law as it is: one call of its function.
class PlainResponse final : public Response {
 public:
  /// Keeps a reference to `law`.
  explicit PlainResponse(const LawV1& law) : law_(&law) {}

  const LawV1& law() const { return *law_; }
  int n_params() const override { return law_->n_params; }
  int evaluate(int n, const double* C, const double* params, int param_stride, double* W, double* S, double* D,
               double* thickness_stretch, std::uint8_t* status) const override {
    return law_->evaluate(law_->context, n, C, params, param_stride, W, S, D, thickness_stretch, nullptr, status);
  }
  double natural_shear_modulus(const double* params) const override;

 private:
  const LawV1* law_;
};

}  // namespace toile::material
