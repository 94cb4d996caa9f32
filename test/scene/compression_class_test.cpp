#include "toile/scene/compression_class.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::HasSubstr;

const CompressionClass ii{"RAL-GZ 387", "II", 23.0, 32.0}, iv{"RAL-GZ 387", "IV", 49.0, HUGE_VAL};

// The limits that the standards print, by the class that they put a pressure into; limits belong to their class.
TEST(CompressionClass, LimitsAreThoseOfTheStandards) {
  const std::string ral = "RAL-GZ 387", env = "ENV 12718";
  EXPECT_EQ(compression_standards(), (std::vector<std::string>{ral, env}));
  for (const auto& [name, lower, upper] : std::vector<std::tuple<std::string, double, double>>{
           {"I", 18.0, 21.0}, {"II", 23.0, 32.0}, {"III", 34.0, 46.0}, {"IV", 49.0, 500.0}})
    for (const double pressure : {lower, 0.5 * (lower + upper), upper}) EXPECT_EQ(class_text(ral, pressure), name);
  for (const auto& [name, lower, upper] : std::vector<std::tuple<std::string, double, double>>{
           {"A", 10.0, 14.0}, {"I", 15.0, 21.0}, {"II", 23.0, 32.0}, {"III", 34.0, 46.0}, {"IV", 49.0, 500.0}})
    for (const double pressure : {lower, 0.5 * (lower + upper), upper}) EXPECT_EQ(class_text(env, pressure), name);
}

// What lies in no class is told by its neighbours.
TEST(CompressionClass, GapsAreNamed) {
  EXPECT_EQ(class_text("RAL-GZ 387", 17.9), "below I");
  EXPECT_EQ(class_text("RAL-GZ 387", 22.0), "between I and II");
  EXPECT_EQ(class_text("RAL-GZ 387", 48.9), "between III and IV");
  EXPECT_EQ(class_text("ENV 12718", 14.5), "between A and I");
  EXPECT_EQ(class_text("ENV 12718", NAN), "none");
}

// All of the error bar inside passes, all of it outside fails, a limit in it leaves it open: from either side, at
// either limit, without an upper limit, and with no estimate of the error.
TEST(CompressionClass, VerdictIsThatOfTheErrorBar) {
  EXPECT_EQ(verdict(ii, 27.5, 4.5), Verdict::pass);
  EXPECT_EQ(verdict(ii, 23.5, 0.51), Verdict::undecided);
  EXPECT_EQ(verdict(ii, 22.5, 0.51), Verdict::undecided);
  EXPECT_EQ(verdict(ii, 22.5, 0.49), Verdict::fail);
  EXPECT_EQ(verdict(ii, 31.5, 0.51), Verdict::undecided);
  EXPECT_EQ(verdict(ii, 32.5, 0.49), Verdict::fail);
  EXPECT_EQ(verdict(ii, 27.5, 20.0), Verdict::undecided);
  EXPECT_EQ(verdict(iv, 1e4, 100.0), Verdict::pass);
  EXPECT_EQ(verdict(ii, 27.5, NAN), Verdict::undecided);
}

// An open verdict says what would decide it: at a lower limit from outside, at an upper one from inside, with an error
// that is wider than the class, on the limit itself.
TEST(CompressionClass, TellsWhatDecides) {
  EXPECT_EQ(
      what_decides(ii, 22.5, 1.25),
      "the error bar crosses 23 mmHg: it is decided (fails) if the error falls by 0.75 mmHg to below 0.5 mmHg; it "
      "passes with this error if the pressure rises by 1.75 mmHg");
  EXPECT_EQ(
      what_decides(ii, 31.5, 1.25),
      "the error bar crosses 32 mmHg: it is decided (passes) if the error falls by 0.75 mmHg to below 0.5 mmHg; it "
      "passes with this error if the pressure falls by 0.75 mmHg");
  EXPECT_THAT(what_decides(ii, 24.0, 6.0), HasSubstr("to below 1 mmHg; with this error no pressure passes"));
  EXPECT_THAT(what_decides(ii, 23.0, 1.0), HasSubstr("no error is small enough on the limit itself"));
  EXPECT_EQ(what_decides(ii, 24.0, NAN), "there is no estimate of its error");
}

ParameterList with_class(const std::string& quantity) {
  ParameterList list = tube_scene();
  list.sublist("Output").sublist("Levels").sublist("B").set("height", 20.0);
  list.sublist("Checks").sublist("class").set("quantity", quantity).set("class", std::string("II"));
  return list;
}

// Level B and RAL-GZ 387 unless the scene says otherwise.
TEST(CompressionClass, IsRead) {
  ParameterList list = with_class("compression class");
  list.sublist("Output").sublist("Levels").sublist("C").set("height", 60.0);
  list.sublist("Checks")
      .sublist("other")
      .set("quantity", std::string("compression class at level C"))
      .set("standard", std::string("ENV 12718"))
      .set("class", std::string("A"));
  const auto scene = build(list);
  ASSERT_EQ(scene->checks().size(), 2u);
  const Check &b = scene->checks()[0], &c = scene->checks()[1];
  EXPECT_EQ(b.sections, std::vector<std::string>{"B"});
  EXPECT_EQ(limits_text(*b.compression), "RAL-GZ 387 class II, 23 to 32 mmHg");
  EXPECT_EQ(c.sections, std::vector<std::string>{"C"});
  EXPECT_EQ(limits_text(*c.compression), "ENV 12718 class A, 10 to 14 mmHg");
}

// Names that are nearly right are told the right one; bounds beside a class, and a class beside bounds, are refused.
TEST(CompressionClass, WrongNamesAreRefused) {
  ParameterList level = with_class("compression class at level BB");
  EXPECT_THAT(input_error(level), HasSubstr("no level is named \"BB\"; did you mean \"B\"?"));
  ParameterList quantity = with_class("compresion class");
  EXPECT_THAT(input_error(quantity), HasSubstr("did you mean \"compression class\"?"));
  ParameterList name = with_class("compression class");
  name.sublist("Checks").sublist("class").set("class", std::string("IIII"));
  EXPECT_THAT(input_error(name),
              HasSubstr("scene > Checks > class: parameter \"class\" = \"IIII\": no class of RAL-GZ 387 is named "
                        "\"IIII\"; did you mean \"III\"? Valid here: I, II, III, IV"));
  ParameterList standard = with_class("compression class");
  standard.sublist("Checks").sublist("class").set("standard", std::string("RAL-GZ 378"));
  EXPECT_THAT(input_error(standard), HasSubstr("did you mean \"RAL-GZ 387\"?"));
  ParameterList bounds = with_class("compression class");
  bounds.sublist("Checks").sublist("class").set("lower", 20.0);
  EXPECT_THAT(input_error(bounds), HasSubstr("parameter \"lower\" = 20: does not go with the quantity"));
  ParameterList plain = with_class("largest gap");
  EXPECT_THAT(input_error(plain), HasSubstr("parameter \"class\" = \"II\": does not go with the quantity"));
}

}  // namespace
}  // namespace toile::scene::test
