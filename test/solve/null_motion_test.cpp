// Rigid motions that nothing resists: which they are, what they are called, and that the pins hold them all.
#include "equilibrium/null_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "simulation/notes.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using solve::Held;
using solve::NullMotion;

Held nothing_held(const Sleeve& sleeve) {
  Held held;
  held.position.resize(sleeve.problem.clusters.size());
  return held;
}

/// The motions of a closed sleeve that the body guides.
std::vector<NullMotion> motions_of(const Sleeve& sleeve, const Held& held, bool guided = true) {
  return find_null_motions(sleeve.problem, placed_state(sleeve.problem), held, true,
                           std::vector<bool>(held.position.size(), guided));
}

bool is_named(const std::vector<NullMotion>& motions, const std::string& beginning) {
  for (const NullMotion& m : motions)
    if (m.name.rfind(beginning, 0) == 0) return true;
  return false;
}

/// Determinant of the pinned components under unit translations and rotations (over the sleeve's size) about z, x, y.
double independence(const Sleeve& sleeve, const std::vector<NullMotion>& motions) {
  Eigen::MatrixXd pinned(motions.size(), 6);
  for (size_t k = 0; k < motions.size(); ++k) {
    const solve::Vec3 a = sleeve.mesh.placed[sleeve.problem.clusters[motions[k].cluster].front()] / 60.0;
    Eigen::Matrix<double, 3, 6> g;
    g << 1, 0, 0, 0, a[2], -a[1], 0, 1, 0, -a[2], 0, a[0], 0, 0, 1, a[1], -a[0], 0;
    pinned.row(static_cast<Eigen::Index>(k)) = g.row(motions[k].component);
  }
  return std::sqrt((pinned * pinned.transpose()).determinant());
}

// A stage that ends with other pins than it started with keeps its other notes, and those of the stages before.
TEST(Notes, PinsAreExchangedAndNothingElse) {
  solve::Notes notes;
  notes.set_pins({"first stage's pin"});
  notes.add("first stage's limit point");
  notes.start_stage();
  notes.set_pins({"a", "b", "c"});
  notes.add("limit point");
  notes.set_pins({"d"});
  notes.add("bifurcation");
  EXPECT_EQ(notes.all(), (std::vector<std::string>{"first stage's pin", "first stage's limit point", "d", "limit point",
                                                   "bifurcation"}));
}

// A sleeve without supports slides along the cylinder and spins on it: two motions with two names, and two pins that
// are not the same.
TEST(NullMotion, SlipAndSpinAreToldApart) {
  const Sleeve sleeve(options(12, 6), neo_hookean());
  const std::vector<NullMotion> motions = motions_of(sleeve, nothing_held(sleeve));
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_TRUE(is_named(motions, "translation along (0, 0, 1)")) << motions[0].name << "; " << motions[1].name;
  EXPECT_TRUE(is_named(motions, "rotation about the axis (0, 0, 1)")) << motions[0].name << "; " << motions[1].name;
  EXPECT_GT(independence(sleeve, motions), 0.1);
}

// A garment that nothing holds has the three translations along the axes and three rotations, and its six pins are
// independent.
TEST(NullMotion, SixOfAFreeGarment) {
  const Sleeve sleeve(options(12, 6), neo_hookean());
  const std::vector<NullMotion> motions = motions_of(sleeve, nothing_held(sleeve), false);
  ASSERT_EQ(motions.size(), 6u);
  for (const char* axis : {"(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)"}) {
    EXPECT_TRUE(is_named(motions, std::string("translation along ") + axis)) << axis;
    EXPECT_TRUE(is_named(motions, std::string("rotation about the axis ") + axis)) << axis;
  }
  EXPECT_GT(independence(sleeve, motions), 0.1);
}

// A motion that turns and advances at once is a screw, and is called so with its pitch.
TEST(NullMotion, ScrewIsNamed) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  // The guide of a thread: normals that lean against the spin by one in ten.
  struct Thread : Cylinder {
    using Cylinder::Cylinder;
    body::SurfacePoint closest(const body::Vec3& p) const override {
      body::SurfacePoint s = Cylinder::closest(p);
      const body::Vec3 around(-s.normal[1], s.normal[0], 0.0);
      if (p[0] > 0.0) s.normal = (s.normal + 0.1 * around - body::Vec3(0.0, 0.0, 0.5)).normalized();
      return s;
    }
  };
  const Thread thread(60.0);
  sleeve.problem.surface = &thread;
  const std::vector<NullMotion> motions = motions_of(sleeve, nothing_held(sleeve));
  ASSERT_EQ(motions.size(), 1u);
  // 0.1 r = 0.5 times the advance per radian: 2 pi 12 mm.
  EXPECT_TRUE(is_named(motions, "screw of 75.4 mm per turn about the axis (0, 0, 1)")) << motions[0].name;
}

// Two sleeves that are not sewn together spin each by itself.
TEST(NullMotion, EveryPartMovesByItself) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.add_copy(150.0);
  Held held = nothing_held(sleeve);
  for (const solve::Support& support : sleeve.problem.supports)
    for (size_t c = 0; c < held.position.size(); ++c)
      for (const int n : support.nodes)
        if (sleeve.problem.clusters[c].front() == n) held.position[c][2].held = true;
  const std::vector<NullMotion> motions = motions_of(sleeve, held);
  ASSERT_EQ(motions.size(), 2u);
  for (const NullMotion& m : motions) EXPECT_EQ(m.name.rfind("rotation about the axis (0, 0, 1)", 0), 0u) << m.name;
  const int half = static_cast<int>(held.position.size()) / 2;
  EXPECT_NE(motions[0].cluster < half, motions[1].cluster < half);
}

}  // namespace
}  // namespace toile::test
