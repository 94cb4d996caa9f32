#include <cmath>

#include "kinds.hpp"
#include "span.hpp"

namespace toile::body {
namespace {

using base::List;
using base::Range;
using base::Spec;

SurfacePtr make_cosine(const List& list, const Region* /*region*/, BodyFindings* /*findings*/) {
  if (std::abs(list.real("amplitude")) >= list.real("radius")) {
    list.fail("amplitude", "its magnitude must be smaller than the radius");
  }
  return revolution(cosine_profile(list.real("radius"), list.real("amplitude"), list.real("period")), read_span(list),
                    "cosine body of revolution");
}

}  // namespace

Kind cosine_kind() {
  Spec spec("cosine", "Body of revolution about z: its radius is 'radius' + 'amplitude' cos(2 pi z / 'period').");
  spec.real("radius", "mm", "Mean radius.", base::required, Range::positive());
  spec.real("amplitude", "mm", "Half the difference of the largest and the smallest radius.", base::required);
  spec.real("period", "mm", "Distance from one crest to the next.", base::required, Range::positive());
  add_span(spec, 0.0, 200.0);
  return {spec, make_cosine};
}

}  // namespace toile::body
