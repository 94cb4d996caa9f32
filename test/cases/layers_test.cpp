// Panels that lie over each other: told by "over", or warned of.
#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

std::string over(const std::string& panels) {
  return parameter("over", "Array(string)", "{" + panels + "}");
}

class Layers : public ProgramTest {
 protected:
  /// input/benchmarks/layers.xml with other panels.
  Outcome run(const std::string& panels) const {
    write("scene.xml",
          list("scene", parameter("include", "Array(string)", "{" TOILE_SOURCE_DIR "/input/benchmarks/layers.xml}") +
                            list("Panels", panels)));
    return toile("run scene.xml --output out");
  }
};

// Layers that are told to lie over each other are not warned of, neither at the start nor at the end.
TEST_F(Layers, AreTold) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("over")));
}

// A layer that is not told is warned of, with the panels that it shares the skin with and what to write.
TEST_F(Layers, AreWarnedOfWithoutOver) {
  const Outcome outcome = run(list("layer 4", over("")));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("panels \"layer 3\" and \"layer 4\" lie over each other on 100 % of \"layer"));
  EXPECT_THAT(outcome.err, HasSubstr("its \"over\": \"layer 4\" names \"layer 3\", or \"layer 3\" names \"layer 4\""));
  EXPECT_THAT(outcome.err, Not(HasSubstr("panels \"layer 1\" and \"layer 3\"")));
}

// Layers none of which is told make one warning that names them all, at the start and at the end.
TEST_F(Layers, AreWarnedOfTogether) {
  const Outcome outcome = run(list("layer 2", over("")) + list("layer 3", over("")) + list("layer 4", over("")));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string all =
      "panels \"layer 1\", \"layer 2\", \"layer 3\" and \"layer 4\" lie over each other on up to 100 "
      "% of \"layer ";
  const std::size_t start = outcome.err.find(all), end = outcome.err.find(all, start + 1);
  ASSERT_NE(end, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("lie over each other", end + all.size()), std::string::npos) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the outer ones will press too little. Let each but the innermost name in its "
                                     "\"over\" the one beneath it"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("panels \"layer 1\" and")));
}

// Those that start over each other are warned of before anything is solved; those that start beside each other, or off
// the body, are not.
TEST_F(Layers, AreWarnedOfAtTheStart) {
  const auto said = [&](const std::string& panel) {
    write("scene.xml",
          list("scene", parameter("include", "Array(string)", "{" TOILE_SOURCE_DIR "/input/benchmarks/layers.xml}") +
                            list("Panels", list("layer 4", over("") + list("Placement", panel)))));
    return toile("check scene.xml").err;
  };
  EXPECT_THAT(said(""),
              HasSubstr("panels \"layer 3\" and \"layer 4\" lie over each other on 100 % of \"layer 4\" where "
                        "they start"));
  EXPECT_THAT(said(parameter("from", "double", "60") + parameter("to", "double", "96")), Not(HasSubstr("over each")));
  EXPECT_THAT(said(parameter("offset", "double", "6")), Not(HasSubstr("over each")));
}

// A layer that reaches far beyond what it lies over is warned of, with the part that lies on it.
TEST_F(Layers, AreWarnedOfBesideWhatTheyLieOver) {
  const Outcome outcome =
      run(list("layer 4", parameter("height", "double", "80") + list("Placement", parameter("to", "double", "72"))));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(
      outcome.err,
      HasSubstr("panel \"layer 4\" lies over what its \"over\" names on only 50 % of the area where it presses"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("lie over each other")));
}

// A panel that names one that is none, or that would lie over itself, or a scene without a body is refused.
TEST_F(Layers, AreRefused) {
  const auto refused = [&](const std::string& panels, const std::string& message) {
    const Outcome outcome = run(panels);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr(message));
  };
  refused(list("layer 2", over("layer1")), "found \"layer1\", which is no panel; did you mean \"layer 1\"?");
  refused(list("layer 1", over("layer 4")), "the panel would lie over itself");
  const std::string panels = R"(<ParameterList name="Panels">)";
  const std::string flag =
      list("flag", parameter("material", "string", "fabric") + parameter("shape", "string", "rectangle") +
                       parameter("width", "double", "50") + parameter("height", "double", "50") + over("strip") +
                       parameter("elements across", "int", "4") + parameter("elements along", "int", "4"));
  write_scene("strip", {{panels, panels + flag}});
  const Outcome outcome = toile("check scene.xml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is for panels on a body, and the scene has no list \"Body\""));
}

}  // namespace
}  // namespace toile::test
