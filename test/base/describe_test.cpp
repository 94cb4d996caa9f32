#include <gmock/gmock.h>

#include "scene.hpp"

namespace toile::base::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The text form shows every list in full: path, whether it is required, and each parameter with its facts.
TEST(DescribeText, ShowsEverything) {
  Spec box("box", "A box.");
  box.real("width", "mm", "Width.", required, Range::positive());
  Spec panel("panel", "One piece.");
  panel.variant("shape", "Kind of outline.", {box});
  Spec panels("Panels", "The pieces.");
  panels.entries(panel, 2);
  Spec scene("scene", "A scene.");
  scene.flag("sewn", "Is it sewn?", true).list(panels, true);
  EXPECT_EQ(describe_text(scene),
            "scene\n"
            "  A scene.\n"
            "  sewn  [bool; default: true]\n"
            "      Is it sewn?\n"
            "\n"
            "scene > Panels\n"
            "  The pieces. Required.\n"
            "\n"
            "scene > Panels > <panel>\n"
            "  One piece. At least 2 lists with names of your choice.\n"
            "  shape  [string; allowed: box; required]\n"
            "      Kind of outline.\n"
            "\n"
            "scene > Panels > <panel>, shape = \"box\"\n"
            "  A box. In addition, if shape = \"box\".\n"
            "  width  [double; mm; allowed: > 0; required]\n"
            "      Width.\n"
            "\n");
}

// Every parameter and list of a scene with all kinds of them occurs in both forms.
TEST(Describe, NamesEveryParameterAndList) {
  for (const std::string& text : {describe_text(scene_spec()), describe_markdown(scene_spec())}) {
    for (const char* name : {"elements", "share", "sewn", "fabric", "grain", "levels", "edges", "stiffness", "shape",
                             "width", "radius", "Rim", "height", "Output", "file"}) {
      EXPECT_THAT(text, HasSubstr(name));
    }
  }
}

// The Markdown form has one table row a parameter, with name, type, unit, allowed values, default and meaning.
TEST(DescribeMarkdown, HasOneRowAParameter) {
  const std::string text = describe_markdown(scene_spec());
  EXPECT_THAT(text,
              HasSubstr("## `scene > Panels > <panel>`\n\nOne piece of fabric. At least 1 list with names of your "
                        "choice.\n\n| name | type | unit | allowed | default | meaning |\n"
                        "| --- | --- | --- | --- | --- | --- |\n"
                        "| elements | int |  | >= 1 | required | Number of elements. |\n"
                        "| share | double |  | 0 <= value <= 1 | 0.5 | Share of wool. |\n"));
  EXPECT_THAT(text, HasSubstr("| grain | string |  | wale, course | \"wale\" | Direction of the yarn. |\n"));
  EXPECT_THAT(text, HasSubstr("| stiffness | double or table | MPa | > 0 | 2 | Stiffness. |\n"));
  EXPECT_THAT(text, HasSubstr("## `scene > Panels > <panel>, shape = \"disk\" > Rim`\n"));
}

// A bar in a text does not break the table.
TEST(DescribeMarkdown, EscapesBars) {
  Spec scene("scene", "");
  scene.flag("sewn", "either | or", false);
  EXPECT_THAT(describe_markdown(scene), HasSubstr("either \\| or"));
}

// Tables are explained where a parameter may be one, and only there.
TEST(Describe, ExplainsTables) {
  EXPECT_THAT(describe_text(scene_spec()), HasSubstr("\"position\""));
  EXPECT_THAT(describe_text(Spec("scene", "A scene.")), Not(HasSubstr("\"position\"")));
}

// A parameter whose default depends on others is shown without one.
TEST(Describe, ShowsMissingDefaults) {
  Spec scene("scene", "");
  scene.real("C10", "MPa", "Stiffness.", std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(describe_text(scene), HasSubstr("C10  [double; MPa; no default]"));
  EXPECT_THAT(describe_markdown(scene), HasSubstr("| C10 | double | MPa |  | none | Stiffness. |"));
}

// A bound that is infinite by default is shown in words.
TEST(Describe, ShowsInfiniteDefaultsAsUnbounded) {
  Spec scene("scene", "");
  scene.real("top", "mm", "Highest z.", std::numeric_limits<double>::infinity());
  EXPECT_THAT(describe_text(scene), HasSubstr("top  [double; mm; default: unbounded]"));
}

}  // namespace
}  // namespace toile::base::test
