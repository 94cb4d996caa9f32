#include <Teuchos_Array.hpp>

#include "scene.hpp"

namespace toile::base::test {
namespace {

List front_of(const Teuchos::ParameterList& scene) {
  return validate(scene, scene_spec(), "leg.xml").list("Panels").entries().at(0);
}

// Values that are given are read back, and tell that they are given.
TEST(Parameters, ReadsGivenValues) {
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& front = add_front(scene);
  front.set("share", 0.25);
  front.set("sewn", true);
  front.set("fabric", std::string("rib"));
  front.set("levels", Teuchos::Array<double>(std::vector<double>{1.0, 2.5}));
  front.set("edges", Teuchos::Array<std::string>(std::vector<std::string>{"top", "bottom"}));
  const List list = front_of(scene);
  EXPECT_EQ(list.integer("elements"), 4);
  EXPECT_EQ(list.real("share"), 0.25);
  EXPECT_TRUE(list.flag("sewn"));
  EXPECT_EQ(list.word("fabric"), "rib");
  EXPECT_EQ(list.reals("levels"), (Reals{1.0, 2.5}));
  EXPECT_EQ(list.words("edges"), (Texts{"top", "bottom"}));
  EXPECT_TRUE(list.given("share"));
}

// Values that are not given are filled in from the declaration, and tell that they are not given.
TEST(Parameters, FillsInDefaults) {
  Teuchos::ParameterList scene;
  add_front(scene);
  const List list = front_of(scene);
  EXPECT_EQ(list.real("share"), 0.5);
  EXPECT_FALSE(list.flag("sewn"));
  EXPECT_EQ(list.word("grain"), "wale");
  EXPECT_EQ(list.word("shape"), "box");
  EXPECT_TRUE(list.reals("levels").empty());
  EXPECT_FALSE(list.given("share"));
}

// Whole numbers are accepted where reals are declared, alone and in arrays.
TEST(Parameters, AcceptsIntegersAsReals) {
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& front = add_front(scene);
  front.set("width", 12);
  front.set("levels", Teuchos::Array<int>(std::vector<int>{3, 4}));
  EXPECT_EQ(front_of(scene).real("width"), 12.0);
  EXPECT_EQ(front_of(scene).reals("levels"), (Reals{3.0, 4.0}));
}

// A list knows its name, its place in the scene and its file; entries keep the order of the file.
TEST(Parameters, ListsKnowTheirPlace) {
  Teuchos::ParameterList scene;
  add_front(scene);
  Teuchos::ParameterList& back = scene.sublist("Panels").sublist("back");
  back.set("elements", 1);
  back.set("width", 1.0);
  const List root = validate(scene, scene_spec(), "leg.xml");
  const std::vector<List> panels = root.list("Panels").entries();
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_EQ(panels[0].name(), "front");
  EXPECT_EQ(panels[1].path(), "scene > Panels > back");
  EXPECT_EQ(panels[1].file(), "leg.xml");
}

// An optional list that the scene does not name does not exist, and one that it names has its defaults.
TEST(Parameters, OptionalListsAreOnlyThereIfNamed) {
  Teuchos::ParameterList scene;
  add_front(scene);
  EXPECT_FALSE(validate(scene, scene_spec(), "leg.xml").has_list("Output"));
  scene.sublist("Output");
  EXPECT_EQ(validate(scene, scene_spec(), "leg.xml").list("Output").word("file"), "out.e");
}

// The selector of a variant decides which parameters and lists are valid.
TEST(Parameters, SelectorPicksTheVariant) {
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& front = add_front(scene);
  front.remove("width");
  front.set("shape", std::string("disk"));
  front.set("radius", 5.0);
  front.sublist("Rim").set("height", 2.0);
  EXPECT_EQ(front_of(scene).real("radius"), 5.0);
  EXPECT_EQ(front_of(scene).list("Rim").real("height"), 2.0);
}

// A parameter that may vary along the panel is read as the rows of its table.
TEST(Parameters, ReadsTables) {
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& table = add_front(scene).sublist("stiffness");
  table.set("position", Teuchos::Array<double>(std::vector<double>{0.0, 1.0}));
  table.set("value", Teuchos::Array<double>(std::vector<double>{3.0, 1.5}));
  const List list = front_of(scene);
  ASSERT_TRUE(list.has_table("stiffness"));
  const std::vector<std::pair<double, double>> rows = {{0.0, 3.0}, {1.0, 1.5}};
  EXPECT_EQ(list.table("stiffness"), rows);
  EXPECT_TRUE(list.entries().empty());
  EXPECT_THROW(list.real("stiffness"), Error);
}

// Reading what is not declared, or with another type, is reported as a fault of Toile, not of the user.
TEST(Parameters, ReadingUndeclaredNamesIsInternal) {
  Teuchos::ParameterList scene;
  add_front(scene);
  const List list = front_of(scene);
  const auto code = [](const std::function<void()>& action) {
    try {
      action();
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::success;
  };
  EXPECT_EQ(code([&list] { list.real("length"); }), ExitCode::internal_error);
  EXPECT_EQ(code([&list] { list.integer("width"); }), ExitCode::internal_error);
  EXPECT_EQ(code([&list] { list.list("Rim"); }), ExitCode::internal_error);
  EXPECT_EQ(code([&list] { list.table("stiffness"); }), ExitCode::internal_error);
}

// A range includes its closed ends and excludes its open ones.
TEST(Range, ContainsItsClosedEnds) {
  EXPECT_TRUE(Range::between(0.0, 1.0).contains(0.0));
  EXPECT_TRUE(Range::between(0.0, 1.0).contains(1.0));
  EXPECT_FALSE(Range::between(0.0, 1.0).contains(1.0000001));
  EXPECT_FALSE(Range::positive().contains(0.0));
  EXPECT_TRUE(Range::non_negative().contains(0.0));
  EXPECT_FALSE((Range{0.0, 1.0, false, true}).contains(1.0));
  EXPECT_FALSE(Range::any().contains(std::numeric_limits<double>::quiet_NaN()));
}

// A range is written as an inequality.
TEST(Range, IsWrittenAsInequality) {
  EXPECT_EQ(Range::any().text(), "");
  EXPECT_EQ(Range::positive().text(), "> 0");
  EXPECT_EQ(Range::at_least(1.0).text(), ">= 1");
  EXPECT_EQ(Range::between(-0.5, 1.0).text(), "-0.5 <= value <= 1");
  EXPECT_EQ((Range{0.0, 1.0, true, true}).text(), "0 < value < 1");
}

// The nearest name is found through a missing letter, swapped letters and another case, and not at any distance.
TEST(NearestName, FindsMisspellings) {
  const Texts valid = {"width", "height", "wale angle"};
  EXPECT_EQ(nearest_name("widht", valid), "width");
  EXPECT_EQ(nearest_name("heigt", valid), "height");
  EXPECT_EQ(nearest_name("Wale Angle", valid), "wale angle");
  EXPECT_EQ(nearest_name("temperature", valid), "");
}

// Declaring a parameter twice is refused where it is declared.
TEST(Spec, RefusesDoubleDeclaration) {
  Spec spec("scene", "");
  spec.flag("sewn", "");
  EXPECT_THROW(spec.flag("sewn", ""), std::logic_error);
}

}  // namespace
}  // namespace toile::base::test
