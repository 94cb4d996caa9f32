#include <gmock/gmock.h>

#include <cmath>

#include "base/scene.hpp"
#include "fabric_tests.hpp"
#include "mutation.hpp"
#include "toile/base/error.hpp"
#include "toile/identify/residuals.hpp"

namespace toile::identify::test {
namespace {

using ::testing::HasSubstr;

const std::vector<VirtualTest> wale = {{"wale", "uniaxial", 0.0, 2.0}};
const std::string material = parameter("type", "string", "neo-hookean");
const std::string mu = free_parameter("C10", 1e-3, 1.0);
const std::string good_data = "stretch [-], nominal stress [MPa]\n1.1, 0.01\n1.2, 0.02\n1.3, 0.03\n";

/// Message for a fit whose data file holds `text`; without the folder in front of names.
std::string data_error(const std::string& text, const std::string& extra = "", const std::string& file = "wale.csv") {
  const FitFolder folder;
  folder.write("wale.csv", text);
  folder.write("fit.xml", list("fit", list("Material", list("knit", material)) + list("Free", mu) +
                                          list("Data", list("wale", parameter("file", "string", file) +
                                                                        parameter("angle", "double", "0") + extra)) +
                                          list("Algorithm", "")));
  const base::List input = folder.read();
  std::string message = base::test::input_error([&] { FitProblem problem(input); });
  for (auto at = message.find(folder.path("")); at != std::string::npos; at = message.find(folder.path("")))
    message.replace(at, folder.path("").size(), "");
  return message;
}

/// Message for a fit with these lists and good data.
std::string fit_error(const std::string& law, const std::string& free, const std::string& constraints = "") {
  const FitFolder folder;
  folder.write("wale.csv", good_data);
  folder.write_fit(law, free, constraints, wale, "");
  const base::List input = folder.read();
  return base::test::input_error([&] { FitProblem problem(input); });
}

/// What is said of the file itself, before its problem is made.
std::string input_file_error(const std::string& law, const std::string& free) {
  const FitFolder folder;
  folder.write_fit(law, free, "", wale, "");
  return base::test::input_error([&] { (void)folder.read(); });
}

// A data file without a column of the load or the elongation: what is there, what would do, with its units.
TEST(BadData, MissingColumn) {
  EXPECT_EQ(data_error("stretch [-], load [N]\n1.1, 2\n"),
            "wale.csv, line 1: no column of the load. Found: \"stretch\", \"load\". One of these is needed: \"nominal "
            "stress\" [MPa, N/mm^2, kPa, Pa], \"line force\" [N/mm, N/cm, N/m], \"force\" [N, mN, cN, kN]");
  EXPECT_THAT(data_error("# a test\nforce [N]\n1.1\n"),
              HasSubstr("wale.csv, line 2: no column of the elongation. Found: \"force\"."));
}

// A unit that is unknown or not given: column, and the units that are allowed.
TEST(BadData, Unit) {
  EXPECT_EQ(data_error("stretch [-], nominal stress [psi]\n1.1, 2\n"),
            "wale.csv, line 1, column 2 \"nominal stress\": unknown unit \"psi\"; write \"nominal stress [unit]\" with "
            "one of: MPa, N/mm^2, kPa, Pa");
  EXPECT_EQ(data_error("strain, nominal stress [MPa]\n0.1, 2\n"),
            "wale.csv, line 1, column 1 \"strain\": no unit; write \"strain [unit]\" with one of: -, %");
}

// Two columns of the same meaning are ambiguous.
TEST(BadData, TwoColumns) {
  EXPECT_THAT(data_error("stretch [-], force [N], strain [-]\n1.1, 2, 0.1\n"),
              HasSubstr("wale.csv, line 1, column 3 \"strain\": a second column of the elongation, beside \"stretch\" "
                        "in column 1"));
}

// An elongation that does not increase: line, column, both values.
TEST(BadData, NotMonotone) {
  EXPECT_THAT(data_error("stretch [-], nominal stress [MPa]\n1.1, 0.1\n\n1.3, 0.2\n1.2, 0.15\n"),
              HasSubstr("wale.csv, line 5, column 1 \"stretch\": 1.2 is not larger than 1.3 of the row before"));
}

// A cell that is no finite number, empty, or missing.
TEST(BadData, NotANumber) {
  const std::string titles = "stretch [-], nominal stress [MPa]\n1.1, 0.1\n";
  EXPECT_EQ(data_error(titles + "1.2, nan\n"),
            "wale.csv, line 3, column 2 \"nominal stress\": \"nan\", expected a finite number with a decimal point");
  EXPECT_EQ(data_error(titles + "1.2, 0;2\n"),
            "wale.csv, line 3, column 2 \"nominal stress\": \"0;2\", expected a finite number with a decimal point");
  EXPECT_EQ(data_error(titles + ", 0.2\n"),
            "wale.csv, line 3, column 1 \"stretch\": the cell is empty, expected a finite number with a decimal point");
  EXPECT_EQ(data_error(titles + "1.2\n"), "wale.csv, line 3: 1 cells, but the titles of line 1 are 2");
}

// The mark that spreadsheets put in front of UTF-8 is no part of the first title.
TEST(BadData, ByteOrderMark) {
  EXPECT_EQ(
      data_error("\xEF\xBB\xBFstrain [furlong], nominal stress [MPa]\n0.1, 2\n"),
      "wale.csv, line 1, column 1 \"strain\": unknown unit \"furlong\"; write \"strain [unit]\" with one of: -, %");
}

/// The curve of a data file with these lines.
Curve curve_of(const std::string& text, const std::string& extra = "") {
  const FitFolder folder;
  folder.write("wale.csv", text);
  folder.write("fit.xml", list("fit", list("Material", list("knit", material)) + list("Free", mu) +
                                          list("Data", list("wale", parameter("file", "string", "wale.csv") +
                                                                        parameter("angle", "double", "0") + extra)) +
                                          list("Algorithm", "")));
  return FitProblem(folder.read()).curves().front();
}

// One table with semicolons or tabs and decimal commas, as spreadsheets write it in much of Europe, or with quotes, is
// the table that it is with commas and points.
TEST(Data, EuropeanTables) {
  const Curve plain = curve_of("stretch [-], nominal stress [MPa]\n1.1, 0.015\n1.2, 0.02\n1.35, 1e-1\n");
  ASSERT_EQ(plain.stretch, (std::vector<double>{1.1, 1.2, 1.35}));
  ASSERT_EQ(plain.stress, (std::vector<double>{0.015, 0.02, 0.1}));
  const std::string with_more_columns =
      "date; stretch [-]; remark, free; nominal stress [MPa]\n1.5.2024; 1,1; a, b; 0,015\n"
      "2.5.2024; 1,2; ; 0,02\n3.5.2024; 1,35; ; 0,1\n";
  for (const std::string& text : std::vector<std::string>{
           "stretch [-]; nominal stress [MPa]\n1,1; 0,015\n1,2; 0,02\n1,35; 1e-1\n",
           "stretch [-];nominal stress [MPa]\r\n1,1;0,015\r\n1,2;0,02\r\n1,35;0,1\r\n",
           "\xEF\xBB\xBFstretch [-]\tnominal stress [MPa]\n1,1\t0,015\n1,2\t0,02\n1,35\t0,1\n",
           "stretch [-]; nominal stress [MPa]\n1.1; 0.015\n1.2; 0.02\n1.35; 0.1\n",
           "\"stretch [-]\",\"nominal stress [MPa]\"\n\"1,1\",\"0,015\"\n\"1,2\",\"0,02\"\n\"1,35\",\"0,1\"\n",
           with_more_columns}) {
    const Curve curve = curve_of(text);
    EXPECT_EQ(curve.stretch, plain.stretch) << text;
    EXPECT_EQ(curve.stress, plain.stress) << text;
  }
}

// Numbers that can be read in two ways are refused with both, until the input says the mark.
TEST(Data, AmbiguousDecimalMark) {
  const std::string titles = "stretch [-]; nominal stress [MPa]\n";
  EXPECT_EQ(
      data_error(titles + "1,1; 0.1\n1,2; 0.2\n1,3; 0.3\n"),
      "wale.csv, line 2, column 2 \"nominal stress\": \"0.1\" has a point, but wale.csv, line 2, column 1 "
      "\"stretch\": \"1,1\" has a comma: write all numbers with one decimal mark, and without thousands separators");
  const std::string thousands = titles + "1.100; 2.100\n1.200; 2.200\n1.300; 2.300\n";
  EXPECT_EQ(
      data_error(thousands),
      "wale.csv, line 2, column 1 \"stretch\": \"1.100\" and all other numbers could have a thousands separator as "
      "well as a decimal mark; write the mark in the parameter \"decimal mark\"");
  EXPECT_EQ(curve_of(thousands, parameter("decimal mark", "string", "point")).stress.back(), 2.3);
  EXPECT_THAT(data_error(thousands, parameter("decimal mark", "string", "comma")),
              HasSubstr("line 2, column 1 \"stretch\": \"1.100\", expected a finite number with a decimal comma"));
  EXPECT_EQ(curve_of("stretch [-], nominal stress [MPa]\n1.100, 2.100\n1.200, 2.200\n1.300, 2.300\n").stress.back(),
            2.3);
  EXPECT_THAT(
      data_error("stretch [-], nominal stress [MPa]\n1,1, 0,1\n1,2, 0,2\n"),
      HasSubstr("line 2: 4 cells, but the titles of line 1 are 2; if numbers have a decimal comma, separate the "
                "columns by semicolons"));
  EXPECT_THAT(data_error(titles + "1,1; 1.234,5\n1,2; 0,2\n"), HasSubstr("\"1.234,5\", expected a finite number"));
}

// Whatever is changed in a table, its curve is read or it is refused as the user's.
TEST(Data, TablesWithFaultsAreReadOrRefused) {
  const FitFolder folder;
  folder.write("fit.xml", list("fit", list("Material", list("knit", material)) + list("Free", mu) +
                                          list("Data", list("wale", parameter("file", "string", "wale.csv") +
                                                                        parameter("angle", "double", "0"))) +
                                          list("Algorithm", "")));
  const base::List input = folder.read();
  int read = 0, refused = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const std::string text = toile::test::Mutation(seed)(
        "# a strip\nstretch [-]; room [C]; nominal stress [MPa]; date\n"
        "1,05; ; 0,01; 1.5.2024\n1,1; ; 0,02; \n1,2; ; 0,0415; \n");
    folder.write("wale.csv", text);
    try {
      FitProblem problem(input);
      ++read;
    } catch (const base::InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << text << ": " << error.what();
    }
  }
  EXPECT_GT(read + refused, 999);
  EXPECT_GT(refused, 100);
}

// What is no text in UTF-8, or no file, is refused with the reason.
TEST(Data, OtherFiles) {
  EXPECT_EQ(data_error(std::string("\xFF\xFEs\0t\0", 6)),
            "wale.csv: this is no text, or UTF-16 text; save it as CSV in UTF-8");
  EXPECT_EQ(data_error("", "", "/dev/zero"),
            "cannot read the data file /dev/zero: this is a pipe or a device, not a file");
}

// A stretch that no fabric reaches: per cent under the title of a fraction, or a wrong length at rest.
TEST(BadData, TooLarge) {
  EXPECT_EQ(data_error("strain [-], nominal stress [MPa]\n0, 0\n5, 0.1\n10, 0.2\n20, 0.3\n"),
            "wale.csv, line 4, column 1 \"strain\": 10 is a stretch of 11, allowed: <= 10; was \"strain [%]\" meant?");
  EXPECT_THAT(data_error("stretch [-], nominal stress [MPa]\n10, 0.1\n20, 0.2\n30, 0.3\n"),
              HasSubstr("line 3, column 1 \"stretch\": 20 is a stretch of 20, allowed: <= 10"));
  EXPECT_THAT(data_error("displacement [m], nominal stress [MPa]\n1, 0.1\n2, 0.2\n3, 0.3\n",
                         parameter("gauge length", "double", "100")),
              HasSubstr("1 is a stretch of 11, allowed: <= 10; is \"gauge length\" the length at rest, and is the unit "
                        "right?"));
}

// Too few rows, no titles, no file, a stretch that is impossible, no load at all.
TEST(BadData, Contents) {
  EXPECT_EQ(data_error("stretch [-], nominal stress [MPa]\n1.1, 0.1\n1.2, 0.2\n"),
            "wale.csv: 2 rows of data, at least 3 are needed");
  EXPECT_EQ(data_error("# nothing\n"), "wale.csv: the file has no line of titles");
  EXPECT_THAT(data_error("stretch [-], force [N]\n-1, 2\n1, 2\n2, 3\n", parameter("width", "double", "50")),
              HasSubstr("wale.csv, line 2, column 1 \"stretch\": -1 is a stretch of zero or less"));
  EXPECT_EQ(data_error("stretch [-], nominal stress [MPa]\n1, 0\n2, 0\n3, 0\n"), "wale.csv: every load is zero");
  EXPECT_THAT(data_error(good_data, "", "waile.csv"), HasSubstr("cannot read the data file waile.csv"));
}

// Forces need the width of the specimen, displacements its gauge length.
TEST(BadData, Specimen) {
  EXPECT_THAT(data_error("stretch [-], force [N]\n1.1, 2\n"),
              HasSubstr("fit > Data > wale: parameter \"width\" = 0 (default): must be given, because the data file "
                        "holds \"force\""));
  EXPECT_THAT(data_error("displacement [mm], force [N]\n1.1, 2\n"),
              HasSubstr("parameter \"gauge length\" = 0 (default): must be given, because the data file holds "
                        "\"displacement\""));
}

// A clamped strip is uniaxial and needs the measures of its specimen; a homogeneous state has no elements; a model that
// there is not.
TEST(BadData, ClampedStrip) {
  const std::string clamped = parameter("model", "string", "clamped strip");
  const std::string length = parameter("gauge length", "double", "100"), width = parameter("width", "double", "50");
  EXPECT_THAT(
      data_error(good_data, clamped + width),
      HasSubstr("fit > Data > wale: parameter \"gauge length\" = 0 (default): must be given, because \"model\" is "
                "\"clamped strip\""));
  EXPECT_THAT(data_error(good_data, clamped + length),
              HasSubstr("parameter \"width\" = 0 (default): must be given, because \"model\" is \"clamped strip\""));
  EXPECT_THAT(data_error(good_data, clamped + length + width + parameter("kind", "string", "equibiaxial")),
              HasSubstr("parameter \"model\" = \"clamped strip\": a clamped strip is a uniaxial test, but \"kind\" is "
                        "\"equibiaxial\""));
  EXPECT_THAT(data_error(good_data, parameter("elements across", "int", "8")),
              HasSubstr("parameter \"elements across\" = 8: a homogeneous state has no elements; \"model\" must be "
                        "\"clamped strip\""));
  const auto read_error = [](const std::string& extra) {
    return base::test::input_error([&] { data_error(good_data, extra); });
  };
  EXPECT_THAT(read_error(clamped + length + width + parameter("elements across", "int", "2")),
              HasSubstr("parameter \"elements across\" is out of range: 2, allowed: 4 <= value <= 100"));
  EXPECT_THAT(read_error(parameter("model", "string", "clamped stripe")), HasSubstr("did you mean \"clamped strip\"?"));
}

// Every unit is converted: the same test in strain and kPa, and in displacement and force of a specimen of 50 mm x
// 20 mm with the material's thickness of 0.5 mm.
TEST(Data, Conversions) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"strain [%], nominal stress [kPa]\n10, 10\n20, 20\n30, 30\n", ""},
      {"displacement [cm], force [mN], time [s]\n0.5, 100, 0\n1, 200, 1\n1.5, 300, 2\n",
       parameter("gauge length", "double", "50") + parameter("width", "double", "20")},
      {"strain [-], line force [N/m]\n0.1, 5\n0.2, 10\n0.3, 15\n", ""}};
  for (const auto& [text, extra] : files) {
    const FitFolder folder;
    folder.write("wale.csv", text);
    folder.write("fit.xml",
                 list("fit", list("Material", list("knit", material + parameter("thickness", "double", "0.5"))) +
                                 list("Free", mu) +
                                 list("Data", list("wale", parameter("file", "string", "wale.csv") +
                                                               parameter("angle", "double", "90") + extra)) +
                                 list("Algorithm", "")));
    const FitProblem problem(folder.read());
    const Curve& curve = problem.curves()[0];
    EXPECT_NEAR(curve.angle, std::acos(0.0), 1e-15);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(curve.stretch[i], 1.1 + 0.1 * i, 1e-14) << text;
      EXPECT_NEAR(curve.stress[i], 0.01 + 0.01 * i, 1e-15) << text;
    }
  }
}

// A free parameter that the material does not have, that is a word, or that has no finite interval.
TEST(BadFit, FreeParameters) {
  EXPECT_THAT(fit_error(material, free_parameter("C01", 0.1, 1.0)),
              HasSubstr("fit > Free > C01: material \"neo-hookean\" has no parameter \"C01\"; did you mean \"C10\"?"));
  EXPECT_THAT(fit_error(parameter("type", "string", "itskov"), free_parameter("swap axes", 0.0, 1.0)),
              HasSubstr("fit > Free > swap axes: \"swap axes\" is one of the words false|true; only numbers can be "
                        "free"));
  EXPECT_THAT(fit_error(material, list("C10", parameter("lower", "double", "0.1"))),
              HasSubstr("parameter \"upper\" (not given): must be given, because the material does not bound "
                        "\"C10\": the search needs a finite interval"));
}

// An interval that the material does not allow, is empty, or cannot be divided logarithmically.
TEST(BadFit, Intervals) {
  EXPECT_THAT(fit_error(material, free_parameter("C10", -1.0, 1.0)),
              HasSubstr("parameter \"lower\" = -1: -1 is outside what the material allows: > 0"));
  EXPECT_THAT(fit_error(material, free_parameter("C10", 2.0, 1.0)),
              HasSubstr("parameter \"upper\" = 1: must be larger than \"lower\" = 2"));
  EXPECT_THAT(fit_error(parameter("type", "string", "rebar"), free_parameter("c0", -1.0, 1.0, true)),
              HasSubstr("parameter \"scale\" = \"logarithmic\": logarithmic needs a positive \"lower\", which is -1"));
}

// A value to start from that its own interval excludes; one of a published set is moved into it.
TEST(BadFit, StartOutsideItsInterval) {
  EXPECT_THAT(fit_error(material + parameter("C10", "double", "2"), mu),
              HasSubstr("fit > Material > knit: parameter \"C10\" = 2: is where the search starts, but outside what "
                        "\"Free\" allows: 0.001 <= value <= 1"));
  const FitFolder folder;
  folder.write("wale.csv", good_data);
  folder.write_fit(material + parameter("set", "string", "pantyhose"), free_parameter("C10", 0.5, 1.0), "", wale, "");
  const FitProblem problem(folder.read());
  EXPECT_EQ(problem.params(problem.first_candidate())[0], 0.5);
}

// A value, of a start or fixed, that the material does not allow at all.
TEST(BadFit, ValueOutsideTheMaterialsRange) {
  EXPECT_THAT(input_file_error(material + parameter("C10", "double", "-0.1"), mu),
              HasSubstr("fit > Material > knit: parameter \"C10\" is out of range: -0.1 MPa, allowed: > 0 MPa"));
}

// A parameter that is neither given nor free; conditions on parameters that there are not, or that nothing can meet.
TEST(BadFit, Conditions) {
  EXPECT_THAT(fit_error(parameter("type", "string", "itskov"), free_parameter("mu1", 0.1, 1.0)),
              HasSubstr("must be given, because it is not in \"Free\""));
  const auto condition = [](const std::string& names) {
    return list("c", parameter("parameters", "Array(string)", names) + parameter("at most", "double", "0"));
  };
  EXPECT_THAT(fit_error(material, mu, condition("{C11}")),
              HasSubstr("fit > Constraints > c: parameter \"parameters\""));
  EXPECT_THAT(fit_error(material, mu, condition("{C10}")),
              HasSubstr("candidates within the bounds meets the conditions of the material and of \"Constraints\""));
}

// The genetic algorithm pairs its candidates: an odd number is refused.
TEST(BadFit, OddPopulation) {
  const FitFolder folder;
  folder.write("wale.csv", good_data);
  const std::string genetic = parameter("search", "string", "genetic algorithm");
  folder.write_fit(material, mu, "", wale, genetic + parameter("population", "int", "31"));
  const base::List input = folder.read();
  EXPECT_THAT(base::test::input_error([&] { Algorithm algorithm(input.list("Algorithm")); }),
              HasSubstr("fit > Algorithm: parameter \"population\" = 31: must be even"));
}

// A value that the material gives for a free parameter is a candidate of either search.
TEST(Fit, TakesTheGivenValue) {
  for (const std::string search : {"differential evolution", "genetic algorithm"}) {
    const FitFolder folder;
    folder.write("wale.csv", good_data);
    folder.write_fit(material + parameter("C10", "double", "0.0123"), mu, "", wale,
                     parameter("search", "string", search) + parameter("starts", "int", "1") +
                         parameter("generations", "int", "10"));
    const base::List input = folder.read();
    const FitProblem problem(input);
    EXPECT_NEAR(problem.params(problem.first_candidate())[0], 0.0123, 1e-15);
    const FitResult result = fit(problem, Algorithm(input.list("Algorithm")), [](const FitStatus&) {});
    Residuals residuals(problem);
    EXPECT_LE(result.chi_squared, residuals.chi_squared(problem.first_candidate())) << search;
  }
}

}  // namespace
}  // namespace toile::identify::test
