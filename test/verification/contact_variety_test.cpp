// What the seven meshes on smooth bodies do not show: lift-off, wrinkles, fitted bodies, shells, two fabrics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "body/meshes.hpp"
#include "toile/body/level_set.hpp"
#include "toile/run/session.hpp"
#include "verification/pattern_sleeve.hpp"
#include "verification/print.hpp"

namespace toile::test {
namespace {

/// Root mean square and largest error in a part of the nodes, over the root mean square of the exact pressure there.
struct PartError {
  double squares = 0.0, exact = 0.0, area = 0.0, worst = 0.0;
  void add(double a, double pressure, double value) {
    squares += a * (pressure - value) * (pressure - value);
    exact += a * value * value;
    area += a;
    worst = std::max(worst, std::abs(pressure - value));
  }
  double rms() const { return std::sqrt(squares / exact); }
  double largest() const { return worst / std::sqrt(exact / area); }
};

PatternMesh mesh_of(const std::string& kind, const ContactReference& reference, double size) {
  return pattern_mesh(kind, pattern_width(reference), pattern_height(reference), size);
}

/// Errors of all nodes for which `counts` holds.
template <class Counts, class Exact>
PartError errors_where(const PatternSleeve& sleeve, const Counts& counts, const Exact& exact) {
  PartError error;
  const solve::Fields& f = sleeve.fields;
  for (size_t n = 0; n < f.pressure.size(); ++n)
    if (counts(n)) error.add(f.area[n], f.pressure[n], exact(n));
  return error;
}

class LiftOff : public testing::TestWithParam<const char*> {};

// A sleeve that bridges a waist has on free meshes the pressure of the reference within 0.15 % away from the line where
// it lifts off, within 6 % (root mean square) beside it, and a sum within 0.6 % of the contact forces.
TEST_P(LiftOff, HasThePressureOfTheReferenceOnFreeMeshes) {
  const ContactReference reference("contact_waist_nh");
  constexpr double size = 4.0;
  PatternSleeve sleeve(reference, mesh_of(GetParam(), reference, size));
  sleeve.settle();
  const double line = reference.header("z_d"), end = reference.header("z");
  const auto z = [&](size_t n) { return sleeve.fields.position[n].z(); };
  const auto exact = [&](size_t n) { return sleeve.exact(n); };
  const double near = 2.0 * 1.35 * size;
  const PartError away = errors_where(
      sleeve, [&](size_t n) { return z(n) > line + near && z(n) < end - near; }, exact);
  const PartError beside = errors_where(
      sleeve, [&](size_t n) { return std::abs(z(n) - line) <= near; }, exact);
  const double scale = std::sqrt(away.exact / away.area), close = std::sqrt(beside.squares / beside.area) / scale;
  double force = 0.0, sum = 0.0;
  for (size_t n = 0; n < sleeve.fields.pressure.size(); ++n) {
    if (z(n) < line - near) {
      EXPECT_EQ(sleeve.fields.pressure[n], 0.0);
    }
    if (z(n) > end - 1e-6) continue;  // its support takes what it presses
    force += sleeve.fields.contact_force[n];
    sum += sleeve.fields.pressure[n] * sleeve.fields.area[n];
  }
  print(
      "waist, %-15s  away from lift-off: rms %.3f %%, largest %.2f %%; beside it: rms %.2f %%; sum %+.2f %%; "
      "isolated %d\n",
      GetParam(), 100.0 * away.rms(), 100.0 * away.largest(), 100.0 * close, 100.0 * (sum / force - 1.0),
      sleeve.fields.isolated_contacts);
  EXPECT_LE(away.rms(), 0.0015);
  EXPECT_LE(close, 0.06);
  EXPECT_LE(std::abs(sum / force - 1.0), 0.006);
}

INSTANTIATE_TEST_SUITE_P(Contact, LiftOff, testing::Values("shifted", "triangles", "quadrilaterals"));

class Wrinkled : public testing::TestWithParam<const char*> {};

// A sleeve that is too long for its ends wrinkles across its axis; its hoops press as those of a sleeve with a free
// end.
TEST_P(Wrinkled, PressesWithItsTensionField) {
  const ContactReference reference("contact_cyl_free_nh");
  PatternOptions options;
  options.tension_field = true;
  constexpr double closer = 0.97;
  options.top = closer * reference.header("z_end");
  PatternSleeve sleeve(reference, mesh_of(GetParam(), reference, 4.0), options);
  sleeve.settle();
  const PartError error = errors_where(
      sleeve, [](size_t) { return true; }, [&](size_t) { return reference.at("z", 0.0, "p") / closer; });
  print("tension field, %-15s  rms %.3f %%, largest %.2f %%\n", GetParam(), 100.0 * error.rms(),
        100.0 * error.largest());
  EXPECT_LE(error.rms(), 0.005);
}

INSTANTIATE_TEST_SUITE_P(Contact, Wrinkled, testing::Values("aligned", "turned", "triangles"));

// On a body of unstructured triangles of 5 mm the pressure on free meshes is within 0.5 % (root mean square) of that
// on the ellipse from which they were made, and within 3 % at every node.
TEST(FittedBody, HasThePressureOfTheEllipse) {
  const ContactReference reference("contact_ellipse_free_nh");
  body::TriangleMesh triangles = random_triangulation(elliptic_tube(80.0, 50.0, 140.0), 5.0, 1);
  for (body::Vec3& v : triangles.vertices) v.z() -= 20.0;
  PatternOptions options;
  options.surface = body::level_set(triangles, {}, "ellipse");
  for (const char* kind : {"turned", "triangles", "quadrilaterals"}) {
    PatternSleeve sleeve(reference, mesh_of(kind, reference, 4.0), options);
    sleeve.settle();
    const PartError error = errors_where(
        sleeve, [](size_t) { return true; }, [&](size_t n) { return sleeve.exact(n); });
    print("triangles of 5 mm, %-15s  rms %.3f %%, largest %.2f %%\n", kind, 100.0 * error.rms(),
          100.0 * error.largest());
    EXPECT_LE(error.rms(), 0.005);
    EXPECT_LE(error.largest(), 0.03);
  }
}

// Shells on their inner face press like a plane-stress shell on meshes of any kind, away from the edge layers of their
// ends.
TEST(ShellOnItsInnerFace, HasItsPressureOnAnyMesh) {
  const ContactReference reference("contact_cyl_free_nh");
  constexpr double per_middle = 0.72967e-3;  // MPa, see shell_sleeve_test
  PatternOptions options;
  options.shell_c10 = 0.0382;
  for (const char* kind : {"aligned", "turned", "triangles"}) {
    PatternSleeve sleeve(reference, mesh_of(kind, reference, 4.0), options);
    sleeve.settle();
    const PartError error = errors_where(
        sleeve, [&](size_t n) { return sleeve.from_end(n) > 25.0; }, [&](size_t) { return per_middle; });
    print("shells, %-15s  rms %.3f %%, largest %.2f %%\n", kind, 100.0 * error.rms(), 100.0 * error.largest());
    EXPECT_LE(error.rms(), 0.005);
    EXPECT_LE(error.largest(), 0.006);
  }
}

/// A tube of neo-Hookean fabric on a cylinder of 60 mm, sewn to itself; free along the axis.
void add_tube(Teuchos::ParameterList& scene, const std::string& name, double c10, double from) {
  Teuchos::ParameterList& fabric = scene.sublist("Materials").sublist(name);
  fabric.set("type", "neo-hookean").set("C10", c10).set("thickness", 1.0);
  Teuchos::ParameterList& panel = scene.sublist("Panels").sublist(name);
  panel.set("material", name).set("shape", "rectangle").set("width", 2.0 * M_PI * 50.0).set("height", 40.0);
  panel.set("elements across", 48).set("elements along", 6).set("elements", "triangle");
  Teuchos::ParameterList& placement = panel.sublist("Placement");
  placement.set("type", "wrap").set("coverage", 1.0).set("from", from).set("to", from + 36.5);
  placement.set("axis bottom", Teuchos::Array<double>(std::vector<double>{0.0, 0.0, 0.0}));
  placement.set("axis top", Teuchos::Array<double>(std::vector<double>{0.0, 0.0, 1.0}));
  scene.sublist("Seams").sublist(name).set("first", name + ".right").set("second", name + ".left");
}

// Of two fabrics that a seam joins, one twice as stiff, each has its own pressure on its side of the seam, on
// triangles, within 1 % at every node.
TEST(TwoFabrics, HaveTheirOwnPressures) {
  Teuchos::ParameterList list("scene");
  list.sublist("Body").setParameters(body_list("cylinder").set("radius", 60.0));
  add_tube(list, "soft", 0.01, 0.0);
  add_tube(list, "stiff", 0.02, 36.5);
  list.sublist("Seams").sublist("ring").set("first", "soft.top").set("second", "stiff.bottom");
  list.sublist("Supports").sublist("end").set("on", Teuchos::Array<std::string>(1, "soft.bottom")).set("hold", "z");
  list.sublist("Contact").set("contact surface", "mid-surface");
  list.sublist("Stages").sublist("settle").set("type", "settle");
  run::Session session(base::validate(list, scene::scene_spec(), "two.xml"));
  session.run();
  const scene::Scene& scene = session.scene();
  const solve::Fields& fields = session.record().fields();
  const double hoop = 1.2, axial = 1.0 / std::sqrt(hoop);
  const double per_c10 = 2.0 / axial * (hoop - std::pow(axial, -2) * std::pow(hoop, -3)) / 60.0;
  double worst = 0.0, force_over_area = 0.0;
  for (size_t b = 0; b < 2; ++b)
    for (const int n : scene.problem().mesh->blocks[b].connectivity) {
      const double exact = per_c10 * (b == 0 ? 0.01 : 0.02);
      worst = std::max(worst, std::abs(fields.pressure[n] / exact - 1.0));
      force_over_area = std::max(force_over_area, std::abs(fields.contact_force[n] / fields.area[n] / exact - 1.0));
    }
  print("two fabrics: largest error %.3f %% (force/area %.0f %%)\n", 100.0 * worst, 100.0 * force_over_area);
  EXPECT_LE(worst, 0.01);
}

}  // namespace
}  // namespace toile::test
