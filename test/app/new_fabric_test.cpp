#include <filesystem>
#include <sstream>

#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string fabrics = TOILE_SOURCE_DIR "/input/fabrics/";
const std::string itskov_material = "\"itskov\"/>\n      <Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>";

class NewFabric : public ProgramTest {
 protected:
  /// The strip of scenes/strip.xml with another material and more lists.
  void write_strip(const std::string& material, const std::string& lists = "") const {
    write_scene("strip", {{itskov_material, material},
                          {"<ParameterList name=\"Materials\">", lists + "<ParameterList name=\"Materials\">"}});
  }
  /// Last line of the force curve of a run that must succeed.
  std::string last_force(const std::string& options = "") const {
    const Outcome run = toile("run scene.xml --output out " + options);
    EXPECT_EQ(run.status, 0) << run.err;
    std::string text = read("out/force-curves.csv");
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
  }
};

std::vector<double> numbers(const std::string& line) {
  std::vector<double> all;
  std::istringstream cells(line);
  for (std::string cell; std::getline(cells, cell, ',');) all.push_back(std::stod(cell));
  return all;
}

void expect_same_numbers(const std::string& found, const std::string& expected) {
  const std::vector<double> a = numbers(found), b = numbers(expected);
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GE(a.size(), 2u);
  for (size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-5 * std::abs(b[i]) + 1e-12) << found;
}

std::string real(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + value + "\"/>";
}

std::string word(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>";
}

const std::string neo_hookean = "\"neo-hookean\"/>" + real("C10", "0.015");

std::string formulas(const std::string& energy) {
  return "<ParameterList name=\"Formulas\"><ParameterList name=\"typed\">" + word("energy", energy) +
         "<ParameterList name=\"Parameters\"><ParameterList name=\"mu\">" + word("unit", "MPa") + real("lower", "0") +
         "</ParameterList></ParameterList></ParameterList></ParameterList>";
}

// From a C++ file to a running scene: built by the command, refused until allowed, described, and run; without its
// fibres the fibre-reinforced membrane pulls like the neo-Hookean law with C10 = c/2.
TEST_F(NewFabric, PlugIn) {
  std::filesystem::copy_file(fabrics + "holzapfel_gasser_ogden.cpp", path("hgo.cpp"));
  const Outcome build = toile("material build hgo.cpp");
  EXPECT_EQ(build.status, 0) << build.err;
  EXPECT_THAT(build.out,
              AllOf(StartsWith("hgo.so: law \"holzapfel-gasser-ogden\", parameters c, k1, k2, theta, kappa\n"),
                    HasSubstr("<Parameter name=\"file\" type=\"string\" value=\"hgo.so\"/>")));
  const std::string plugins = "<ParameterList name=\"Plug-ins\"><ParameterList name=\"holzapfel-gasser-ogden\">" +
                              word("file", "hgo.so") + "</ParameterList></ParameterList>";
  write_strip(
      "\"holzapfel-gasser-ogden\"/>" + real("c", "0.03") + real("k1", "0") + real("k2", "1") + real("theta", "30"),
      plugins);

  for (const char* command : {"run scene.xml", "check scene.xml", "describe --scene scene.xml"}) {
    const Outcome refused = toile(command);
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err,
                AllOf(StartsWith("toile: scene.xml: scene > Plug-ins > holzapfel-gasser-ogden: parameter \"file\" = "
                                 "\"hgo.so\": this would run the program in /"),
                      HasSubstr("allow that with the option --allow-plugins")));
  }
  const Outcome description = toile("describe Materials --scene scene.xml --allow-plugins");
  EXPECT_THAT(description.out, AllOf(HasSubstr("holzapfel-gasser-ogden"), HasSubstr("Angle between the fibres")));
  EXPECT_EQ(toile("check scene.xml --allow-plugins").status, 0);
  const std::string without_fibres = last_force("--allow-plugins");

  write_strip(neo_hookean);
  expect_same_numbers(without_fibres, last_force());
}

// The author's path with the shipped files: built, checked, fitted and used; check and fit are refused until the
// plug-in is allowed, and a refused fit writes nothing.
TEST_F(NewFabric, CheckFitAndUse) {
  std::filesystem::create_directories(path("fabrics"));
  for (const char* name : {"fung_orthotropic.cpp", "fung.xml"})
    std::filesystem::copy_file(fabrics + name, path("fabrics/") + name);
  std::filesystem::copy(TOILE_SOURCE_DIR "/input/identify", path("identify"));
  EXPECT_EQ(toile("material build fabrics/fung_orthotropic.cpp").status, 0);

  const std::string what = " > Plug-ins > fung-orthotropic: parameter \"file\" = ";
  const Outcome unchecked = toile("material check fabrics/fung.xml --output map");
  EXPECT_EQ(unchecked.status, 2);
  EXPECT_THAT(unchecked.err, AllOf(StartsWith("toile: fabrics/fung.xml: fabric" + what),
                                   HasSubstr("allow that with the option --allow-plugins")));
  const Outcome checked = toile("material check fabrics/fung.xml --output map --allow-plugins");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("fung (fung-orthotropic): passed"));

  const Outcome unfitted = toile("identify identify/fung.xml --output fit");
  EXPECT_EQ(unfitted.status, 2);
  EXPECT_THAT(unfitted.err, AllOf(StartsWith("toile: identify/fung.xml: fit" + what),
                                  HasSubstr("allow that with the option --allow-plugins")));
  EXPECT_FALSE(exists("fit"));
  const Outcome fitted = toile("identify identify/fung.xml --output fit --allow-plugins");
  EXPECT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_THAT(fitted.out, HasSubstr("let it include fit/include.xml"));
  EXPECT_THAT(toile("identify identify/fung.xml --describe --allow-plugins").out, HasSubstr("Factor of E11^2 (wale)"));

  EXPECT_THAT(toile("material check fit/include.xml fitted --output map --allow-plugins").out,
              HasSubstr("fitted (fung-orthotropic): passed"));
  const std::string include = "<Parameter name=\"include\" type=\"Array(string)\" value=\"{fit/include.xml}\"/>";
  write_scene("strip", {{"<ParameterList name=\"Materials\">", include + "<ParameterList name=\"Materials\">"},
                        {"name=\"material\" type=\"string\" value=\"fabric\"",
                         "name=\"material\" type=\"string\" value=\"fitted\""}});
  EXPECT_GT(numbers(last_force("--allow-plugins")).back(), 0.0);
}

// A plug-in of another version is refused by a check and by a fit, which name the list, the version and the remedy.
TEST_F(NewFabric, PlugInOfAnotherVersion) {
  write("old.cpp",
        "struct Stamp { int abi, lanes; const char *version, *compiler; };\n"
        "struct PlugIn { Stamp stamp; char law[256]; };\n"
        "extern \"C\" __attribute__((visibility(\"default\"))) const PlugIn toile_material = {{1, 1, \"0.0.1-abc\", "
        "__VERSION__}, {}};\n");
  EXPECT_THAT(toile("material build old.cpp").err, HasSubstr("built for another Toile"));
  const std::string plugins = "<ParameterList name=\"Plug-ins\"><ParameterList name=\"old\">" + word("file", "old.so") +
                              "</ParameterList></ParameterList>";
  write("fabric.xml", "<ParameterList name=\"fabric\">" + plugins + "</ParameterList>");
  write("fit.xml", "<ParameterList name=\"fit\">" + plugins + "</ParameterList>");
  for (const std::string command : {"material check fabric", "identify fit"}) {
    const Outcome refused = toile(command + ".xml --allow-plugins");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr(" > Plug-ins > old: parameter \"file\" = \"old.so\": old.so: this plug-in was "
                                "built for another Toile; its version is 0.0.1-abc, that of this Toile is "),
                      HasSubstr("Build it again with toile material build")));
  }
}

// The shipped scene of a plug-in runs as its comment says.
TEST_F(NewFabric, ShippedScene) {
  std::filesystem::copy_file(fabrics + "strip.xml", path("scene.xml"));
  EXPECT_EQ(toile("material build " + fabrics + "holzapfel_gasser_ogden.cpp --output holzapfel_gasser_ogden.so").status,
            0);
  const std::vector<double> force = numbers(last_force("--allow-plugins"));
  EXPECT_GT(force.back(), 0.0);
}

// A mistake in the C++ file: exit status 2, the author's file and line, and with --verbose the command.
TEST_F(NewFabric, CompilerErrors) {
  write("bad.cpp", "#include \"toile/material/plugin.hpp\"\nint answer = forty_two;\n");
  const Outcome build = toile("material build bad.cpp");
  EXPECT_EQ(build.status, 2);
  EXPECT_THAT(build.err, StartsWith("toile: bad.cpp does not compile:\nbad.cpp:2:14: error: "));
  EXPECT_THAT(build.out, Not(HasSubstr("-shared")));
  EXPECT_THAT(toile("material build bad.cpp --verbose").out, HasSubstr("-shared"));
  EXPECT_FALSE(exists("bad.so"));
}

// A typed energy gives what the built-in law gives, on one rank and on three.
TEST_F(NewFabric, Formula) {
  write_strip(neo_hookean);
  const std::string expected = last_force();
  write_strip("\"typed\"/>" + real("mu", "0.03"), formulas("i = C11 + C22 + 1/(C11*C22 - C12^2); mu/2*(i - 3)"));
  expect_same_numbers(last_force(), expected);
  const Outcome ranks = toile("run scene.xml --output three", 3);
  EXPECT_EQ(ranks.status, 0) << ranks.err;
}

// A formula that does not parse: the scene's list, the place, the nearest name.
TEST_F(NewFabric, FormulaThatDoesNotParse) {
  write_strip("\"typed\"/>" + real("mu", "0.03"), formulas("mu/2*(I1 - 3"));
  EXPECT_THAT(
      toile("run scene.xml").err,
      StartsWith("toile: scene.xml: scene > Formulas > typed: parameter \"energy\" = \"mu/2*(I1 - 3\": character "
                 "13: expected an operator or \")\"\n  mu/2*(I1 - 3\n              ^\n"));
  write_strip("\"typed\"/>" + real("mu", "0.03"), formulas("mu/2*(Il - 3)"));
  EXPECT_THAT(toile("run scene.xml").err, HasSubstr("character 7: unknown name \"Il\"; did you mean \""));
}

// The same in the file of a check and in that of a fit.
TEST_F(NewFabric, FormulaThatDoesNotParseElsewhere) {
  for (const auto& [root, command] :
       {std::pair<std::string, std::string>{"fabric", "material check"}, {"fit", "identify"}}) {
    write("file.xml", "<ParameterList name=\"" + root + "\">" + formulas("mu/2*(I1 - 3") + "</ParameterList>");
    const Outcome refused = toile(command + " file.xml");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err,
                StartsWith("toile: file.xml: " + root +
                           " > Formulas > typed: parameter \"energy\" = \"mu/2*(I1 - 3\": character 13: expected an "
                           "operator or \")\"\n  mu/2*(I1 - 3\n              ^\n"));
  }
}

// A formula in a fabric's file is checked like any law: the neo-Hookean energy passes, one that is not stable in
// tension fails.
TEST_F(NewFabric, FormulaIsChecked) {
  const auto check = [&](const std::string& energy) {
    write("fabric.xml", "<ParameterList name=\"fabric\">" + formulas(energy) + "<ParameterList name=\"Material\">" +
                            word("type", "typed") + real("mu", "0.03") +
                            "</ParameterList><ParameterList name=\"Check\"><Parameter name=\"points\" type=\"int\" "
                            "value=\"12\"/><Parameter name=\"shear points\" type=\"int\" value=\"3\"/>"
                            "</ParameterList></ParameterList>");
    return toile("material check fabric.xml");
  };
  EXPECT_EQ(check("mu/2*(I1 - 3)").status, 0);
  const Outcome unstable = check("mu/2*ln(I1 - 2)");
  EXPECT_EQ(unstable.status, 4);
  EXPECT_THAT(unstable.err, HasSubstr("ellipticity in tension"));
}

// A formula with stress in its natural state is refused with the values.
TEST_F(NewFabric, FormulaWithStress) {
  write_strip("\"typed\"/>" + real("mu", "0.5"), formulas("mu*(C11 + C22 - 2)"));
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err,
              HasSubstr("scene > Materials > fabric: parameter \"type\" = \"typed\": the natural state (C11 = "
                        "C22 = 1, C12 = 0) must be free of energy and stress, but there W = 0, S11 = 1, S22 = 1"));
}

}  // namespace
}  // namespace toile::test
