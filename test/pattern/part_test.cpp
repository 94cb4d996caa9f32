// Names of edges and of parts of them.
#include <gmock/gmock.h>

#include "panels.hpp"

namespace toile::pattern::test {
namespace {

using testing::HasSubstr;

Panel marked() {
  Panel panel = square();
  panel.notches = {{"notch1", "bottom", 0.3}, {"other", "top", 0.5}};
  return panel;
}

// A part is bounded by its ends, notches, relative lengths or lengths in mm.
TEST(Part, BoundsOfAllKinds) {
  const Panel panel = marked();
  const auto bounds = [&](const std::string& name) {
    const EdgePart part = find_part(panel, name);
    EXPECT_EQ(part.edge->name, "bottom");
    return std::make_pair(part.from, part.to);
  };
  EXPECT_EQ(bounds("bottom"), std::make_pair(0.0, 1.0));
  EXPECT_EQ(bounds("bottom[notch1:end]"), std::make_pair(0.3, 1.0));
  EXPECT_EQ(bounds("bottom[0.25:0.5]"), std::make_pair(0.25, 0.5));
  EXPECT_EQ(bounds("bottom[start:30mm]"), std::make_pair(0.0, 0.3));
}

// What is wrong with the name of a part is told, with what is valid.
TEST(Part, WrongNamesAreRefused) {
  const Panel panel = marked();
  const auto refusal = [&](const std::string& name) { return message([&] { find_part(panel, name); }); };
  EXPECT_THAT(refusal("botom[0:1]"), HasSubstr("panel \"square\" has no edge \"botom\""));
  EXPECT_THAT(refusal("bottom[0:1"), HasSubstr("part \"bottom[0:1\": the \"]\" at its end is missing"));
  EXPECT_THAT(refusal("bottom[0.5]"), HasSubstr("a part is written [from:to]"));
  EXPECT_THAT(refusal("bottom[notch:end]"), HasSubstr("the bound \"notch\" is no notch of this edge"));
  EXPECT_THAT(refusal("bottom[notch:end]"), HasSubstr("\"notch1\""));
  EXPECT_THAT(refusal("bottom[other:end]"), HasSubstr("the bound \"other\" is no notch of this edge"));
  EXPECT_THAT(refusal("bottom[0:3cm]"), HasSubstr("no length with its unit (30mm)"));
  EXPECT_THAT(refusal("bottom[0:1.5]"), HasSubstr("allowed are 0 to 1 (relative length)"));
  EXPECT_THAT(refusal("bottom[0:130mm]"), HasSubstr("allowed are 0 to 100 mm (its length)"));
  EXPECT_THAT(refusal("bottom[0.5:0.2]"), HasSubstr("a part must end after its start"));
  EXPECT_THAT(refusal("bottom[nan:1]"), HasSubstr("lies outside of the edge"));
}

// A side of a stitch names its panel, whose name may have a dot.
TEST(Part, SidesNameTheirPanel) {
  Pattern pattern{{marked(), marked()}, {}};
  pattern.panels[1].name = "square.left";
  EXPECT_EQ(find_side(pattern, "square.left").panel, &pattern.panels[0]);
  EXPECT_EQ(find_side(pattern, "square.left.bottom[0:0.5]").panel, &pattern.panels[1]);
  EXPECT_THAT(message([&] { find_side(pattern, "sqare.left"); }), HasSubstr("there is no panel \"sqare\""));
  EXPECT_THAT(message([&] { find_side(pattern, "square"); }), HasSubstr("write \"panel.edge\""));
}

}  // namespace
}  // namespace toile::pattern::test
