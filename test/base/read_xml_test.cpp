#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "scene.hpp"

namespace toile::base::test {
namespace {

/// A file that is removed with this object.
class ScopedFile {
 public:
  explicit ScopedFile(const std::string& content) : path_("read_xml_test." + std::to_string(getpid()) + ".xml") {
    std::ofstream(path_) << content;
  }
  ScopedFile(const ScopedFile&) = delete;
  ScopedFile& operator=(const ScopedFile&) = delete;
  ~ScopedFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string scene_with(const std::string& parameters) {
  return "<ParameterList name=\"scene\">\n<!-- a comment -->\n<ParameterList name=\"Panels\">\n"
         "<ParameterList name=\"front\">\n" +
         parameters + "\n</ParameterList>\n</ParameterList>\n</ParameterList>\n";
}

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>\n";
}

const std::string needed = parameter("elements", "int", "4") + parameter("width", "double", "1.25e1");

/// Message for a scene file, without the leading "<file>: ".
std::string error_of(const std::string& content) {
  const ScopedFile file(content);
  const std::string message = input_error([&file] { read_xml(file.path(), scene_spec()); });
  EXPECT_EQ(message.rfind(file.path() + ": ", 0), 0u) << message;
  return message.substr(file.path().size() + 2);
}

std::string parameter_error(const std::string& parameters) {
  return error_of(scene_with(parameters));
}

// A scene file with every type of parameter is read with its values.
TEST(ReadXml, ReadsEveryType) {
  const ScopedFile file(scene_with(needed + parameter("share", "int", "1") + parameter("sewn", "bool", "true") +
                                   parameter("fabric", "string", "fine rib") +
                                   parameter("levels", "Array(double)", "{0, .5, 1e2}") +
                                   parameter("edges", "Array(string)", "{top, left side}")));
  const List front = read_xml(file.path(), scene_spec()).list("Panels").entries().at(0);
  EXPECT_EQ(front.integer("elements"), 4);
  EXPECT_EQ(front.real("width"), 12.5);
  EXPECT_EQ(front.real("share"), 1.0);
  EXPECT_TRUE(front.flag("sewn"));
  EXPECT_EQ(front.word("fabric"), "fine rib");
  EXPECT_EQ(front.reals("levels"), (Reals{0.0, 0.5, 100.0}));
  EXPECT_EQ(front.words("edges"), (Texts{"top", "left side"}));
  EXPECT_EQ(front.file(), file.path());
}

// A file that does not exist is named.
TEST(ReadXml, MissingFile) {
  EXPECT_EQ(input_error([] { read_xml("nowhere.xml", scene_spec()); }), "nowhere.xml: cannot open this file");
}

// A file that is not XML is refused with the line of the fault.
TEST(ReadXml, NotWellFormed) {
  EXPECT_EQ(error_of("<ParameterList name=\"scene\">\n<Parameter name=\"a\"\n</ParameterList>"),
            "not well-formed XML: XML parse error at line 3: start element not well-formed: invalid character");
}

// A file whose outermost element is something else is refused.
TEST(ReadXml, OtherRoot) {
  EXPECT_EQ(error_of("<Scene/>"), "scene: the outermost element is <Scene>, expected <ParameterList>");
}

// Numbers that are none are refused, not read as zero or cut off.
TEST(ReadXml, NotANumber) {
  const std::string front = "scene > Panels > front: ";
  EXPECT_EQ(parameter_error(parameter("width", "double", "abc")),
            front + "parameter \"width\" is \"abc\", expected a number (double)");
  EXPECT_EQ(parameter_error(parameter("elements", "int", "2.5")),
            front + "parameter \"elements\" is \"2.5\", expected a whole number (int)");
  EXPECT_EQ(parameter_error(parameter("elements", "int", "99999999999")),
            front + "parameter \"elements\" is \"99999999999\", expected a whole number (int)");
  EXPECT_EQ(parameter_error(parameter("sewn", "bool", "yes")),
            front + "parameter \"sewn\" is \"yes\", expected true or false (bool)");
  EXPECT_EQ(parameter_error(parameter("levels", "Array(double)", "{1, 2 3}")),
            front +
                "parameter \"levels\" is \"{1, 2 3}\", expected numbers in braces, for instance {1, 2} "
                "(Array(double))");
  EXPECT_EQ(parameter_error(parameter("edges", "Array(string)", "top")),
            front + "parameter \"edges\" is \"top\", expected words in braces, for instance {a, b} (Array(string))");
}

// A type that does not exist is refused with the types that do.
TEST(ReadXml, UnknownType) {
  EXPECT_EQ(parameter_error(parameter("width", "doubel", "1")),
            "scene > Panels > front: parameter \"width\" has the unknown type \"doubel\"; did you mean \"double\"? "
            "Valid here: double, int, bool, string, Array(double), Array(int), Array(string)");
}

// Attributes that are missing are named.
TEST(ReadXml, MissingAttribute) {
  const std::string front = "scene > Panels > front: ";
  EXPECT_EQ(parameter_error("<Parameter name=\"width\" value=\"1\"/>"),
            front + "parameter \"width\" has no attribute \"type\"");
  EXPECT_EQ(parameter_error("<Parameter name=\"width\" type=\"double\"/>"),
            front + "parameter \"width\" has no attribute \"value\"");
  EXPECT_EQ(parameter_error("<Parameter type=\"double\" value=\"1\"/>"),
            front + "a Parameter without the attribute \"name\"");
  EXPECT_EQ(parameter_error("<ParameterList/>"), front + "a ParameterList without the attribute \"name\"");
}

// Another element is refused with the two that are valid.
TEST(ReadXml, UnknownElement) {
  EXPECT_EQ(parameter_error("<Paramter name=\"width\" type=\"double\" value=\"1\"/>"),
            "scene > Panels > front: unknown element <Paramter>. Valid here: Parameter, ParameterList");
}

// A name that is given twice is refused, for parameters and for lists.
TEST(ReadXml, GivenTwice) {
  EXPECT_EQ(parameter_error(needed + parameter("width", "double", "3")),
            "scene > Panels > front: \"width\" is given twice");
  EXPECT_EQ(error_of("<ParameterList name=\"s\"><ParameterList name=\"Panels\"/><ParameterList name=\"Panels\"/>"
                     "</ParameterList>"),
            "scene: \"Panels\" is given twice");
}

// All faults of a file are reported at once.
TEST(ReadXml, AllFaultsAtOnce) {
  const std::string message = parameter_error(parameter("width", "double", "abc") + parameter("sewn", "bool", "1.5"));
  EXPECT_NE(message.find("\"abc\""), std::string::npos);
  EXPECT_NE(message.find("\"1.5\""), std::string::npos);
}

// Files of the validation are checked against the description after they have been read.
TEST(ReadXml, ValidatesWhatItRead) {
  EXPECT_EQ(parameter_error(parameter("elements", "int", "4") + parameter("width", "double", "-1")),
            "scene > Panels > front: parameter \"width\" is out of range: -1 mm, allowed: > 0 mm");
}

}  // namespace
}  // namespace toile::base::test
