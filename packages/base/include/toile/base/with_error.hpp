#pragma once

#include <string>

namespace toile::base {

/// "13.4 +- 0.2": both with as many decimals as show the first digit of the error, and with `least_decimals` at least.
/// An error below 1e-6 is written with a power of ten: "0.183 +- 2e-09".
std::string with_error(double value, double error, int least_decimals = 0);

}  // namespace toile::base
