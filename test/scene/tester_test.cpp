#include "toile/scene/tester.hpp"

#include <gmock/gmock.h>

#include <Teuchos_ParameterList.hpp>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::scene {
namespace {

using ::testing::HasSubstr;
using Teuchos::ParameterList;

/// A limb of 40 mm radius on which fabric presses with 1 MPa, and a support that bears 3 N.
class Garment : public WornGarment {
 public:
  double force(const std::string&) const override { return 3.0; }
  LimbSection section(const std::string&) const override { return {"", 40.0, 1.0, 0.1}; }
};

std::shared_ptr<const Tester> tester(const ParameterList& entry) {
  ParameterList testers("Testers");
  testers.sublist("one") = entry;
  testers.sublist("one").setName("one");
  const base::List list = base::validate(testers, base::Spec("Testers", "").entries(tester_spec()), "scene.xml");
  return read_tester(list.entries().front(), {{"upper jaw"}, {"middle"}});
}

ParameterList sensor(double width, double height) {
  ParameterList entry;
  entry.set<std::string>("type", "rigid sensor").set<std::string>("level", "middle");
  entry.set("width", width).set("height", height);
  return entry;
}

ParameterList jaws(const std::string& support) {
  ParameterList entry;
  entry.set<std::string>("type", "flat jaws").set("support", support).set("width", 50.0).set("girth", 200.0);
  return entry;
}

std::string refusal(const ParameterList& entry) {
  try {
    tester(entry);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

// A rigid sensor on a limb of radius 40 mm reads 2.26 times the pressure under 9.5 x 0.2 mm and 1.45 times under 50 x 1
// mm, and its error is so many times that of the pressure.
TEST(RigidSensor, ReadsMoreThanTheFabricPresses) {
  const TesterReading narrow = tester(sensor(9.5, 0.2))->read(Garment());
  EXPECT_NEAR(narrow.reading, 2.26, 0.005);
  EXPECT_NEAR(narrow.error, 0.226, 0.0005);
  EXPECT_EQ(narrow.pressure, 1.0);
  EXPECT_NEAR(tester(sensor(50.0, 1.0))->read(Garment()).reading, 1.45, 0.005);
}

// One that is wider than the limb reads nothing.
TEST(RigidSensor, IsNotWiderThanTheLimb) {
  const TesterReading wide = tester(sensor(81.0, 1.0))->read(Garment());
  EXPECT_EQ(wide.problem, "the sensor is wider than the limb");
  EXPECT_TRUE(std::isnan(wide.reading));
}

// Flat jaws read the tension over the radius of the limb.
TEST(FlatJaws, ReadTensionOverRadius) {
  EXPECT_DOUBLE_EQ(tester(jaws("upper jaw"))->read(Garment()).reading, 3.0 / 50.0 / (200.0 / (2.0 * M_PI)));
}

// Each kind refuses a place that the scene does not have, with the nearest name.
TEST(Tester, NeedsItsPlace) {
  EXPECT_THAT(refusal(jaws("uper jaw")), HasSubstr("Testers > one: parameter \"support\" = \"uper jaw\": no support is "
                                                   "named \"uper jaw\"; did you mean \"upper jaw\"?"));
  ParameterList elsewhere = sensor(20.0, 1.0);
  elsewhere.set<std::string>("level", "midle");
  EXPECT_THAT(refusal(elsewhere), HasSubstr("no level is named \"midle\"; did you mean \"middle\"?"));
}

}  // namespace
}  // namespace toile::scene
