#include "toile/base/with_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace toile::base {

std::string with_error(double value, double error, int least_decimals) {
  constexpr double least_plain = 1e-6;
  char text[96];
  if (error > 0.0 && error < least_plain) {
    std::snprintf(text, sizeof text, "%.7g +- %.1g", value, error);
    return text;
  }
  const bool counts = error > 0.0 && std::isfinite(error);
  const int decimals = std::max(counts ? static_cast<int>(std::ceil(-std::log10(error))) : 0, least_decimals);
  std::snprintf(text, sizeof text, "%.*f +- %.*f", decimals, value, decimals, error);
  return text;
}

}  // namespace toile::base
