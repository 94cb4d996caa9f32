#include "toile/criteria/fabric.hpp"

#include <algorithm>
#include <cmath>

namespace toile::criteria {

bool Outputs::finite() const {
  const auto is_finite = [](double value) { return std::isfinite(value); };
  return std::isfinite(W) && std::isfinite(thickness_stretch) && std::all_of(S.begin(), S.end(), is_finite) &&
         std::all_of(D.begin(), D.end(), is_finite);
}

bool Outputs::tensile(double tolerance) const {
  const double half = 0.5 * (S[0] + S[1]);
  return half - std::hypot(0.5 * (S[0] - S[1]), S[2]) > tolerance;
}

double Outputs::tangent(int a, int b) const {
  constexpr int index[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  return D[index[a][b]];
}

std::vector<Outputs> Fabric::evaluate(const std::vector<Strain>& strains, int* counted) const {
  const std::size_t n = strains.size();
  std::vector<double> C(3 * n), W(n), S(3 * n), D(6 * n), h(n);
  std::vector<std::uint8_t> status(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t a = 0; a < 3; ++a) C[a * n + i] = strains[i][a];
  const int bad = law->evaluate(law->context, static_cast<int>(n), C.data(), params.data(), 0, W.data(), S.data(),
                                D.data(), h.data(), nullptr, status.data());
  if (counted != nullptr) *counted = bad;
  std::vector<Outputs> states(n);
  for (std::size_t i = 0; i < n; ++i) {
    states[i] = {strains[i], W[i], {}, {}, h[i], status[i]};
    for (std::size_t a = 0; a < 3; ++a) states[i].S[a] = S[a * n + i];
    for (std::size_t k = 0; k < 6; ++k) states[i].D[k] = D[k * n + i];
  }
  return states;
}

Strain strain_of(double wale, double course, double shear) {
  return {wale * wale, course * course + shear * shear, wale * shear};
}

}  // namespace toile::criteria
