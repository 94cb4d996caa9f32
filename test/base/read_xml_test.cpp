#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "scene.hpp"

namespace toile::base::test {
namespace {

using ::testing::HasSubstr;

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

/// Message for a scene file, with "file" in place of its path.
std::string error_of(const std::string& content) {
  const ScopedFile file(content);
  std::string message = input_error([&file] { read_xml(file.path(), scene_spec()); });
  for (std::size_t at = 0; (at = message.find(file.path())) != std::string::npos;)
    message.replace(at, file.path().size(), "file");
  return message;
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
  EXPECT_EQ(input_error([] { read_xml("nowhere.xml", scene_spec()); }),
            "nowhere.xml: cannot open this file: No such file or directory");
}

// A file that is not XML is refused with the line of the fault.
TEST(ReadXml, NotWellFormed) {
  EXPECT_EQ(error_of("<ParameterList name=\"scene\">\n<Parameter name=\"a\"\n</ParameterList>"),
            "file, line 3: not well-formed XML: not well-formed (invalid token); the innermost open element is "
            "<ParameterList> of line 1");
}

// A file whose outermost element is something else is refused.
TEST(ReadXml, OtherRoot) {
  EXPECT_EQ(error_of("<Scene/>"), "file, line 1: scene: the outermost element is <Scene>, expected <ParameterList>");
}

// Numbers that are none are refused, not read as zero or cut off.
TEST(ReadXml, NotANumber) {
  const std::string front = "file, line 5: scene > Panels > front: ";
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
            "file, line 5: scene > Panels > front: parameter \"width\" has the unknown type \"doubel\"; did you mean "
            "\"double\"? "
            "Valid here: double, int, bool, string, Array(double), Array(int), Array(string)");
}

// Attributes that are missing are named.
TEST(ReadXml, MissingAttribute) {
  const std::string front = "file, line 5: scene > Panels > front: ";
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
            "file, line 5: scene > Panels > front: unknown element <Paramter>. Valid here: Parameter, ParameterList");
}

// A name that is given twice is refused, for parameters and for lists.
TEST(ReadXml, GivenTwice) {
  EXPECT_EQ(parameter_error(needed + parameter("width", "double", "3")),
            "file, line 7: scene > Panels > front: \"width\" is given twice, the first time in line 6");
  EXPECT_EQ(error_of("<ParameterList name=\"s\"><ParameterList name=\"Panels\"/><ParameterList name=\"Panels\"/>"
                     "</ParameterList>"),
            "file, line 1: scene: \"Panels\" is given twice, the first time in line 1");
}

// Text between elements is refused with its line: a lost "<" would else drop a parameter, which takes its default.
TEST(ReadXml, TextBetweenElements) {
  EXPECT_EQ(
      parameter_error(needed + "\n  Parameter name=\"share\" type=\"double\" value=\"1\"/>"),
      "file, line 8: scene > Panels > front: the text Parameter name=\"share\" type=\"double\" val... stands between "
      "elements, where it would be lost; is a \"<\" missing?");
  EXPECT_EQ(
      parameter_error("<Parameter name=\"width\" type=\"double\" value=\"1\">12</Parameter>" + needed),
      "file, line 5: scene > Panels > front: the text 12 stands between elements, where it would be lost; write a "
      "value as <Parameter name=... type=... value=.../>\n"
      "file, line 6: scene > Panels > front: \"width\" is given twice, the first time in line 5");
  EXPECT_THAT(parameter_error("<![CDATA[12]]>" + needed),
              HasSubstr("line 5: scene > Panels > front: the text 12 stands"));
}

// What stands inside a Parameter, as after a "/" that was lost, is refused and not dropped.
TEST(ReadXml, ElementInsideAParameter) {
  EXPECT_EQ(parameter_error("<Parameter name=\"elements\" type=\"int\" value=\"4\">\n" +
                            parameter("width", "double", "3") + "</Parameter>"),
            "file, line 6: scene > Panels > front: <Parameter> stands inside a Parameter, which begins in line 5; a "
            "Parameter ends with \"/>\"");
}

// An attribute that means nothing is refused: it would be dropped, as the unit here.
TEST(ReadXml, UnknownAttribute) {
  EXPECT_EQ(parameter_error("<Parameter name=\"width\" type=\"double\" value=\"1\" unit=\"cm\"/>"),
            "file, line 5: scene > Panels > front: parameter \"width\" has the unknown attribute \"unit\". Valid here: "
            "name, type, value");
}

// Numbers that are not finite are refused wherever they stand, in arrays with their place.
TEST(ReadXml, NotFinite) {
  for (const std::string number : {"nan", "inf", "-inf", "infinity", "NaN"}) {
    const std::string end = number + ", not a finite number";
    EXPECT_EQ(parameter_error(parameter("width", "double", number)),
              "file, line 5: scene > Panels > front: parameter \"width\" is " + end);
    EXPECT_EQ(parameter_error(parameter("levels", "Array(double)", "{1, " + number + "}")),
              "file, line 5: scene > Panels > front: parameter \"levels\", value number 2, is " + end);
  }
}

// What is not all a decimal number of its type is refused, in scalars and in arrays, and never read in part.
TEST(ReadXml, RefusesHalfANumber) {
  for (const std::string number : {"3x", "x3", "0x10", "1 2", "1e", "+-3", "--3", "1e400", ""}) {
    EXPECT_THAT(parameter_error(parameter("elements", "int", number)), HasSubstr("expected a whole number (int)"));
    EXPECT_THAT(parameter_error(parameter("width", "double", number)), HasSubstr("expected a number (double)"));
    EXPECT_THAT(parameter_error(parameter("levels", "Array(double)", "{0, " + number + "}")),
                HasSubstr("expected numbers in braces"));
  }
  for (const std::string number : {"3.", "1e3", "3.5", "3,5", "2147483648"})
    EXPECT_THAT(parameter_error(parameter("elements", "int", number)), HasSubstr("expected a whole number (int)"));
  EXPECT_THAT(parameter_error(parameter("width", "double", "3,5")), HasSubstr("expected a number (double)"));
  EXPECT_THAT(parameter_error(parameter("edges", "Array(string)", "{top,,left}")),
              HasSubstr("expected words in braces"));
}

// A name that would be taken for a path of two lists, or breaks the line of a message, is refused.
TEST(ReadXml, NamesThatWouldBeMistaken) {
  EXPECT_EQ(
      error_of("<ParameterList name=\"s\">\n<ParameterList name=\"one > sleeve\"/></ParameterList>"),
      "file, line 2: scene: the name \"one > sleeve\" holds \" > \", which separates lists in messages and paths; "
      "choose another name");
  EXPECT_THAT(error_of("<ParameterList name=\"s\"><ParameterList name=\"one&#10;two\"/></ParameterList>"),
              HasSubstr("a line break or another control character"));
  EXPECT_THAT(
      error_of("<ParameterList name=\"s\"><ParameterList name=\"" + std::string(256, 'n') + "\"/></ParameterList>"),
      HasSubstr("has 256 characters, at most 255 are possible"));
}

// A byte order mark and Windows line ends, as Windows editors write them, change nothing.
TEST(ReadXml, ByteOrderMark) {
  std::string text = scene_with(needed);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  const ScopedFile file("\xEF\xBB\xBF" + text);
  EXPECT_EQ(read_xml(file.path(), scene_spec()).list("Panels").entries().at(0).real("width"), 12.5);
}

// Text in another encoding is refused with the encoding to save it in, or read if it names its own.
TEST(ReadXml, OtherEncodings) {
  EXPECT_EQ(error_of(std::string("\xFF\xFE<\0P\0", 6)), "file: this file is UTF-16 text; save it as UTF-8");
  const std::string latin = scene_with(needed + parameter("fabric", "string", "\xE9toffe"));
  EXPECT_THAT(error_of(latin),
              HasSubstr("line 7: not well-formed XML: not well-formed (invalid token); is the file saved "
                        "as UTF-8? Another encoding must be named in its first line"));
  const ScopedFile named("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + latin);
  EXPECT_EQ(read_xml(named.path(), scene_spec()).list("Panels").entries().at(0).word("fabric"), "\xC3\xA9toffe");
}

// Lists that are nested without end are refused before they are built.
TEST(ReadXml, DeepNesting) {
  for (const int depth : {100, 1000000}) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<ParameterList name=\"a\">";
    EXPECT_THAT(error_of(text), HasSubstr("lists are nested more than 50 deep"));
  }
}

// Entities of a document type, which may grow without end, are not read.
TEST(ReadXml, DocumentType) {
  EXPECT_EQ(error_of("<!DOCTYPE a [<!ENTITY b \"cccc\">]>\n" + scene_with(needed)),
            "file, line 1: scene: a document type (<!DOCTYPE ...>) is not read");
}

// A file that ends too early is refused with the element that was not closed.
TEST(ReadXml, EndsTooEarly) {
  EXPECT_EQ(
      error_of("<ParameterList name=\"scene\">\n<ParameterList name=\"Panels\">\n"),
      "file, line 3: not well-formed XML: no element found; the innermost open element is <ParameterList> of line 2");
}

// A pipe, a device or a link to itself is refused at once: reading it would never end.
TEST(ReadXml, NoRegularFile) {
  const std::string name = "read_xml_test." + std::to_string(getpid());
  ASSERT_EQ(mkfifo((name + ".pipe").c_str(), 0600), 0);
  ASSERT_EQ(symlink((name + ".link").c_str(), (name + ".link").c_str()), 0);
  const auto message = [](const std::string& path) { return input_error([&] { read_xml(path, scene_spec()); }); };
  EXPECT_EQ(message(name + ".pipe"), name + ".pipe: this is a pipe or a device, not a file");
  EXPECT_EQ(message("/dev/zero"), "/dev/zero: this is a pipe or a device, not a file");
  EXPECT_EQ(message(name + ".link"), name + ".link: cannot open this file: Too many levels of symbolic links");
  EXPECT_EQ(message("."), ".: this is a folder, expected an XML file");
  std::remove((name + ".pipe").c_str());
  std::remove((name + ".link").c_str());
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
            "file: scene > Panels > front: parameter \"width\" is out of range: -1 mm, allowed: > 0 mm");
}

}  // namespace
}  // namespace toile::base::test
