#include <Teuchos_Array.hpp>
#include <cmath>

#include "scene.hpp"

namespace toile::base::test {
namespace {

using Teuchos::ParameterList;

const std::string front = "leg.xml: scene > Panels > front: ";
const std::string valid_parameters = "edges, elements, fabric, grain, levels, sewn, shape, share, stiffness, width";

// An unknown parameter is refused with the nearest valid name and the list of all.
TEST(Messages, UnknownParameter) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("shaer", 0.5); }),
            front + "unknown parameter \"shaer\"; did you mean \"share\"? Valid here: " + valid_parameters);
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("temperature", 0.5); }),
            front + "unknown parameter \"temperature\". Valid here: " + valid_parameters);
}

// A parameter of another variant is refused with the selector that it belongs to.
TEST(Messages, ParameterOfAnotherVariant) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("radius", 0.5); }),
            front + "unknown parameter \"radius\" (it belongs to shape \"disk\"). Valid here: " + valid_parameters);
}

// A required parameter that is missing is named with its type, unit and meaning.
TEST(Messages, MissingParameter) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.remove("width"); }),
            front + "missing parameter \"width\", expected double in mm: Width of the box.");
}

// A value of the wrong type is refused with what was found and what is expected.
TEST(Messages, WrongType) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("width", std::string("wide")); }),
            front + "parameter \"width\" is \"wide\" (string), expected double in mm");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("elements", 4.0); }),
            front + "parameter \"elements\" is 4 (double), expected int");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("sewn", 1); }),
            front + "parameter \"sewn\" is 1 (int), expected bool");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("levels", 1.5); }),
            front + "parameter \"levels\" is 1.5 (double), expected Array(double) in mm");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("edges", Teuchos::Array<double>(2, 1.5)); }),
            front + "parameter \"edges\" is {1.5, 1.5} (Array(double)), expected Array(string)");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("stiffness", true); }),
            front +
                "parameter \"stiffness\" is true (bool), expected double in MPa or a list with \"position\" and "
                "\"value\"");
  EXPECT_EQ(error_after([](ParameterList& list) { list.sublist("share"); }),
            front + "parameter \"share\" is a list, expected double");
}

// A number out of range is refused with the number, its unit and what is allowed.
TEST(Messages, OutOfRange) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("width", -3.5); }),
            front + "parameter \"width\" is out of range: -3.5 mm, allowed: > 0 mm");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("elements", 0); }),
            front + "parameter \"elements\" is out of range: 0, allowed: >= 1");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("share", 2); }),
            front + "parameter \"share\" is out of range: 2, allowed: 0 <= value <= 1");
}

// An array entry out of range is refused with its number.
TEST(Messages, EntryOutOfRange) {
  const Teuchos::Array<double> levels(std::vector<double>{1.0, -2.0});
  EXPECT_EQ(error_after([&levels](ParameterList& list) { list.set("levels", levels); }),
            front + "parameter \"levels\", value number 2, is out of range: -2 mm, allowed: >= 0 mm");
}

// Infinity and NaN are refused even where the range is unbounded.
TEST(Messages, NotFinite) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("width", std::numeric_limits<double>::infinity()); }),
            front + "parameter \"width\" is inf, not a finite number");
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("width", std::numeric_limits<double>::quiet_NaN()); }),
            front + "parameter \"width\" is nan, not a finite number");
}

// An unknown choice is refused with the nearest one and all of them.
TEST(Messages, UnknownChoice) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("grain", std::string("coarse")); }),
            front +
                "parameter \"grain\" has the unknown value \"coarse\"; did you mean \"course\"? Valid here: wale, "
                "course");
}

// A selector that names no variant is reported alone: what else is valid depends on it.
TEST(Messages, UnknownVariant) {
  EXPECT_EQ(error_after([](ParameterList& list) { list.set("shape", std::string("bxo")); }),
            front + "parameter \"shape\" has the unknown value \"bxo\"; did you mean \"box\"? Valid here: box, disk");
}

// An unknown list is refused with the nearest valid name and the list of all.
TEST(Messages, UnknownList) {
  ParameterList scene;
  add_front(scene);
  scene.sublist("Ouptut");
  EXPECT_EQ(input_error([&scene] { validate(scene, scene_spec(), "leg.xml"); }),
            "leg.xml: scene: unknown list \"Ouptut\"; did you mean \"Output\"? Valid here: Output, Panels");
}

// A required list that is missing is named with its meaning.
TEST(Messages, MissingList) {
  EXPECT_EQ(input_error([] { validate(ParameterList(), scene_spec(), "leg.xml"); }),
            "leg.xml: scene: missing list \"Panels\": The pieces of fabric.");
}

// A list with too few entries says how many it needs and what an entry is.
TEST(Messages, TooFewEntries) {
  ParameterList scene;
  scene.sublist("Panels");
  EXPECT_EQ(input_error([&scene] { validate(scene, scene_spec(), "leg.xml"); }),
            "leg.xml: scene > Panels: has 0 entries, needs at least 1. An entry is a list with a name of your choice: "
            "One piece of fabric.");
}

// A parameter in the place of a list is refused.
TEST(Messages, ParameterInsteadOfList) {
  ParameterList scene;
  add_front(scene);
  scene.set("Output", std::string("out.e"));
  EXPECT_EQ(input_error([&scene] { validate(scene, scene_spec(), "leg.xml"); }),
            "leg.xml: scene: \"Output\" is a parameter here, expected a list: What is written.");
}

std::string table_error(const std::vector<double>& position, const std::vector<double>& value) {
  return error_after([&](ParameterList& list) {
    list.sublist("stiffness").set("position", Teuchos::Array<double>(position));
    list.sublist("stiffness").set("value", Teuchos::Array<double>(value));
  });
}

// A table is refused if its columns differ in length, its positions do not increase, or a value is out of range.
TEST(Messages, BadTables) {
  EXPECT_EQ(table_error({0.0, 1.0}, {3.0}),
            front +
                "table \"stiffness\": \"position\" has 2 numbers and \"value\" has 1; both need the same number of "
                "them, at least one");
  EXPECT_EQ(table_error({0.0, 0.5, 0.5}, {3.0, 2.0, 1.0}),
            front + "table \"stiffness\": \"position\" is {0, 0.5, 0.5}; it must increase strictly");
  EXPECT_EQ(
      table_error({0.0, 1.5}, {3.0, 1.0}),
      "leg.xml: scene > Panels > front > stiffness: parameter \"position\", value number 2, is out of range: 1.5, "
      "allowed: 0 <= value <= 1");
  EXPECT_EQ(table_error({0.0, 1.0}, {3.0, 0.0}),
            "leg.xml: scene > Panels > front > stiffness: parameter \"value\", value number 2, is out of range: 0 MPa, "
            "allowed: > 0 MPa");
}

// All problems of a scene are reported at once, one line each.
TEST(Messages, AllProblemsAtOnce) {
  EXPECT_EQ(error_after([](ParameterList& list) {
              list.set("share", 2.0);
              list.remove("width");
              list.set("widht", 10.0);
            }),
            front + "parameter \"share\" is out of range: 2, allowed: 0 <= value <= 1\n" + front +
                "missing parameter \"width\", expected double in mm: Width of the box.\n" + front +
                "unknown parameter \"widht\"; did you mean \"width\"? Valid here: " + valid_parameters);
}

// A later check that fails names the file, the list, the parameter, its value and whether that is the default.
TEST(Messages, FailNamesPlaceAndValue) {
  ParameterList scene;
  add_front(scene);
  const List list = validate(scene, scene_spec(), "leg.xml").list("Panels").entries().at(0);
  EXPECT_EQ(input_error([&list] { list.fail("width", "must be less than the girth"); }),
            front + "parameter \"width\" = 10: must be less than the girth");
  EXPECT_EQ(input_error([&list] { list.fail("grain", "must be set"); }),
            front + "parameter \"grain\" = \"wale\" (default): must be set");
}

// A default that is no finite number only means that there is none, so it is not shown as a value.
TEST(Messages, FailShowsNoDefaultThatIsNoNumber) {
  Spec spec("bounds", "Bounds.");
  spec.real("lower", "mm", "Lower bound.", std::nan("")).real("upper", "mm", "Upper bound.", HUGE_VAL);
  const List list = validate(ParameterList(), spec, "leg.xml");
  for (const std::string name : {"lower", "upper"})
    EXPECT_EQ(input_error([&] { list.fail(name, "must be given"); }),
              "leg.xml: bounds: parameter \"" + name + "\" (not given): must be given");
}

}  // namespace
}  // namespace toile::base::test
