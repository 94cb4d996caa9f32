#include "toile/scene/tester.hpp"

#include <cmath>

namespace toile::scene {

double FlatJaws::pressure(double force) const {
  return force / width * 2.0 * M_PI / girth;
}

double RigidSensor::ratio(double radius) const {
  const double over = radius + height, corner = std::hypot(0.5 * width, over);
  const double beta = std::atan(0.5 * width / over) + std::acos(radius / corner);
  return 2.0 * radius * std::sin(beta) / width;
}

base::Spec tester_spec() {
  using base::Range;
  base::Spec jaws(
      "flat jaws",
      "Two jaws, or legs of wood, that stretch the fabric between them: tension = force / width, and pressure = "
      "tension / radius on a limb of the girth.");
  jaws.word("support", "Name of the entry of Supports that holds the fabric's one layer on one of the jaws.")
      .real("width", "mm", "Width of the jaws, along which they hold the fabric.", base::required, Range::positive())
      .real("girth", "mm", "Of the limb, twice the distance of the jaws.", base::required, Range::positive());
  base::Spec sensor(
      "rigid sensor",
      "A stiff sensor between the fabric and the skin, over whose edges the fabric is bent: it reads more "
      "than the fabric presses with.");
  sensor.word("level", "Name of the entry of Levels at which it lies.")
      .real("width", "mm", "Of the sensor, round the limb; no wider than the limb.", base::required,
            Range::between(1.0, 200.0))
      .real("height", "mm", "Of the sensor.", base::required, Range::between(0.01, 20.0));
  base::Spec tester("tester", "A tester of a hosiery laboratory, and what it would read.");
  tester.variant("type", "Kind of tester.", {jaws, sensor});
  return tester;
}

Tester read_tester(const base::List& entry) {
  if (entry.word("type") == "flat jaws")
    return {entry.name(), FlatJaws{entry.word("support"), entry.real("width"), entry.real("girth")}};
  return {entry.name(), RigidSensor{entry.word("level"), entry.real("width"), entry.real("height")}};
}

}  // namespace toile::scene
