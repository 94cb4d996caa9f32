#include "toile/criteria/criterion.hpp"

#include <cmath>
#include <cstdio>

namespace toile::criteria {

std::vector<std::string> Request::all() {
  return {name::finite,           name::natural,        name::derivatives, name::symmetry, name::growth,
          name::elliptic_tension, name::convex_tension, name::elliptic,    name::convex,   name::polyconvex};
}

std::vector<std::string> Request::default_required() {
  return {name::finite, name::natural,          name::derivatives,   name::symmetry,
          name::growth, name::elliptic_tension, name::convex_tension};
}

std::vector<double> positions(const std::array<double, 2>& range, int points) {
  if (range[0] == range[1]) return {range[0]};
  std::vector<double> values(points);
  for (int i = 0; i < points; ++i) values[i] = range[0] + (range[1] - range[0]) * i / (points - 1.0);
  return values;
}

std::string figure(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string place(double wale, double course, double shear) {
  return "wale " + figure(wale) + ", course " + figure(course) + ", shear " + figure(shear);
}

std::string place(const Strain& C) {
  const double wale = std::sqrt(C[0]), shear = C[2] / wale;
  return place(wale, std::sqrt(std::fmax(C[1] - shear * shear, 0.0)), shear);
}

}  // namespace toile::criteria
