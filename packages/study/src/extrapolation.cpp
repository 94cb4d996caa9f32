#include "toile/study/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "not_a_number.hpp"

namespace toile::study {

namespace {

/// Of the value: meshes that agree so well agree to what equations are solved to.
constexpr double agreement = 1e-8;
/// Linear elements that converge more slowly are not where their order is known yet.
constexpr double least_order = 0.95, most_order = 4.5, most_spread = 0.75;
/// An order above that of linear elements that coarser meshes do not have is one of chance: its limit is too near.
constexpr double sure_order = 2.5, sure_spread = 0.25;
/// Of an order that no other meshes confirm.
constexpr double unknown_spread = 0.5;
/// Of the way from the finest mesh: orders that agree by chance make no limit better known than that.
constexpr double least_share = 0.1;
constexpr double lowest = 1e-3, highest = 20.0;  ///< orders that are looked for

/// Order that three meshes from `first` on have, by bisection: the ratio of their differences grows with it.
double observed_order(const base::Reals& h, const base::Reals& f, std::size_t first) {
  const double ratio = (f[first] - f[first + 1]) / (f[first + 1] - f[first + 2]);
  if (!(ratio > 0.0) || std::isinf(ratio)) return not_a_number;
  const auto excess = [&](double p) {
    const double q = h[first + 1], coarse = std::pow(h[first] / q, p), fine = std::pow(h[first + 2] / q, p);
    return (coarse - 1.0) / (1.0 - fine) - ratio;
  };
  double low = lowest, high = highest;
  if (excess(low) > 0.0 || excess(high) < 0.0) return not_a_number;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// From the two finest meshes.
double limit(const base::Reals& h, const base::Reals& f, double order) {
  const std::size_t n = h.size();
  return f[n - 1] + (f[n - 1] - f[n - 2]) / (std::pow(h[n - 2] / h[n - 1], order) - 1.0);
}

Extrapolation not_trusted(const base::Reals& f, double order, double spread, const std::string& why) {
  const auto first = f.size() > 3 ? f.end() - 3 : f.begin();
  const auto [low, high] = std::minmax_element(first, f.end());
  return {f.back(), 3.0 * (*high - *low), order, spread, false, why};
}

std::string order_text(double order) {
  std::ostringstream out;
  out.precision(2);
  out << std::fixed << order;
  return out.str();
}

}  // namespace

Extrapolation extrapolate(const base::Reals& sizes, const base::Reals& values) {
  const std::size_t n = values.size();
  if (n < 3) {
    Extrapolation none{not_a_number, not_a_number, not_a_number, not_a_number, false, "it needs three meshes"};
    return none;
  }
  const double last = std::abs(values[n - 1] - values[n - 2]), before = std::abs(values[n - 2] - values[n - 3]);
  const double round_off = agreement * std::abs(values.back());
  if (last <= round_off && before <= round_off)
    return {values.back(), std::max(last, before), not_a_number, not_a_number, true, ""};
  const double order = observed_order(sizes, values, n - 3);
  if (std::isnan(order))
    return not_trusted(values, order, not_a_number, "the three finest meshes do not converge from one side");
  double spread = n > 3 ? 0.0 : not_a_number;
  for (std::size_t first = 0; first + 3 < n; ++first) {
    const double other = observed_order(sizes, values, first);
    spread = std::isnan(other) ? highest : std::max(spread, std::abs(other - order));
  }
  if (order < least_order || order > most_order)
    return not_trusted(values, order, spread, "the observed order is " + order_text(order));
  if (spread > sure_spread && order > sure_order)
    return not_trusted(values, order, spread,
                       "the observed order is " + order_text(order) + ", and not the same on coarser meshes");
  if (spread > most_spread)
    return not_trusted(values, order, spread, "the observed order is not the same on coarser meshes");
  const double value = limit(sizes, values, order), change = std::isnan(spread) ? unknown_spread : spread;
  const double low = std::max(order - change, least_order), high = order + change;
  const double uncertainty =
      std::max({std::abs(limit(sizes, values, low) - value), std::abs(limit(sizes, values, high) - value),
                least_share * std::abs(values.back() - value), round_off});
  return {value, uncertainty, order, spread, true, ""};
}

}  // namespace toile::study
