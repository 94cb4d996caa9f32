#include "plugins.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>

#include <Teuchos_ParameterList.hpp>

#include "input_error.hpp"
#include "toile/base/error.hpp"
#include "toile/material/lane.hpp"

namespace toile::material::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string entry = "{\"C10\", \"MPa\", \"Modulus.\", 1.0, 0.0, infinity, 1}";

/// A fabric of five lines; `line` is its energy, `entries` are the `declared` ones of its info.
std::string fabric(const std::string& name, const std::string& line, const std::string& entries = entry,
                   int declared = 1) {
  return "#include \"toile/material/plugin.hpp\"\n"
         "using namespace toile::material;\n"
         "struct Fabric {\n"
         "  static constexpr const char *name = \"" +
         name +
         "\", *text = \"A test.\";\n"
         "  static constexpr std::array<ParamInfo, " +
         std::to_string(declared) + "> info = {{" + entries +
         "}};\n"
         "  template <class T, class P> static T energy(const PlaneC<T>& c, const Params<P>& p) {\n"
         "    " +
         line +
         "\n"
         "  }\n"
         "};\n"
         "TOILE_MATERIAL(Fabric)\n";
}

const std::string good_line = "return p[0] * (c.C11 + c.C22 + c.C33 - 3.0);";

/// A plug-in from C++ that need not hold a fabric.
std::string build(const Folder& folder, const std::string& name, const std::string& text) {
  const PlugInBuild result = build_plugin(folder.write(name + ".cpp", text), folder.file(name + ".so"));
  EXPECT_TRUE(result.good) << result.messages;
  return folder.file(name + ".so");
}

base::List plugins_list(const std::string& name, const std::string& file, const std::string& scene) {
  Teuchos::ParameterList list;
  list.sublist(name).set("file", file);
  return base::validate(list, plugins_spec(), scene);
}

// A plug-in with the energy of a built-in law gives the same numbers as that, to the last bit, with its own name.
TEST(PlugIn, same_numbers_as_built_in) {
  const Folder folder;
  const Laws::Law law = load_plugin(build(folder, "mine", fabric("mine", good_line)));
  EXPECT_STREQ(law->name, "mine");
  const std::array<double, 3> C = {1.7, 0.9, 0.3};
  const double C10 = 0.7;
  std::array<double, 3> S = {}, expected_S = {};
  std::array<double, 6> D = {}, expected_D = {};
  double W = 0.0, h = 0.0, expected_W = 0.0, expected_h = 0.0;
  std::uint8_t status = 9;
  EXPECT_EQ(law->evaluate(law->context, 1, C.data(), &C10, 0, &W, S.data(), D.data(), &h, nullptr, &status), 0);
  EXPECT_EQ(status, point_ok);
  const LawV1& built_in = *find("neo-hookean");
  built_in.evaluate(nullptr, 1, C.data(), &C10, 0, &expected_W, expected_S.data(), expected_D.data(), &expected_h,
                    nullptr, &status);
  EXPECT_EQ(W, expected_W);
  EXPECT_EQ(S, expected_S);
  EXPECT_EQ(D, expected_D);
  EXPECT_EQ(h, expected_h);
}

// A mistake in the author's energy is shown with the author's file and line, the compiler's own text and nothing else.
TEST(PlugIn, compiler_errors_are_short) {
  const Folder folder;
  const std::string source = folder.write("bad.cpp", fabric("bad", "return p[0] * (c.C11 + c.C21 - 2.0);"));
  const PlugInBuild result = build_plugin(source, folder.file("bad.so"));
  EXPECT_FALSE(result.good);
  EXPECT_THAT(result.messages, AllOf(StartsWith(source + ":7:"), HasSubstr("error: "), HasSubstr("C21")));
  EXPECT_THAT(result.messages, AllOf(HasSubstr("PlaneC<T>"), Not(HasSubstr("Sacado"))));
  // Once, although the energy is compiled for several types T: the error, the line of code and two lines of marks.
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 4) << result.messages;
  EXPECT_THAT(result.command, AllOf(HasSubstr("-shared"), HasSubstr(source)));
}

// A mistake that the compiler finds in a header of Toile (an `if` on a T) is told at the line of the author.
TEST(PlugIn, errors_in_headers_name_the_authors_line) {
  const Folder folder;
  const std::string source = folder.write("bad.cpp", fabric("bad", "if (c.C11 < 1.0) return T(0.0); " + good_line));
  const PlugInBuild result = build_plugin(source, folder.file("bad.so"));
  EXPECT_FALSE(result.good);
  EXPECT_THAT(result.messages, AllOf(StartsWith(source + ":"), HasSubstr("error: "), Not(HasSubstr("/include/"))));
}

/// What is said of a file bad.cpp with `text`, without the folder in front of names; no library is left behind.
std::string build_error(const std::string& text) {
  const Folder folder;
  const PlugInBuild result = build_plugin(folder.write("bad.cpp", text), folder.file("bad.so"));
  EXPECT_FALSE(result.good);
  EXPECT_FALSE(std::filesystem::exists(folder.file("bad.so")));
  std::string message = result.messages;
  for (auto at = message.find(folder.file("")); at != std::string::npos; at = message.find(folder.file("")))
    message.replace(at, folder.file("").size(), "");
  return message;
}

// More entries of info than are written, and two of one name, are refused when the fabric is compiled.
TEST(PlugIn, entries_of_info) {
  EXPECT_THAT(build_error(fabric("bad", good_line, entry, 2)),
              AllOf(StartsWith("bad.cpp:10:"), HasSubstr("`info` is declared with more entries than are written")));
  EXPECT_THAT(build_error(fabric("bad", good_line, entry + ", " + entry, 2)),
              AllOf(StartsWith("bad.cpp:10:"), HasSubstr("two entries of `info` have the same name")));
}

// What newcomers write of habit is told once, at their line, in the names that they wrote, with what to write instead.
TEST(PlugIn, hints) {
  const auto hinted = [](const std::string& error, const std::string& hint) {
    return AllOf(StartsWith("bad.cpp:7:"), HasSubstr(error), HasSubstr("\nHint: " + hint), Not(HasSubstr("Sacado")),
                 Not(HasSubstr("toile::material")), Not(HasSubstr("bad.cpp:10:")));
  };
  EXPECT_THAT(build_error(fabric("bad", "if (c.C11 > 1.0) return T(0.0); " + good_line)),
              hinted("operator>", "an energy has no `if` on a variable: use where(less(a, b), yes, no)\n"));
  EXPECT_THAT(
      build_error(fabric("bad", "return power(c.C11 + c.C22, p[0]);")),
      hinted("power(expression, ", "functions take variables, not expressions: write const T x = ...; first\n"));
  EXPECT_THAT(build_error(fabric("bad", "return p[0] * reciprocal(c.C11 - 2.0);")),
              hinted("reciprocal(expression)", "functions take variables"));
  const std::string functions = "the functions of an energy are power, exp, log, sqrt, sin, cos, reciprocal";
  EXPECT_THAT(build_error(fabric("bad", "return p[0] * pow(c.C11, 2.0);")), hinted("pow(const T&, double)", functions));
  EXPECT_THAT(build_error(fabric("bad", "return p[0] * std::exp(c.C11);")), hinted("exp(const T&)", functions));
}

// A file that ends without its TOILE_MATERIAL holds no fabric: what is missing is named.
TEST(PlugIn, no_fabric_in_source) {
  EXPECT_EQ(build_error("int answer() { return 42; }\n"),
            "bad.cpp: error: TOILE_MATERIAL(YourLaw) is missing: end the file with it, YourLaw being the fabric's "
            "struct\n");
}

// A file that is not C++ by its name is refused before the compiler or the linker sees it.
TEST(PlugIn, no_cpp_file) {
  const Folder folder;
  const std::string scene = folder.write("scene.xml", "<ParameterList/>");
  EXPECT_EQ(input_error([&] { build_plugin(scene, folder.file("scene.so")); }),
            scene + ": a plug-in is made from a C++ file; the name ends with \".xml\", allowed: .cpp, .cc, .cxx");
}

// A source that is not there.
TEST(PlugIn, no_source) {
  EXPECT_EQ(input_error([] { build_plugin("nowhere.cpp", "nowhere.so"); }), "nowhere.cpp: there is no such file");
}

// What is not there, no shared library or no fabric is refused by name.
TEST(PlugIn, not_a_plugin) {
  const Folder folder;
  EXPECT_THAT(input_error([] { load_plugin("nowhere.so"); }),
              StartsWith("nowhere.so: there is no such plug-in; toile material build makes one"));
  const std::string text = folder.write("text.so", "no library");
  EXPECT_THAT(input_error([&] { load_plugin(text); }),
              StartsWith(text + ": this is not a shared library that can be loaded: "));
  Dl_info c_library = {};
  ASSERT_NE(dladdr(dlsym(RTLD_DEFAULT, "getenv"), &c_library), 0);
  const std::string empty = c_library.dli_fname;
  EXPECT_THAT(input_error([&] { load_plugin(empty); }), StartsWith(empty + ": this library holds no fabric"));
}

// A plug-in with another stamp is refused; the message says what differs and what to do.
TEST(PlugIn, other_version) {
  const Folder folder;
  const auto stamped = [&](const std::string& name, const std::string& stamp) {
    // Written without the headers, because the layout of the stamp is fixed for ever.
    const std::string library =
        build(folder, name,
              "struct Stamp { int abi, lanes; const char *version, *compiler; };\n"
              "struct PlugIn { Stamp stamp; char law[256]; };\n"
              "extern \"C\" __attribute__((visibility(\"default\"))) const PlugIn toile_material = {{" +
                  stamp + "}, {}};\n");
    return input_error([&] { load_plugin(library); });
  };
  const std::string abi = std::to_string(material_abi), width = std::to_string(lanes);
  EXPECT_THAT(
      stamped("old", abi + ", " + width + ", \"0.0.1-abc\", __VERSION__"),
      AllOf(HasSubstr("old.so: this plug-in was built for another Toile; its version is 0.0.1-abc, that of this "
                      "Toile is "),
            HasSubstr("Build it again with toile material build"), Not(HasSubstr("lanes"))));
  EXPECT_THAT(stamped("abi", "2, " + width + ", TOILE_MATERIAL_VERSION, __VERSION__"),
              HasSubstr("; its interface is 2, that of this Toile is 1. Build"));
  EXPECT_THAT(stamped("lanes", abi + ", 16, TOILE_MATERIAL_VERSION, __VERSION__"),
              HasSubstr("; its number of lanes is 16, that of this Toile is "));
  EXPECT_THAT(stamped("compiler", abi + ", " + width + ", TOILE_MATERIAL_VERSION, \"1.0\""),
              HasSubstr("; its compiler is 1.0, that of this Toile is "));
}

// A scene's plug-in is not run unless the user allows it; the message names the program and the option.
TEST(PlugIns, only_if_allowed) {
  Laws laws;
  const base::List list = plugins_list("mine", "mine.so", "/somewhere/scene.xml");
  EXPECT_EQ(input_error([&] { add_plugins(list, false, laws); }),
            "/somewhere/scene.xml: Plug-ins > mine: parameter \"file\" = \"mine.so\": this would run the program "
            "in /somewhere/mine.so. If you trust it, allow that with the option --allow-plugins");
  EXPECT_EQ(laws.all().size(), registry().size());
}

// A plug-in that is allowed joins the laws, from the folder of the scene; the built-in registry stays as it is.
TEST(PlugIns, join_the_laws) {
  const Folder folder;
  build(folder, "mine", fabric("mine", good_line));
  Laws laws;
  add_plugins(plugins_list("mine", "mine.so", folder.file("scene.xml")), true, laws);
  ASSERT_NE(laws.find("mine"), nullptr);
  EXPECT_EQ(find("mine"), nullptr);
  EXPECT_EQ(Laws().find("mine"), nullptr);
  Teuchos::ParameterList fabric_list;
  fabric_list.set("type", "mine");
  fabric_list.set("C01", 0.3);
  EXPECT_THAT(input_error([&] { base::validate(fabric_list, material_spec(laws), "scene.xml"); }),
              HasSubstr("unknown parameter \"C01\"; did you mean \"C10\"?"));
}

// A plug-in whose law has the name of a built-in one, or another name than the list, is refused.
TEST(PlugIns, name_clash) {
  const Folder folder;
  build(folder, "copy", fabric("neo-hookean", good_line));
  Laws laws;
  EXPECT_THAT(
      input_error([&] { add_plugins(plugins_list("neo-hookean", "copy.so", folder.file("scene.xml")), true, laws); }),
      HasSubstr("\"file\" = \"copy.so\": there is a law named \"neo-hookean\" already"));
  EXPECT_THAT(input_error([&] { add_plugins(plugins_list("other", "copy.so", folder.file("scene.xml")), true, laws); }),
              HasSubstr("the law in this plug-in is named \"neo-hookean\"; name the list so"));
}

// A fabric that is not stress-free where it is not deformed is refused, with its stress.
TEST(PlugIns, natural_state) {
  const Folder folder;
  build(folder, "tight", fabric("tight", "return p[0] * (c.C11 + c.C22 - 2.0);"));
  Laws laws;
  add_plugins(plugins_list("tight", "tight.so", folder.file("scene.xml")), true, laws);
  Teuchos::ParameterList list;
  list.set("type", "tight");
  list.set("C10", 0.5);
  EXPECT_THAT(input_error([&] { Material(base::validate(list, material_spec(laws), "scene.xml"), laws); }),
              HasSubstr("parameter \"type\" = \"tight\": the natural state (C11 = C22 = 1, C12 = 0) must be free of "
                        "energy and stress, but there W = 0, S11 = 1, S22 = 1, S12 = 0 MPa"));
}

}  // namespace
}  // namespace toile::material::test
