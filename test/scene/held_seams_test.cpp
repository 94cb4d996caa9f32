#include <gmock/gmock.h>

#include "lists.hpp"
#include "toile/scene/start_report.hpp"

namespace toile::scene::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The tube with its lower end held in all directions.
ParameterList held_tube() {
  ParameterList list = tube_scene();
  list.sublist("Supports").sublist("bottom").set("hold", std::string("xyz"));
  return list;
}

StartReport look(const ParameterList& list) {
  const base::List valid = base::validate(list, scene_spec(), "scene.xml");
  base::Timer timer;
  const Scene scene(valid, 1, timer);
  return look_at_start(scene, valid, solve::compute_fields(scene.problem(), scene.start()));
}

// A support that holds both ends of a seam apart is refused, with the names of both, the way and the nodes.
TEST(HeldSeams, AreRefused) {
  EXPECT_THAT(look(held_tube()).errors,
              ElementsAre(AllOf(
                  HasSubstr("scene > Supports > bottom: parameter \"hold\" = \"xyz\": contradicts the seam \"side\": "
                            "the support \"bottom\" holds the node at (-57.1, 18.5, 10) mm in y, and the seam moves it "
                            "by 37.1 mm in y, to the one at (-57.1, -18.5, 10) mm"),
                  HasSubstr("do not hold y there"))));
}

// It does not matter whether the seam closes in a stage or is closed from the start.
TEST(HeldSeams, AreRefusedWhereAStageSews) {
  ParameterList list = held_tube();
  add_sewing(list);
  EXPECT_THAT(look(list).errors, ElementsAre(HasSubstr("contradicts the seam \"side\"")));
}

// A support that has ended when the seam closes holds nothing against it.
TEST(HeldSeams, AreFreeOnceTheSupportIsReleased) {
  ParameterList list = held_tube();
  add_sewing(list);
  list.sublist("Stages").sublist("sew").set("release", Teuchos::Array<std::string>(1, "bottom"));
  EXPECT_THAT(look(list).errors, IsEmpty());
}

// A held node that a seam moves by less than half the side of an element is warned of, with the strain beside it.
TEST(HeldSeams, ThatMoveLittleAreWarnedOf) {
  ParameterList list = held_tube();
  list.sublist("Panels").sublist("tube").sublist("Placement").set("coverage", 0.98);
  EXPECT_THAT(look(list).warnings, ElementsAre(AllOf(HasSubstr("support \"bottom\" contradicts the seam \"side\""),
                                                     HasSubstr("the seam moves it by 7.53 mm in y"),
                                                     HasSubstr("Beside it the fabric is strained by about 26 %"))));
}

}  // namespace
}  // namespace toile::scene::test
