#include "span.hpp"

#include <algorithm>
#include <sstream>

namespace toile::body {

base::Spec& add_span(base::Spec& spec, double bottom, double top) {
  spec.real("bottom", "mm", "Height z where pictures of the endless body begin; it does not bound the contact.",
            bottom);
  return spec.real("top", "mm", "Height z where pictures of the endless body end; must be above 'bottom'.", top);
}

Span read_span(const base::List& list) {
  const Span span{list.real("bottom"), list.real("top")};
  if (span.top <= span.bottom) {
    list.fail("top", "must be above bottom");
  }
  return span;
}

SurfacePtr positive_revolution(const base::List& list, const std::string& parameter, const ProfilePtr& profile,
                               const Span& levels, const Span& shown, const std::string& name) {
  constexpr int samples = 1000;
  const double lower = std::min(levels.bottom, shown.bottom), upper = std::max(levels.top, shown.top);
  for (int i = 0; i <= samples; ++i) {
    const double z = lower + (upper - lower) * i / samples;
    const double radius = profile->at(z).radius;
    if (radius <= 0.0) {
      std::ostringstream text;
      text << "the smooth curve through these values has the radius " << radius << " mm at the height " << z
           << " mm; give more levels there, or values that change less abruptly";
      list.fail(parameter, text.str());
    }
  }
  return revolution(profile, shown, name);
}

}  // namespace toile::body
