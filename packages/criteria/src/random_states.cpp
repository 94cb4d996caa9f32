#include "random_states.hpp"

#include <cmath>
#include <random>

namespace toile::criteria {

std::vector<Strain> random_states(const Request& request, int n) {
  std::mt19937 generator(20231);
  const auto within = [&](const std::array<double, 2>& range) {
    return std::uniform_real_distribution<double>(range[0], range[1])(generator);
  };
  std::vector<Strain> states;
  for (int i = 0; i < n; ++i) {
    const double wale = within(request.wale), course = within(request.course), shear = within(request.shear);
    states.push_back(strain_of(wale, course, shear));
  }
  return states;
}

Strain turned(const Strain& C, double angle) {
  const double mean = 0.5 * (C[0] + C[1]), half = 0.5 * (C[0] - C[1]);
  const double c = std::cos(2.0 * angle), s = std::sin(2.0 * angle);
  const double along = half * c + C[2] * s;
  return {mean + along, mean - along, C[2] * c - half * s};
}

}  // namespace toile::criteria
