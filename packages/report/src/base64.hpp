#pragma once

#include <string>
#include <vector>

namespace toile::report {

// Arrays as the page reads them: little-endian, in base64 (RFC 4648).
/// As 32-bit floats.
std::string base64(const std::vector<double>& values);
/// As 32-bit unsigned integers.
std::string base64(const std::vector<int>& values);

}  // namespace toile::report
