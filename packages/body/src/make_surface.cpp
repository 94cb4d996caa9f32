#include <algorithm>

#include "kinds.hpp"

namespace toile::body {

SurfacePtr make_surface(const base::List& list, const Region* region, BodyFindings* findings) {
  const std::string& type = list.word("type");
  const auto kind =
      std::find_if(kinds().begin(), kinds().end(), [&type](const Kind& k) { return k.spec.name() == type; });
  return kind->make(list, region, findings);
}

}  // namespace toile::body
