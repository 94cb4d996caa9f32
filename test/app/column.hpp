// A body for tests: a closed cylinder.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

namespace toile::test {

/// A cylinder about z of a radius in mm as an OBJ file, from z = 0 to 400 mm; `unit`: mm of the file's.
inline std::string column(double radius, double unit = 1.0) {
  constexpr int strips = 72, rings = 41;
  std::ostringstream obj;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < strips; ++s) {
      const double angle = 2.0 * M_PI * s / strips;
      obj << "v " << radius * std::cos(angle) / unit << ' ' << radius * std::sin(angle) / unit << ' ' << 10.0 * r / unit
          << '\n';
    }
  obj << "v 0 0 0\nv 0 0 " << 10.0 * (rings - 1) / unit << '\n';
  const auto at = [](int ring, int s) { return ring * strips + s % strips + 1; };
  for (int s = 0; s < strips; ++s) {
    for (int r = 0; r + 1 < rings; ++r)
      obj << "f " << at(r, s) << ' ' << at(r, s + 1) << ' ' << at(r + 1, s + 1) << ' ' << at(r + 1, s) << '\n';
    obj << "f " << strips * rings + 1 << ' ' << at(0, s + 1) << ' ' << at(0, s) << '\n';
    obj << "f " << strips * rings + 2 << ' ' << at(rings - 1, s) << ' ' << at(rings - 1, s + 1) << '\n';
  }
  return obj.str();
}

}  // namespace toile::test
