#include "crossed_planes.hpp"

#include <gmock/gmock.h>

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Quarter of a sheet, 2 x 2 elements of 10 mm, held in its plane of symmetry x = 0.
struct Quarter {
  mesh::Mesh mesh;
  solve::Support support;

  Quarter() {
    mesh.blocks.emplace_back();
    mesh.blocks[0].nodes_per_element = 4;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) mesh.placed.emplace_back(10.0 * i, 10.0 * j, 0.0);
    mesh.pattern.resize(mesh.placed.size());
    for (const int n : {0, 1, 3, 4}) {
      const std::vector<int> element{n, n + 1, n + 4, n + 3};
      mesh.blocks[0].connectivity.insert(mesh.blocks[0].connectivity.end(), element.begin(), element.end());
    }
    support.name = "middle";
    support.nodes = {0, 3, 6};
    support.held = {true, false, false};
  }
};

// A node that has come out on the other side of the plane is told with how far, where and what it means.
TEST(CrossedPlane, IsTold) {
  const Quarter quarter;
  std::vector<solve::Vec3> position = quarter.mesh.placed;
  EXPECT_THAT(run::crossed_plane(quarter.support, quarter.mesh, position), IsEmpty());
  position[4] = {-2.5, 11.0, 3.0};
  EXPECT_THAT(run::crossed_plane(quarter.support, quarter.mesh, position),
              AllOf(HasSubstr("\"middle\", by 2.5 mm at (-2.5, 11, 3) mm"), HasSubstr("mirror image")));
}

// A plane that moves, one of several directions that are held, and an edge that is not in a plane are no symmetry.
TEST(CrossedPlane, IsOneOfSymmetry) {
  std::vector<solve::Vec3> position = Quarter().mesh.placed;
  position[4][0] = -2.5;
  Quarter moved, clamped, bent;
  moved.support.displacement[0] = -20.0;
  clamped.support.held = {true, true, true};
  bent.mesh.placed[3][0] = 1.0;
  for (const Quarter* other : {&moved, &clamped, &bent})
    EXPECT_THAT(run::crossed_plane(other->support, other->mesh, position), IsEmpty());
}

// A sheet that lies in the plane from the beginning may bulge to each of its sides.
TEST(CrossedPlane, MayRunThroughTheFabric) {
  Quarter flat;
  flat.support.held = {false, false, true};
  std::vector<solve::Vec3> position = flat.mesh.placed;
  for (const double bulge : {-2.5, 2.5}) {
    position[4][2] = bulge;
    EXPECT_THAT(run::crossed_plane(flat.support, flat.mesh, position), IsEmpty()) << bulge;
  }
}

}  // namespace
}  // namespace toile::test
