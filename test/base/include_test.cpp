#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scene.hpp"

namespace toile::base::test {
namespace {

/// A folder of scene files that is removed with this object.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("include_test." + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_ / "parts");
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name) << "<ParameterList name=\"scene\">" << content << "</ParameterList>";
    return path(name);
  }
  std::string path(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string include(const std::string& files) {
  return parameter("include", "Array(string)", "{" + files + "}");
}

std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

std::string front(const std::string& content) {
  return list("Panels", list("front", content));
}

const std::string disk = parameter("elements", "int", "4") + parameter("shape", "string", "disk") +
                         parameter("radius", "double", "3") + list("Rim", parameter("height", "double", "5"));

Spec including_spec() {
  return scene_spec().add(include_parameter());
}

List read(const std::string& file) {
  return read_xml(file, including_spec());
}

// A list holds what its file and the included files say, and the including file's value goes before the included one.
TEST(Include, MergesAndOverrides) {
  const Folder folder;
  folder.write("leg.xml", front(disk) + list("Output", parameter("file", "string", "leg.e")));
  const List scene = read(folder.write("variant.xml", include("leg.xml") + front(parameter("radius", "double", "7"))));
  const List panel = scene.list("Panels").entries().at(0);
  EXPECT_EQ(panel.real("radius"), 7.0);
  EXPECT_EQ(panel.integer("elements"), 4);
  EXPECT_EQ(panel.list("Rim").real("height"), 5.0);
  EXPECT_EQ(scene.list("Output").word("file"), "leg.e");
}

// Of several included files the later one goes before, and a table and a number may stand in for each other.
TEST(Include, LaterFileWins) {
  const Folder folder;
  const std::string table = list(
      "stiffness", parameter("position", "Array(double)", "{0, 1}") + parameter("value", "Array(double)", "{1, 2}"));
  folder.write("a.xml", front(disk + table));
  folder.write("b.xml", front(parameter("stiffness", "double", "4") + parameter("radius", "double", "8")));
  const List one = read(folder.write("ab.xml", include("a.xml, b.xml"))).list("Panels").entries().at(0);
  EXPECT_EQ(one.real("stiffness"), 4.0);
  EXPECT_EQ(one.real("radius"), 8.0);
  const List other = read(folder.write("ba.xml", include("b.xml, a.xml"))).list("Panels").entries().at(0);
  EXPECT_EQ(other.table("stiffness").size(), 2u);
  EXPECT_EQ(other.real("radius"), 3.0);
}

// A list with "replace" takes the place of the included one with everything in it.
TEST(Include, Replaces) {
  const Folder folder;
  folder.write("leg.xml", front(disk));
  const std::string box = parameter("replace", "bool", "true") + parameter("elements", "int", "2") +
                          parameter("shape", "string", "box") + parameter("width", "double", "9");
  const List panel = read(folder.write("variant.xml", include("leg.xml") + front(box))).list("Panels").entries().at(0);
  EXPECT_EQ(panel.real("width"), 9.0);
  EXPECT_EQ(panel.integer("elements"), 2);
}

// A list with "remove" takes the included one out, and is not one of the scene itself.
TEST(Include, Removes) {
  const Folder folder;
  folder.write("leg.xml", list("Panels", list("front", disk) + list("back", disk)));
  const std::string removed = list("Panels", list("front", parameter("remove", "bool", "true")));
  const auto panels = read(folder.write("variant.xml", include("leg.xml") + removed)).list("Panels").entries();
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels.at(0).name(), "back");
}

// Paths count from the folder of the file that names them, over several levels, and every value knows its file.
TEST(Include, KnowsTheFileOfEveryValue) {
  const Folder folder;
  const std::string base = folder.write("parts/base.xml", front(disk));
  const std::string middle = folder.write("parts/middle.xml", include("base.xml"));
  const std::string top =
      folder.write("top.xml", include("parts/middle.xml") + front(parameter("radius", "double", "7")));
  const List panel = read(top).list("Panels").entries().at(0);
  EXPECT_EQ(panel.file("radius"), top);
  EXPECT_EQ(panel.file("elements"), base);
  EXPECT_EQ(panel.list("Rim").file(), base);
  EXPECT_EQ(panel.file("share"), top);
}

// A fault is reported with the file that it stands in, in the included file as in the including one.
TEST(Include, NamesTheFileAtFault) {
  const Folder folder;
  const std::string leg = folder.write("leg.xml", front(disk + parameter("sown", "bool", "true")));
  const std::string variant =
      folder.write("variant.xml", include("leg.xml") + front(parameter("radius", "double", "-1")));
  const std::string message = input_error([&] { read(variant); });
  EXPECT_NE(message.find(variant + ": scene > Panels > front: parameter \"radius\" is out of range: -1 mm, "
                                   "allowed: > 0 mm"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find(leg + ": scene > Panels > front: unknown parameter \"sown\"; did you mean \"sewn\"?"),
            std::string::npos)
      << message;
}

// What an author of a package refuses later is reported with the file that wrote the parameter.
TEST(Include, RefusesWithTheFileOfTheParameter) {
  const Folder folder;
  const std::string leg = folder.write("leg.xml", front(disk));
  const std::string variant =
      folder.write("variant.xml", include("leg.xml") + front(parameter("share", "double", "1")));
  const List panel = read(variant).list("Panels").entries().at(0);
  EXPECT_EQ(input_error([&] { panel.fail("radius", "must be even"); }),
            leg + ": scene > Panels > front: parameter \"radius\" = 3: must be even");
}

// An included file that is missing is reported with the file that names it.
TEST(Include, MissingFile) {
  const Folder folder;
  const std::string file = folder.write("leg.xml", include("nowhere.xml"));
  EXPECT_EQ(input_error([&] { read(file); }),
            file + ": scene: parameter \"include\" names \"nowhere.xml\", but of the file " +
                folder.path("nowhere.xml") + ": cannot open this file: No such file or directory");
}

// Files that include each other in a circle are refused.
TEST(Include, Circle) {
  const Folder folder;
  const std::string a = folder.write("a.xml", include("b.xml"));
  const std::string b = folder.write("b.xml", include("a.xml"));
  EXPECT_EQ(input_error([&] { read(a); }),
            b + ": scene: parameter \"include\" names \"a.xml\", which includes this file again");
}

// Files that each include the next one twice are refused long before their millions of readings are done.
TEST(Include, Bomb) {
  const Folder folder;
  std::string last = "leg.xml";
  folder.write(last, front(disk));
  for (int i = 0; i < 25; ++i) {
    const std::string next = "bomb" + std::to_string(i) + ".xml";
    folder.write(next, include(last + ", " + last));
    last = next;
  }
  const std::string message = input_error([&] { read(folder.path(last)); });
  EXPECT_NE(message.find("more than 200 files are included"), std::string::npos) << message;
}

// "replace" where no included file has that list is refused: it is a misspelling.
TEST(Include, NothingToReplace) {
  const Folder folder;
  folder.write("leg.xml", front(disk));
  const std::string variant =
      folder.write("variant.xml", include("leg.xml") + list("Panel", parameter("replace", "bool", "true")));
  EXPECT_EQ(input_error([&] { read(variant); }),
            variant + ": scene > Panel: parameter \"replace\" is true, but no included file has this list");
}

// So is "remove"; and where the list goes on, somebody meant "replace".
TEST(Include, NothingToRemove) {
  const Folder folder;
  folder.write("leg.xml", front(disk));
  const std::string remove = parameter("remove", "bool", "true");
  const std::string variant = folder.write("variant.xml", include("leg.xml") + list("Panel", remove));
  EXPECT_EQ(input_error([&] { read(variant); }),
            variant + ": scene > Panel: parameter \"remove\" is true, but no included file has this list");
  const std::string more = folder.write(
      "more.xml", include("leg.xml") + list("Panels", remove + list("front", parameter("width", "double", "9"))));
  EXPECT_EQ(input_error([&] { read(more); }),
            more +
                ": scene > Panels: parameter \"remove\" is true, but the list has more in it: \"replace\" takes "
                "the place of the included list");
}

// A description that does not declare "include" refuses it.
TEST(Include, OnlyWhereItIsDeclared) {
  const Folder folder;
  folder.write("leg.xml", front(disk));
  const std::string variant = folder.write("variant.xml", include("leg.xml"));
  const std::string message = input_error([&] { read_xml(variant, scene_spec()); });
  EXPECT_EQ(message, variant + ": scene: unknown parameter \"include\"; nothing is valid here");
}

}  // namespace
}  // namespace toile::base::test
