#pragma once

#include <string>

#include "toile/material/response.hpp"

namespace toile::material {

/// Which strains fabric takes up by wrinkling instead of carrying compression.
enum class Relaxation {
  tension_field,  ///< any: A positive semidefinite
  slack_fibres    ///< along its axes: A = diag(A11, A22), entries not negative
};

/// A law whose energy is relaxed over the wrinkle strain A (Pipkin 1986, 1994; doc/theory.md, "Tension field"):
///   W*(C) = min over A >= 0 of  W(C + A).
/// Where the minimum is at A = 0 the fabric is taut and the law is as it was, to the last bit. The law is only
/// evaluated at C + A, so that fabric of any compression is admissible; status, thickness and stress are those of
/// C + A. Slack fabric carries nothing: what keeps it in its place is for the solver (residual_stiffness).
class RelaxedResponse final : public Response {
 public:
  /// Keeps a reference to `law`. residual: what residual_stiffness() tells.
  RelaxedResponse(const LawV1& law, Relaxation relaxation, double residual)
      : law_(law), relaxation_(relaxation), residual_(residual) {}

  int n_params() const override { return law_.n_params(); }
  int evaluate(int n, const double* C, const double* params, int param_stride, double* W, double* S, double* D,
               double* thickness_stretch, std::uint8_t* status) const override;
  double natural_shear_modulus(const double* params) const override { return law_.natural_shear_modulus(params); }
  bool relaxes() const override { return true; }
  std::string compression() const override {
    return relaxation_ == Relaxation::tension_field ? "tension field" : "slack fibres";
  }
  double residual_stiffness() const override { return residual_; }
  void wrinkles(int n, const double* C, const double* params, int param_stride, WrinkleState* state,
                double* direction) const override;

 private:
  PlainResponse law_;
  Relaxation relaxation_;
  double residual_;
};

}  // namespace toile::material
