#include "compression_fault.hpp"

#include <gmock/gmock.h>

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const scene::CompressionClass ii{"RAL-GZ 387", "II", 23.0, 32.0};

/// What the check of class II at B says of a level B of this pressure and error, mmHg.
std::string fault(double pressure, double error) {
  constexpr double mpa = 133.3224e-6;  // of a mmHg
  run::PressureReport report;
  report.levels.emplace_back();
  report.levels[0].name = "B";
  report.levels[0].panels = "stocking";
  report.levels[0].pressure_mean = pressure * mpa;
  report.levels[0].pressure_error = error * mpa;
  scene::Check check{"class", "compression class", 0.0, 0.0, {"B"}, ii};
  return run::compression_fault(check, report);
}

// Pass, fail and not decided are three outcomes, the last with what would decide it.
TEST(CompressionFault, TellsItsThreeOutcomes) {
  EXPECT_EQ(fault(27.0, 3.0), "");
  EXPECT_EQ(fault(22.0, 0.5),
            "check \"class\" does not hold: pressure at level B is 22 +- 0.5 mmHg (between I and II), asked for is "
            "RAL-GZ 387 class II, 23 to 32 mmHg");
  EXPECT_THAT(
      fault(23.4, 0.5),
      AllOf(HasSubstr("check \"class\" is not decided within the error: pressure at level B is 23.4 +- 0.5 mmHg "
                      "(II), asked for is RAL-GZ 387 class II, 23 to 32 mmHg; the error bar crosses 23 mmHg"),
            HasSubstr("falls by 0.1 mmHg to below 0.4 mmHg"), HasSubstr("rises by 0.1 mmHg")));
}

// A level that the garment does not reach, or that has several sections, has no class.
TEST(CompressionFault, NeedsOneSection) {
  run::PressureReport report;
  report.levels.resize(2);
  for (const size_t k : {0, 1}) {
    report.levels[k].name = "B";
    report.levels[k].section = std::to_string(k + 1);
  }
  scene::Check check{"class", "compression class", 0.0, 0.0, {"B"}, ii};
  EXPECT_THAT(run::compression_fault(check, report), HasSubstr("has the sections B (1), B (2); name one of them"));
  check.sections = {"B (2)"};
  EXPECT_THAT(run::compression_fault(check, report), HasSubstr("the garment does not reach level B (2)"));
}

}  // namespace
}  // namespace toile::test
