#include "parameter_derivatives.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::criteria {
namespace {

using Stresses = std::vector<double>;  // [3][n]

/// S at `C` [3][n], and dSdp [3][n_params][n] if it is not null.
Stresses stresses(const Fabric& fabric, const std::vector<double>& C, double* dSdp) {
  const std::size_t n = C.size() / 3;
  std::vector<double> W(n), S(3 * n), h(n);
  std::vector<std::uint8_t> status(n);
  fabric.law->evaluate(fabric.law->context, static_cast<int>(n), C.data(), fabric.params.data(), 0, W.data(), S.data(),
                       nullptr, h.data(), dSdp, status.data());
  return S;
}

/// Backward, forward and central differences of one stress, each with one step of Richardson's extrapolation: at a kink
/// one of the sides is right. `down` and `up`: by a half and a whole step `h`.
double least_error(double slope, double here, const std::array<double, 2>& down, const std::array<double, 2>& up,
                   double h) {
  const double backward = 2.0 * (here - down[0]) / (0.5 * h) - (here - down[1]) / h;
  const double forward = 2.0 * (up[0] - here) / (0.5 * h) - (up[1] - here) / h;
  const double central = (4.0 * (up[0] - down[0]) / h - (up[1] - down[1]) / (2.0 * h)) / 3.0;
  return std::min({std::abs(slope - backward), std::abs(slope - forward), std::abs(slope - central)});
}

}  // namespace

ParameterError parameter_error(const Fabric& fabric, const std::vector<Outputs>& states) {
  constexpr double relative_step = 1e-6, least_size = 1e-3;
  ParameterError worst;
  if (fabric.params.empty()) return worst;
  // Near the natural state stresses are differences of larger numbers: a part of the modulus counts as stress.
  constexpr double part_of_modulus = 1e-3;
  std::vector<Strain> strains;
  std::vector<double> least_scale;
  for (const Outputs& s : states) {
    if (!s.admissible()) continue;
    strains.push_back(s.C);
    double modulus = 0.0;
    for (const double value : s.D) modulus = std::max(modulus, std::abs(value));
    least_scale.push_back(part_of_modulus * modulus);
  }
  const std::size_t n = strains.size(), n_params = fabric.params.size();
  std::vector<double> C(3 * n), dSdp(3 * n_params * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t a = 0; a < 3; ++a) C[a * n + i] = strains[i][a];
  const Stresses here = stresses(fabric, C, dSdp.data());
  for (std::size_t k = 0; k < n_params; ++k) {
    if (fabric.law->info[k].choices != nullptr) continue;
    const double size = std::max(std::abs(fabric.params[k]), least_size), h = relative_step * size;
    const auto moved = [&](double by) {
      Fabric other = fabric;
      other.params[k] += by;
      return stresses(other, C, nullptr);
    };
    const std::array<Stresses, 2> down = {moved(-0.5 * h), moved(-h)}, up = {moved(0.5 * h), moved(h)};
    for (std::size_t i = 0; i < n; ++i) {
      double scale = least_scale[i];
      for (std::size_t a = 0; a < 3; ++a)
        scale = std::max({scale, std::abs(here[a * n + i]), size * std::abs(up[1][a * n + i] - here[a * n + i]) / h});
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t at = a * n + i;
        const double slope = dSdp[(a * n_params + k) * n + i];
        double error = size * least_error(slope, here[at], {down[0][at], down[1][at]}, {up[0][at], up[1][at]}, h);
        error = std::isfinite(slope) ? error / scale : std::numeric_limits<double>::infinity();
        if (!(error > worst.largest)) continue;
        worst = {error, fabric.law->info[k].name, strains[i]};
      }
    }
  }
  return worst;
}

}  // namespace toile::criteria
