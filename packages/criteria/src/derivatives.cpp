#include <algorithm>
#include <cmath>
#include <limits>

#include "parameter_derivatives.hpp"
#include "random_states.hpp"
#include "toile/criteria/pointwise.hpp"

namespace toile::criteria {
namespace {

constexpr int levels = 4;  // of Richardson extrapolation: steps h, h/2, h/4, h/8
constexpr double tolerance = 1e-6;
/// C = (2 E1, 2 E2, E3).
constexpr std::array<double, 3> by_strain = {2.0, 2.0, 1.0};
constexpr int quantities = 4;  // W, S11, S22, S12

double quantity(const Outputs& s, int k) {
  return k == 0 ? s.W : s.S[static_cast<std::size_t>(k) - 1];
}

double smaller_eigenvalue(const Strain& C) {
  return 0.5 * (C[0] + C[1]) - std::hypot(0.5 * (C[0] - C[1]), C[2]);
}

/// Limit h -> 0 of values whose error is c1 h^power + c2 h^(2 power) + ... at h, h/2, h/4, ...
double extrapolated(std::array<double, levels> values, int power) {
  for (int k = 1; k < levels; ++k) {
    const double factor = std::pow(2.0, power * k);
    for (int i = 0; i < levels - k; ++i) values[i] = (factor * values[i + 1] - values[i]) / (factor - 1.0);
  }
  return values[0];
}

/// Backward, forward and central estimate of the slope of W and S along one strain.
struct Slopes {
  std::array<std::array<double, quantities>, 3> of;
  bool refused = false;  ///< a neighbour is not admissible
  double error(int quantity_index, double value) const {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& estimate : of) best = std::min(best, std::abs(estimate[quantity_index] - value));
    return best;
  }
};

Slopes slopes(const Fabric& fabric, const Outputs& at, int b) {
  const double step = 4e-3 * smaller_eigenvalue(at.C) / by_strain[b];
  std::vector<Strain> strains;
  for (int i = 0; i < levels; ++i)
    for (int sign : {-1, 1}) {
      strains.push_back(at.C);
      strains.back()[b] += sign * by_strain[b] * step / (1 << i);
    }
  const std::vector<Outputs> states = fabric.evaluate(strains);
  Slopes result;
  for (const Outputs& state : states) result.refused = result.refused || !state.admissible();
  for (int k = 0; k < quantities; ++k) {
    std::array<std::array<double, levels>, 3> rows;
    for (int i = 0; i < levels; ++i) {
      const double h = step / (1 << i), here = quantity(at, k);
      const double low = quantity(states[2 * i], k), high = quantity(states[2 * i + 1], k);
      rows[0][i] = (here - low) / h;
      rows[1][i] = (high - here) / h;
      rows[2][i] = (high - low) / (2.0 * h);
    }
    for (int side = 0; side < 3; ++side) result.of[side][k] = extrapolated(rows[side], side == 2 ? 2 : 1);
  }
  return result;
}

struct Errors {
  double stress = 0.0, tangent = 0.0, symmetry = 0.0;
  Strain where = {1.0, 1.0, 0.0};
  bool refused = false;
  double worst() const { return std::max({stress, tangent, symmetry}); }
};

Errors errors_at(const Fabric& fabric, const Outputs& s) {
  const double stretch = smaller_eigenvalue(s.C);
  double S = 0.0, D = 0.0;
  for (double value : s.S) S = std::max(S, std::abs(value));
  for (double value : s.D) D = std::max(D, std::abs(value));
  const double stress_scale = S + D * stretch, tangent_scale = D + S / stretch;
  std::array<Slopes, 3> along;
  for (int b = 0; b < 3; ++b) along[b] = slopes(fabric, s, b);
  Errors errors;
  errors.where = s.C;
  errors.refused = along[0].refused || along[1].refused || along[2].refused;
  for (int b = 0; b < 3; ++b) {
    errors.stress = std::max(errors.stress, along[b].error(0, s.S[b]) / stress_scale);
    for (int a = 0; a < 3; ++a) {
      errors.tangent = std::max(errors.tangent, along[b].error(a + 1, s.tangent(a, b)) / tangent_scale);
      double least = std::numeric_limits<double>::infinity();
      for (const auto& other : along[a].of) least = std::min(least, along[b].error(a + 1, other[b + 1]));
      errors.symmetry = std::max(errors.symmetry, least / tangent_scale);
    }
  }
  return errors;
}

}  // namespace

Finding derivatives(const Fabric& fabric, const Request& request) {
  std::vector<Strain> strains = random_states(request, 300);
  strains.push_back({1.0, 1.0, 0.0});
  Errors largest;
  int tried = 0;
  const std::vector<Outputs> states = fabric.evaluate(strains);
  for (const Outputs& s : states) {
    if (!s.admissible() || smaller_eigenvalue(s.C) < 0.01) continue;
    const Errors errors = errors_at(fabric, s);
    if (errors.refused) continue;
    ++tried;
    if (errors.worst() > largest.worst()) largest.where = errors.where;
    largest.stress = std::max(largest.stress, errors.stress);
    largest.tangent = std::max(largest.tangent, errors.tangent);
    largest.symmetry = std::max(largest.symmetry, errors.symmetry);
  }
  const ParameterError by_parameter = parameter_error(fabric, states);
  std::string text = "largest difference of S " + figure(largest.stress, 2) + ", of D " + figure(largest.tangent, 2) +
                     ", of dS_a/dE_b and dS_b/dE_a " + figure(largest.symmetry, 2) + " (relative, " +
                     std::to_string(tried) + " states), at " + place(largest.where);
  if (by_parameter.largest > 0.0)
    text += "; of dS/dp " + figure(by_parameter.largest, 2) + ", by " + by_parameter.parameter + " at " +
            place(by_parameter.where);
  const bool holds = tried > 0 && largest.worst() < tolerance && by_parameter.largest < tolerance;
  return {name::derivatives, holds ? Verdict::holds : Verdict::fails, text};
}

}  // namespace toile::criteria
