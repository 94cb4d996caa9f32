#include "start_text.hpp"

#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::scene {

std::string short_number(double value) {
  constexpr double whole = 1000.0, zero = 1e-9;
  std::ostringstream out;
  out.precision(std::abs(value) < whole ? 3 : 6);
  out << (std::abs(value) < zero ? 0.0 : std::abs(value) < whole ? value : std::round(value));
  return out.str();
}

std::string place_text(const solve::Vec3& place) {
  return "(" + short_number(place[0]) + ", " + short_number(place[1]) + ", " + short_number(place[2]) + ") mm";
}

std::string message_of(const base::List& entry, const std::string& parameter, const std::string& problem) {
  try {
    entry.fail(parameter, problem);
  } catch (const base::InputError& error) {
    return error.what();
  }
}

}  // namespace toile::scene
