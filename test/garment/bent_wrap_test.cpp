// Panels round the axis of a bent limb.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lists.hpp"
#include "surfaces.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;
using test::input_error;
using test::reals;
using ::testing::HasSubstr;

constexpr double tube = 40.0, bend = 80.0;  // radii, mm

/// A knee of constant radius in the y-z plane: a shin up the z axis to z = 0, a quarter of a ring about (0, bend, 0),
/// and a thigh along y at z = bend.
class Knee : public test::AnalyticSurface {
 public:
  body::SurfacePoint closest(const body::Vec3& p) const override {
    body::Vec3 middle(0.0, 0.0, p.z());
    if (p.z() > 0.0 && p.y() >= bend) {
      middle = {0.0, p.y(), bend};
    } else if (p.z() > 0.0) {
      const Vec3 from(0.0, p.y() - bend, p.z());
      middle = Vec3(0.0, bend, 0.0) + bend * from.normalized();
    }
    body::SurfacePoint result;
    result.normal = (p - middle).normalized();
    result.gap = (p - middle).norm() - tube;
    result.closest = p - result.gap * result.normal;
    result.found = true;
    return result;
  }
};

/// Two legs along z that touch: cylinders about y = 0 and y = 70 mm.
class TwoLegs : public test::AnalyticSurface {
 public:
  body::SurfacePoint closest(const body::Vec3& p) const override {
    const body::Vec3 first(p.x(), p.y(), 0.0), second(p.x(), p.y() - 70.0, 0.0);
    const body::Vec3& near = first.norm() < second.norm() ? first : second;
    body::SurfacePoint result;
    result.normal = near.normalized();
    result.gap = near.norm() - tube;
    result.closest = p - result.gap * result.normal;
    result.found = near.norm() > 0.0;
    return result;
  }
};

/// A sleeve of full coverage round the knee, along an axis of points at every `degrees` of the bend.
Teuchos::ParameterList sleeve(double degrees) {
  std::vector<double> axis{0.0, 0.0, -100.0};
  for (double angle = 0.0; angle <= 90.0; angle += degrees)
    axis.insert(axis.end(),
                {0.0, bend * (1.0 - std::cos(angle * M_PI / 180.0)), bend * std::sin(angle * M_PI / 180.0)});
  axis.insert(axis.end(), {0.0, bend + 100.0, bend});
  Teuchos::ParameterList panels;
  Teuchos::ParameterList& placement = test::add_rectangle(panels, "sleeve", 250.0, 230.0, 48, 46).sublist("Placement");
  placement.set("type", std::string("wrap"));
  placement.set("axis", Teuchos::Array<double>(axis));
  placement.set("from", 50.0).set("to", 280.0);
  placement.set("zero direction", reals({0.0, -1.0, 0.0}));
  placement.set("coverage", 1.0).set("offset", 0.3);
  return panels;
}

Teuchos::ParameterList& placement_of(Teuchos::ParameterList& panels) {
  return panels.sublist("sleeve").sublist("Placement");
}

mesh::Mesh build(const Teuchos::ParameterList& panels, const body::Surface* body) {
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), nullptr, body).mesh;
}

std::string refusal(const Teuchos::ParameterList& panels) {
  const Knee knee;
  return input_error([&] { build(panels, &knee); });
}

int node(int i, int j) {
  return 49 * j + i;
}

/// Length of a column of nodes, mm.
double column_length(const mesh::Mesh& mesh, int i, int from, int to) {
  double length = 0.0;
  for (int j = from; j < to; ++j) length += (mesh.placed[node(i, j + 1)] - mesh.placed[node(i, j)]).norm();
  return length;
}

// One panel follows a knee of 90 degrees: every node lies at its offset from the body with the right side outwards,
// every row closes with the girth of the limb in even steps, and the outer side is longer than the inner one by the
// angle of the bend times the limb's width.
TEST(BentWrap, FollowsAKneeOfConstantRadius) {
  const Knee knee;
  const mesh::Mesh mesh = build(sleeve(15.0), &knee);
  for (int n = 0; n < mesh.nodes(); ++n) {
    EXPECT_NEAR(knee.closest(mesh.placed[n]).gap, 0.3, 4e-6);
    EXPECT_NEAR((mesh.normal[n] - knee.closest(mesh.placed[n]).normal).norm(), 0.0, 1e-12);
  }
  const double chord = 2.0 * (tube + 0.3) * std::sin(M_PI / 48);
  for (int j = 0; j <= 46; ++j) {
    EXPECT_NEAR((mesh.placed[node(0, j)] - mesh.placed[node(48, j)]).norm(), 0.0, 1e-9);
    for (int i = 0; i < 48; ++i)
      EXPECT_NEAR((mesh.placed[node(i + 1, j)] - mesh.placed[node(i, j)]).norm(), chord, 3e-3 * chord) << i << " " << j;
  }
  const double outer = column_length(mesh, 24, 0, 46), inner = column_length(mesh, 0, 0, 46);
  EXPECT_NEAR(outer - inner, 0.5 * M_PI * 2.0 * (tube + 0.3), 0.4);
}

// The axis of each node, along which supports may hold, is the tangent of the axis at its height.
TEST(BentWrap, KnowsTheDirectionOfItsAxis) {
  const Knee knee;
  const mesh::Mesh mesh = build(sleeve(15.0), &knee);
  EXPECT_NEAR((mesh.axis[node(7, 0)] - Vec3::UnitZ()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((mesh.axis[node(7, 46)] - Vec3::UnitY()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((mesh.axis[node(7, 23)] - Vec3(0, std::sin(65.0 / bend), std::cos(65.0 / bend))).norm(), 0.0, 0.03);
}

// Three points are enough if the corner is spread: the axis then cuts it, and the sections stay apart.
TEST(BentWrap, ThreePointsAreEnough) {
  const Knee knee;
  Teuchos::ParameterList panels = sleeve(15.0);
  placement_of(panels).set("axis", reals({0, 0, -90, 0, 0, 80, 0, 170, 80}));
  placement_of(panels).set("from", 50.0).set("to", 270.0).set("smoothing", 90.0);
  const mesh::Mesh mesh = build(panels, &knee);
  for (int n = 0; n < mesh.nodes(); ++n) EXPECT_NEAR(knee.closest(mesh.placed[n]).gap, 0.3, 4e-6);
  for (int j = 0; j < 46; ++j)
    EXPECT_GT((mesh.placed[node(0, j + 1)] - mesh.placed[node(0, j)]).dot(mesh.axis[node(0, j)]), 0.5) << j;
}

// Where sections cross at the inner side of a bend, the message says so with the two lengths that tell why.
TEST(BentWrap, CrossingSectionsAreRefused) {
  Teuchos::ParameterList panels = sleeve(15.0);
  placement_of(panels)
      .set("axis", reals({0, 0, -100, 0, 0, 20, 0, 23, 57, 0, 60, 80, 0, 180, 80}))
      .set("smoothing", 8.0);
  EXPECT_THAT(refusal(panels), ::testing::AllOf(HasSubstr("parameter \"axis\""), HasSubstr("cross near ("),
                                                HasSubstr("the axis turns there with a radius of"),
                                                HasSubstr("a larger \"smoothing\"")));
}

// An axis that leaves the limb, or from which a section folds behind itself, is refused with the height.
TEST(BentWrap, AnAxisThatDoesNotSeeTheWholeSectionIsRefused) {
  Teuchos::ParameterList outside = sleeve(15.0);
  placement_of(outside).set("axis", reals({0, 0, -100, 100, 0, -100}));
  EXPECT_THAT(refusal(outside), HasSubstr("the axis is not inside the body at the height 50 mm above the first point "
                                          "of \"axis\", along it,"));
  const TwoLegs legs;
  Teuchos::ParameterList panels = sleeve(15.0);
  placement_of(panels).set("axis", reals({0, 0, 0, 0, 0, 300}));
  EXPECT_THAT(input_error([&] { build(panels, &legs); }),
              HasSubstr("folds behind itself where the panel lies (its radius jumps from "));
  // A narrow panel on the side that the axis does see is placed.
  placement_of(panels).set("coverage", 0.3);
  EXPECT_EQ(build(panels, &legs).nodes(), 49 * 47);
}

// A bent axis goes instead of a straight one, needs whole points, and its corners are what "smoothing" is for.
TEST(BentWrap, ItsParametersAreChecked) {
  const auto message = [](const std::function<void(Teuchos::ParameterList&)>& spoil) {
    Teuchos::ParameterList panels = sleeve(15.0);
    spoil(placement_of(panels));
    return refusal(panels);
  };
  using List = Teuchos::ParameterList;
  EXPECT_THAT(message([](List& list) {
                list.set("axis top", reals({0, 0, 1}));
              }),
              HasSubstr("goes with a straight axis; give it or \"axis\", not both"));
  EXPECT_THAT(message([](List& list) {
                list.set("axis", reals({0, 0, 1, 0, 0}));
              }),
              HasSubstr("has 5 numbers; allowed are points x, y, z, x, y, z, ..., at least two of them"));
  EXPECT_THAT(message([](List& list) {
                list.set("axis", reals({0, 0, 1, 0, 0, 1}));
              }),
              HasSubstr("repeats its point number 1"));
  EXPECT_THAT(message([](List& list) { list.remove("axis"); }),
              HasSubstr("a straight axis needs \"axis bottom\" and \"axis top\"; that of a bent limb is given by its "
                        "points in \"axis\""));
  EXPECT_THAT(message([](List& list) {
                list.remove("axis");
                list.set("axis bottom", reals({0, 0, 0})).set("axis top", reals({0, 0, 1})).set("smoothing", 5.0);
              }),
              HasSubstr("rounds the corners of \"axis\", which is not given"));
}

// A free wrap round a bent axis makes a piece of a ring: every node at the radius from the axis, normals across the
// surface.
TEST(BentWrap, FreeWrapMakesARing) {
  Teuchos::ParameterList panels = sleeve(3.0);
  Teuchos::ParameterList& placement = placement_of(panels);
  placement.set("type", std::string("free wrap")).set("around", reals({tube, tube}));
  placement.remove("offset");
  const Knee knee;
  const mesh::Mesh mesh = build(panels, nullptr);
  // The moving average over a side of the polygon cuts each of its corners by this.
  const double half_corner = 0.5 * 3.0 * M_PI / 180.0, cut = bend * std::pow(std::sin(half_corner), 2);
  for (int n = 0; n < mesh.nodes(); ++n) {
    EXPECT_NEAR(knee.closest(mesh.placed[n]).gap, 0.0, 1.01 * cut);
    EXPECT_NEAR((mesh.normal[n] - knee.closest(mesh.placed[n]).normal).norm(), 0.0, 0.03);
  }
}

}  // namespace
}  // namespace toile::garment
