#include "toile/material/response.hpp"

#include <algorithm>
#include <array>

namespace toile::material {

void Response::wrinkles(int n, const double*, const double*, int, WrinkleState* state, double* direction) const {
  std::fill_n(state, n, WrinkleState::taut);
  std::fill_n(direction, 2 * static_cast<std::ptrdiff_t>(n), 0.0);
}

double PlainResponse::natural_shear_modulus(const double* params) const {
  constexpr std::array<double, 3> natural = {1.0, 1.0, 0.0};
  std::array<double, 3> S = {};
  std::array<double, 6> D = {};
  double W = 0.0, thickness_stretch = 0.0;
  std::uint8_t status = point_ok;
  evaluate(1, natural.data(), params, 0, &W, S.data(), D.data(), &thickness_stretch, &status);
  return D[2];
}

}  // namespace toile::material
