#include <gtest/gtest.h>

#include <cmath>

#include "reals.hpp"
#include "toile/run/pressure_report.hpp"
#include "verification/contact_reference.hpp"
#include "verification/print.hpp"

namespace toile::test {
namespace {

using scene::PressureLine;
using Teuchos::ParameterList;

/// A settled sleeve of the reference with one line on its body.
struct LineOnSleeve {
  std::unique_ptr<run::Session> session;
  std::vector<run::PointPressure> pressures;

  const PressureLine& line() const { return session->scene().output().lines.front(); }
};

LineOnSleeve settle_with(const ContactReference& reference, const ParameterList& line) {
  SleeveOptions o;
  o.body = body_of(reference);
  o.material = material_of(reference.part(3));
  o.r0 = reference.header("R0");
  o.l0 = reference.header("L0");
  o.to = 0.98 * reference.header("z_end");
  o.hold_top = "";
  o.around = 48;
  o.along = 16;
  ParameterList scene = sleeve_list(o);
  scene.sublist("Output").sublist("Lines").sublist("line").setParameters(line);
  LineOnSleeve found;
  found.session = std::make_unique<run::Session>(base::validate(scene, scene::scene_spec(), "sleeve.xml"));
  found.session->run();
  const run::Record& record = found.session->record();
  found.pressures = run::body_pressures(record.scene(), found.line().places, record.fields(), record.last());
  return found;
}

/// Largest difference from the reference's pressure at the height, over its mean; and from that over the told error.
void expect_pressure(const LineOnSleeve& found, const ContactReference& reference, double tolerance) {
  double largest = 0.0, beyond = 0.0;
  for (size_t s = 0; s < found.pressures.size(); ++s) {
    const double exact = reference.at("z", found.line().places[s].place.z(), "p");
    const double error = std::abs(found.pressures[s].pressure - exact);
    largest = std::max(largest, error / exact);
    beyond = std::max(beyond, error / found.pressures[s].error);
    EXPECT_GT(found.pressures[s].error, 0.0);
  }
  print("pressure along a line: largest error %.3f %%, %.2f of the told error\n", 100.0 * largest, beyond);
  EXPECT_LE(largest, tolerance);
  EXPECT_LE(beyond, 1.5);
}

ParameterList way(const Teuchos::Array<double>& through, int stations) {
  ParameterList line;
  line.set("type", "shortest way").set("through", through).set("stations", stations);
  return line;
}

/// Length of the straight line on the cone r = 80 - z/4 rolled out, between places that a turn of `angle` parts.
double length_on_cone(double z1, double z2, double angle) {
  const double sine = 0.25 / std::hypot(1.0, 0.25);
  const double s1 = (80.0 - 0.25 * z1) / sine, s2 = (80.0 - 0.25 * z2) / sine;
  return std::sqrt(s1 * s1 + s2 * s2 - 2.0 * s1 * s2 * std::cos(angle * sine));
}

// A helix across the elements of a sleeve on a cylinder meets T/r everywhere, and has its length.
TEST(PressureAlongLine, HelixOnACylinder) {
  const ContactReference reference("contact_cyl_free_nh");
  constexpr double r = 60.0, angle = 2.0;  // mm, rad
  const double low = 15.0, high = 0.98 * reference.header("z_end") - 15.0;
  const LineOnSleeve found =
      settle_with(reference, way(reals({r, 0.0, low, r * std::cos(angle), r * std::sin(angle), high}), 41));
  const double length = std::hypot(r * angle, high - low);
  print("helix: length %.4f mm, exact %.4f mm\n", found.line().lengths.back(), length);
  EXPECT_NEAR(found.line().lengths.back() / length, 1.0, 4e-5);
  for (size_t s = 0; s < found.line().lengths.size(); ++s) {
    const solve::Vec3& x = found.line().places[s].place;
    const double share = static_cast<double>(s) / 40.0;
    EXPECT_NEAR(found.line().lengths[s], share * found.line().lengths.back(), 1e-9);
    EXPECT_NEAR(std::hypot(x.x(), x.y()), r, 1e-9);
    EXPECT_NEAR(std::atan2(x.y(), x.x()), share * angle, 0.02);
    EXPECT_NEAR(x.z(), low + share * (high - low), 1.0);
  }
  expect_pressure(found, reference, 0.01);
}

// The shortest way on a cone is straight when it is rolled out; the pressure along it follows the semi-analytic one.
TEST(PressureAlongLine, ShortestWayOnACone) {
  const ContactReference reference("contact_cone_free_nh");
  constexpr double low = 15.0, high = 80.0, angle = 2.5;
  const auto radius = [](double z) { return 80.0 - 0.25 * z; };
  const LineOnSleeve found = settle_with(
      reference,
      way(reals({radius(low), 0.0, low, radius(high) * std::cos(angle), radius(high) * std::sin(angle), high}), 41));
  const double length = length_on_cone(low, high, angle);
  print("way on a cone: length %.4f mm, exact %.4f mm\n", found.line().lengths.back(), length);
  EXPECT_NEAR(found.line().lengths.back() / length, 1.0, 4e-5);
  for (const scene::BodyPoint& at : found.line().places)
    EXPECT_NEAR(std::hypot(at.place.x(), at.place.y()), radius(at.place.z()), 1e-9);
  expect_pressure(found, reference, 0.007);
}

// An oblique cut of the cone, from side to side of it and back: an ellipse, which starts where it is told.
TEST(PressureAlongLine, ObliqueCutOfACone) {
  const ContactReference reference("contact_cone_free_nh");
  ParameterList line;
  line.set("type", "cut").set("at", reals({0.0, 0.0, 48.0})).set("normal", reals({-0.3, 0.1, 1.0}));
  line.set("from", reals({0.0, -500.0, 48.0})).set("stations", 73);
  const LineOnSleeve found = settle_with(reference, line);
  const std::vector<scene::BodyPoint>& places = found.line().places;
  const solve::Vec3 normal(-0.3, 0.1, 1.0);
  double turned = 0.0;
  for (size_t s = 0; s < places.size(); ++s) {
    EXPECT_NEAR((places[s].place - solve::Vec3(0.0, 0.0, 48.0)).dot(normal), 0.0, 0.1);
    if (s == 0) continue;
    const solve::Vec3 &a = places[s - 1].place, &b = places[s].place;
    const double step = std::remainder(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()), 2.0 * M_PI);
    EXPECT_GT(step, 0.0);
    turned += step;
  }
  EXPECT_NEAR(turned, 2.0 * M_PI, 1e-9);
  EXPECT_NEAR(std::atan2(places.front().place.y(), places.front().place.x()), -0.5 * M_PI, 0.1);
  // Its perimeter from chords.
  const auto point = [](double t) {
    // 48 + 0.3 x - 0.1 y = z and hypot(x, y) = 80 - z/4 along a direction.
    const double c = 0.3 * std::cos(t) - 0.1 * std::sin(t), r = (80.0 - 12.0) / (1.0 + 0.25 * c);
    return solve::Vec3(r * std::cos(t), r * std::sin(t), 48.0 + c * r);
  };
  constexpr int parts = 20000;
  double perimeter = 0.0;
  for (int i = 0; i < parts; ++i)
    perimeter += (point(2.0 * M_PI * (i + 1) / parts) - point(2.0 * M_PI * i / parts)).norm();
  print("oblique cut: length %.4f mm, exact %.4f mm\n", found.line().lengths.back(), perimeter);
  EXPECT_NEAR(found.line().lengths.back() / perimeter, 1.0, 4e-5);
  expect_pressure(found, reference, 0.007);
}

}  // namespace
}  // namespace toile::test
