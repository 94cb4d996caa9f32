#include "body_end.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

namespace toile::garment {

void refuse_section(const base::List& list, const body::Surface& body, const Axis& axis, double height,
                    const std::string& parameter, const std::string& what) {
  constexpr double size = 20.0;  // mm, of the triangles of bodies given by a formula
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const body::Vec3& vertex : body.triangles(size).vertices) {
    const double at = (vertex - axis.origin).dot(axis.direction);
    lower = std::min(lower, at);
    upper = std::max(upper, at);
  }
  std::ostringstream text;
  const bool has_ends = lower <= upper;
  if (!has_ends || (height >= lower && height <= upper)) {
    const double outside = body.closest(axis.at(height)).gap;
    text << what;
    if (outside >= 0.0) {
      text << "; the nearest surface is " << outside
           << " mm away. Lay the axis through the limb; if the body is a hollow "
           << "shell with an opening, fill it";
    }
    list.fail(parameter, text.str());
  }
  const bool above = height > upper;
  text << "the body ends at " << (above ? upper : lower) << " mm along the axis, but the panel is wrapped from "
       << list.real("from") << " to " << list.real("to")
       << " mm: move or shorten it, or check the body's \"scale\" and \"up\"";
  list.fail(above ? "to" : "from", text.str());
}

}  // namespace toile::garment
