#include "kinds.hpp"

namespace toile::body {

Kind leg_kind(), cylinder_kind(), elliptic_cylinder_kind(), cone_kind(), ellipsoid_kind(), sphere_kind(), cosine_kind(),
    profile_kind(), file_kind();

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{leg_kind(),    cylinder_kind(),  elliptic_cylinder_kind(),
                                     cone_kind(),   ellipsoid_kind(), sphere_kind(),
                                     cosine_kind(), profile_kind(),   file_kind()};
  return all;
}

base::Spec body_spec() {
  std::vector<base::Spec> specs;
  for (const Kind& kind : kinds()) specs.push_back(kind.spec);
  return base::Spec("Body", "The rigid body that wears the garment.").variant("type", "Kind of body.", specs);
}

}  // namespace toile::body
