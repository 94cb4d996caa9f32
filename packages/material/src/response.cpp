#include "toile/material/response.hpp"

#include <algorithm>
#include <array>

namespace toile::material {

namespace {

/// D (MPa) at C = I.
std::array<double, 6> natural_tangent(const Response& response, const double* params) {
  constexpr std::array<double, 3> natural = {1.0, 1.0, 0.0};
  std::array<double, 3> S = {};
  std::array<double, 6> D = {};
  double W = 0.0, thickness_stretch = 0.0;
  std::uint8_t status = point_ok;
  response.evaluate(1, natural.data(), params, 0, &W, S.data(), D.data(), &thickness_stretch, &status);
  return D;
}

}  // namespace

void Response::wrinkles(int n, const double*, const double*, int, WrinkleState* state, double* direction) const {
  std::fill_n(state, n, WrinkleState::taut);
  std::fill_n(direction, 2 * static_cast<std::ptrdiff_t>(n), 0.0);
}

double Response::natural_stiffness(const double* params) const {
  const std::array<double, 6> D = natural_tangent(*this, params);
  return 0.5 * (D[0] + D[1]);
}

double PlainResponse::natural_shear_modulus(const double* params) const {
  return natural_tangent(*this, params)[2];
}

}  // namespace toile::material
