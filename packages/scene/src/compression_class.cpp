#include "toile/scene/compression_class.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace toile::scene {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

// RAL-GZ 387/1 (medical compression hosiery) and the European prestandard ENV 12718.
const std::vector<CompressionClass>& all_classes() {
  static const std::vector<CompressionClass> classes = {
      {"RAL-GZ 387", "I", 18.0, 21.0},      {"RAL-GZ 387", "II", 23.0, 32.0}, {"RAL-GZ 387", "III", 34.0, 46.0},
      {"RAL-GZ 387", "IV", 49.0, no_limit}, {"ENV 12718", "A", 10.0, 14.0},   {"ENV 12718", "I", 15.0, 21.0},
      {"ENV 12718", "II", 23.0, 32.0},      {"ENV 12718", "III", 34.0, 46.0}, {"ENV 12718", "IV", 49.0, no_limit}};
  return classes;
}

/// The limit that is nearest to a pressure. The pressure is decided once its error is less than the distance.
double nearest_limit(const CompressionClass& wanted, double pressure) {
  return std::abs(pressure - wanted.lower) <= std::abs(pressure - wanted.upper) ? wanted.lower : wanted.upper;
}

std::string number(double value) {
  std::ostringstream out;
  out.precision(3);
  out << value;
  return out.str();
}

}  // namespace

std::vector<std::string> compression_standards() {
  std::vector<std::string> names;
  for (const CompressionClass& c : all_classes())
    if (names.empty() || names.back() != c.standard) names.push_back(c.standard);
  return names;
}

std::vector<CompressionClass> compression_classes(const std::string& standard) {
  std::vector<CompressionClass> found;
  std::copy_if(all_classes().begin(), all_classes().end(), std::back_inserter(found),
               [&](const CompressionClass& c) { return c.standard == standard; });
  return found;
}

std::string class_text(const std::string& standard, double pressure) {
  if (std::isnan(pressure)) return "none";
  std::string below;
  for (const CompressionClass& c : compression_classes(standard)) {
    if (pressure < c.lower) return below.empty() ? "below " + c.name : "between " + below + " and " + c.name;
    if (pressure <= c.upper) return c.name;
    below = c.name;
  }
  return "above " + below;
}

Verdict verdict(const CompressionClass& wanted, double pressure, double error) {
  if (pressure - error >= wanted.lower && pressure + error <= wanted.upper) return Verdict::pass;
  if (pressure + error < wanted.lower || pressure - error > wanted.upper) return Verdict::fail;
  return Verdict::undecided;
}

std::string what_decides(const CompressionClass& wanted, double pressure, double error) {
  if (std::isnan(pressure) || std::isnan(error)) return "there is no estimate of its error";
  const bool inside = pressure >= wanted.lower && pressure <= wanted.upper;
  const double limit = nearest_limit(wanted, pressure), room = std::abs(pressure - limit);
  std::string text = "the error bar crosses " + number(limit) + " mmHg: ";
  text += room > 0.0 ? "it is decided (" + std::string(inside ? "passes" : "fails") + ") if the error falls by " +
                           number(error - room) + " mmHg to below " + number(room) + " mmHg"
                     : "no error is small enough on the limit itself";
  const double least = wanted.lower + error, most = wanted.upper - error;
  if (least > most) return text + "; with this error no pressure passes";
  return text + "; it passes with this error if the pressure " +
         (pressure < least ? "rises by " + number(least - pressure) : "falls by " + number(pressure - most)) + " mmHg";
}

std::string limits_text(const CompressionClass& wanted) {
  const std::string range = std::isinf(wanted.upper) ? "at least " + number(wanted.lower)
                                                     : number(wanted.lower) + " to " + number(wanted.upper);
  return wanted.standard + " class " + wanted.name + ", " + range + " mmHg";
}

}  // namespace toile::scene
