#include "kinds.hpp"

namespace toile::body {

// Every kind of body: each is a function NAME_kind() in a source of its own.
#define TOILE_BODY_KINDS(KIND) \
  KIND(leg)                    \
  KIND(cylinder)               \
  KIND(elliptic_cylinder)      \
  KIND(cone)                   \
  KIND(ellipsoid)              \
  KIND(sphere)                 \
  KIND(cosine)                 \
  KIND(profile)                \
  KIND(file)                   \
  KIND(mannequin)

#define TOILE_DECLARE(name) Kind name##_kind();
TOILE_BODY_KINDS(TOILE_DECLARE)
#undef TOILE_DECLARE

const std::vector<Kind>& kinds() {
#define TOILE_CALL(name) name##_kind(),
  static const std::vector<Kind> all{TOILE_BODY_KINDS(TOILE_CALL)};
#undef TOILE_CALL
  return all;
}

base::Spec body_spec() {
  std::vector<base::Spec> specs;
  for (const Kind& kind : kinds()) specs.push_back(kind.spec);
  return base::Spec("Body", "The rigid body that wears the garment.").variant("type", "Kind of body.", specs);
}

}  // namespace toile::body
