#include "toile/result/plot.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "support.hpp"
#include "toile/base/units.hpp"

namespace toile::result::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Plot example() {
  Plot plot;
  plot.title = "Pressure of the leg's stocking, from ankle to thigh";
  plot.x_label = "height above the floor (mm)";
  plot.y_label = "contact pressure (kPa)";
  plot.second_axis = SecondAxis{"contact pressure (mmHg)", base::mmhg_per_kpa};
  plot.y_from_zero = true;
  Series curve{"mean_pressure", {}, {}, true, false, {}};
  for (int i = 0; i <= 60; ++i) {
    curve.x.push_back(100.0 + 10.0 * i);
    curve.y.push_back(0.35 + 0.55 * std::exp(-0.05 * i));
  }
  curve.y[30] = std::nan("");
  plot.series.push_back(curve);
  plot.series.push_back({"hosiery levels", {120, 400, 650}, {0.85, 0.5, 0.38}, false, true, {"B", "C", "G"}});
  return plot;
}

/// Sets an environment variable for one test.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name), before_(std::getenv(name)) {
    setenv(name, value.c_str(), 1);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { setenv(name_, before_.c_str(), 1); }

 private:
  const char* name_;
  std::string before_;
};

/// A folder with a program named gnuplot that ends with the given status.
void fake_gnuplot(const TemporaryFolder& folder, const std::string& commands) {
  std::ofstream(folder.file("gnuplot")) << "#!/bin/sh\n" << commands << '\n';
  std::filesystem::permissions(folder.file("gnuplot"), std::filesystem::perms::owner_all);
}

// A class of points keeps its colour whatever other classes a plot has, and a legend may stand above.
TEST(Plot, ColourAndLegendAreChosen) {
  const TemporaryFolder folder;
  Plot plot = example();
  write_plot(folder.path().string(), "plain", plot);
  plot.series[1].colour = 7;
  plot.legend_above = true;
  write_plot(folder.path().string(), "chosen", plot);
  EXPECT_THAT(read_text(folder.file("plain.gp")),
              AllOf(HasSubstr("set key noenhanced top right"), HasSubstr("linetype 2")));
  EXPECT_THAT(read_text(folder.file("chosen.gp")),
              AllOf(HasSubstr("set key noenhanced tmargin center horizontal"), HasSubstr("linetype 7")));
}

// Errors are a band about a line, and bars at markers, whose labels stay.
TEST(Plot, ErrorsAreBandsAndBars) {
  const TemporaryFolder folder;
  Plot plot = example();
  plot.series[0].errors.assign(61, 0.125);
  plot.series[1].errors = {0.25, 0.5, 0.0625};
  const auto warning = write_plot(folder.path().string(), "errors", plot);
  EXPECT_FALSE(warning) << *warning;
  const std::string data = read_text(folder.file("errors.dat"));
  EXPECT_THAT(data, AllOf(HasSubstr("\n100 0.9 0.125\n"), HasSubstr("\n400 0.5 0.5 \"C\"\n")));
  EXPECT_THAT(read_text(folder.file("errors.gp")),
              AllOf(HasSubstr("index 0 using 1:($2-$3):($2+$3) with filledcurves"),
                    HasSubstr("index 1 using 1:2:3 with yerrorbars"), HasSubstr("index 1 using 1:2:4 with labels")));
}

// The points and a script that draws SVG and PNG from them stay in the results, with all texts of the plot.
TEST(Plot, WritesDataAndScript) {
  const TemporaryFolder folder;
  write_plot(folder.path().string(), "pressure", example());
  const std::string data = read_text(folder.file("pressure.dat"));
  EXPECT_THAT(data, HasSubstr("\n100 0.9\n"));
  EXPECT_THAT(data, HasSubstr("\n\n\n# \"hosiery levels\"\n120 0.85 \"B\"\n400 0.5 \"C\"\n650 0.38 \"G\"\n"));
  EXPECT_THAT(data, ::testing::Not(HasSubstr("nan")));
  const std::string script = read_text(folder.file("pressure.gp"));
  EXPECT_THAT(script, HasSubstr("set title 'Pressure of the leg''s stocking, from ankle to thigh'"));
  EXPECT_THAT(script, HasSubstr("set link y2 via 7.50062*y inverse y/7.50062"));
  EXPECT_THAT(script, HasSubstr("set y2label 'contact pressure (mmHg)'"));
  EXPECT_THAT(script, HasSubstr("'pressure.dat' index 1 using 1:2 with points"));
  EXPECT_THAT(script, HasSubstr("set output 'pressure.svg'"));
  EXPECT_THAT(script, HasSubstr("set output 'pressure.png'"));
}

// gnuplot draws both pictures without a display, and the texts arrive in them as they are.
TEST(Plot, GnuplotDrawsPictures) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "gnuplot is not installed";
  }
  const TemporaryFolder folder;
  EXPECT_EQ(write_plot(folder.path().string(), "pressure", example()), std::nullopt);
  const std::string svg = read_text(folder.file("pressure.svg"));
  EXPECT_THAT(svg, HasSubstr("mean_pressure"));
  EXPECT_THAT(svg, HasSubstr("contact pressure (mmHg)"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_THAT(read_text(folder.file("pressure.png")).substr(1, 3), "PNG");
}

// A missing or failing gnuplot is a warning that says what to do; the run goes on.
TEST(Plot, WarnsWithoutGnuplot) {
  const TemporaryFolder folder;
  const TemporaryFolder programs;
  const Environment path("PATH", programs.path().string());
  const std::string hint = "; run 'gnuplot pressure.gp' in that folder to draw it";
  const std::string stem = folder.file("pressure");
  EXPECT_EQ(write_plot(folder.path().string(), "pressure", example()),
            "no picture of '" + stem + "': gnuplot was not found" + hint);
  EXPECT_TRUE(std::filesystem::exists(folder.file("pressure.dat")));
  fake_gnuplot(programs, "exit 1");
  EXPECT_EQ(write_plot(folder.path().string(), "pressure", example()),
            "no picture of '" + stem + "': gnuplot failed" + hint);
}

// A gnuplot that does not end is ended, with what it started, and told.
TEST(Plot, EndsAGnuplotThatHangs) {
  const TemporaryFolder folder;
  const TemporaryFolder programs;
  fake_gnuplot(programs, "sleep 1000 & wait");
  const Environment path("PATH", programs.path().string() + ":" + std::getenv("PATH"));
  EXPECT_EQ(write_plot(folder.path().string(), "pressure", example(), 0.25),
            "no picture of '" + folder.file("pressure") +
                "': gnuplot did not end in 0.25 s and was ended; run 'gnuplot pressure.gp' in that folder to draw it");
}

// A picture that gnuplot cut off, as on a full disk, without noticing is told and removed.
TEST(Plot, TellsAPictureThatWasCutOff) {
  const TemporaryFolder folder;
  const TemporaryFolder programs;
  const Environment path("PATH", programs.path().string());
  const std::string stem = folder.file("pressure");
  const std::string hint = "; the disk may be full; run 'gnuplot pressure.gp' in that folder to draw it";
  fake_gnuplot(programs, "echo '<svg>' > pressure.svg; : > pressure.png");
  EXPECT_EQ(write_plot(folder.path().string(), "pressure", example()),
            "no picture of '" + stem + "': gnuplot left '" + stem + ".svg' incomplete" + hint);
  EXPECT_FALSE(std::filesystem::exists(stem + ".svg"));
  fake_gnuplot(programs, "echo '<svg></svg>' > pressure.svg; : > pressure.png");
  EXPECT_EQ(write_plot(folder.path().string(), "pressure", example()),
            "no picture of '" + stem + "': gnuplot left '" + stem + ".png' incomplete" + hint);
  EXPECT_FALSE(std::filesystem::exists(stem + ".png"));
}

// A picture that is a link to another file takes its place; what it leads to is untouched.
TEST(Plot, FollowsNoLinks) {
  const TemporaryFolder folder;
  const TemporaryFolder programs;
  const Environment path("PATH", programs.path().string());
  fake_gnuplot(programs, "echo drawn > pressure.svg; echo drawn > pressure.png");
  std::ofstream(folder.file("victim")) << "precious";
  for (const char* ending : {"svg", "png", "dat", "gp"})
    std::filesystem::create_symlink(folder.file("victim"), folder.file(std::string("pressure.") + ending));
  write_plot(folder.path().string(), "pressure", example());
  EXPECT_EQ(read_text(folder.file("victim")), "precious");
}

// A folder that is not there is an error with path and reason.
TEST(Plot, ReportsAnUnwritableFolder) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing");
  EXPECT_EQ(input_error([&] { write_plot(missing, "pressure", example()); }),
            "cannot write the plot '" + missing + "/pressure.dat': No such file or directory");
}

}  // namespace
}  // namespace toile::result::test
