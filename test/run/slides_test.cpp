#include "slides.hpp"

#include <gmock/gmock.h>

#include "toile/body/surface.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Anything : public body::Surface {
 public:
  body::SurfacePoint closest(const body::Vec3&) const override { return {}; }
  double range() const override { return 0.0; }
  body::TriangleMesh triangles(double) const override { return {}; }
  std::string summary() const override { return {}; }
};

/// Two elements of 40 mm that no seam connects, each a panel.
struct TwoPanels {
  mesh::Mesh mesh;
  Anything body;
  solve::Problem problem;

  TwoPanels() {
    for (const int panel : {0, 1}) {
      mesh.blocks.emplace_back();
      mesh.blocks.back().panel = panel;
      mesh.panels.push_back({panel == 0 ? "left" : "right", 4 * panel, 4, 1, {}});
      for (const auto& [x, z] : {std::pair{0.0, 0.0}, {40.0, 0.0}, {40.0, 40.0}, {0.0, 40.0}}) {
        mesh.blocks.back().connectivity.push_back(static_cast<int>(mesh.placed.size()));
        problem.clusters.push_back({static_cast<int>(mesh.placed.size())});
        mesh.placed.emplace_back(x + 100.0 * panel, 0.0, z);
      }
    }
    mesh.pattern.resize(mesh.placed.size());
    problem.mesh = &mesh;
    problem.surface = &body;
  }
  /// The right panel has gone down by so much.
  std::vector<std::string> after(double way) const {
    std::vector<solve::Vec3> position = mesh.placed;
    for (std::size_t n = 4; n < 8; ++n) position[n].z() -= way;
    return run::parts_that_slid(problem, position);
  }
};

// A part that has left its place is named with how far and whereto; one that shifted a little is not.
TEST(Slides, ArePartsThatLeftTheirPlace) {
  const TwoPanels garment;
  EXPECT_THAT(garment.after(35.0), ElementsAre(AllOf(StartsWith("panel \"right\" went 35 mm as a whole"),
                                                     HasSubstr("in the direction (0, 0, -1)"))));
  EXPECT_THAT(garment.after(20.0), IsEmpty());
}

// What a support moves has not slid.
TEST(Slides, AreNotMovedBySupports) {
  TwoPanels garment;
  garment.problem.supports.push_back({"pull", {4}, {true, true, true}, {0.0, 0.0, -35.0}});
  EXPECT_THAT(garment.after(35.0), IsEmpty());
}

}  // namespace
}  // namespace toile::test
