#pragma once

#include <string>

namespace toile::dress {

/// A number with so many decimals.
std::string decimals(double value, int digits);

}  // namespace toile::dress
