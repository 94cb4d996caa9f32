#include "toile/scene/fingerprint.hpp"

#include <gmock/gmock.h>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

Fingerprint fingerprint_of(const ParameterList& list) {
  const base::Spec spec = scene_spec();
  return fingerprint(base::validate(list, spec, "scene.xml"), spec, *build(list));
}

// A law that changed under its name, as a plug-in that was built again, is noticed although the scene reads the same.
TEST(Fingerprint, KnowsWhatALawSays) {
  ParameterList softer = flat_scene();
  softer.sublist("Materials").sublist("knit").set("C10", 0.02);
  const Fingerprint before = fingerprint_of(flat_scene());
  Fingerprint now = fingerprint_of(softer);
  now.values = before.values;
  EXPECT_THAT(differences(before, before, 0, false), testing::IsEmpty());
  EXPECT_THAT(differences(before, now, 0, false), testing::ElementsAre(testing::StartsWith("the fabrics: ")));
}

}  // namespace
}  // namespace toile::scene::test
