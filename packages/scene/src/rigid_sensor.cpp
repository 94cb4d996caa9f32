// A rigid sensor between the fabric and the limb at a level, with its longer edges along the limb.
#include <cmath>
#include <limits>

#include "tester_kind.hpp"

namespace toile::scene {

namespace {

class RigidSensor : public Tester {
 public:
  RigidSensor(const base::List& entry, const TesterPlaces& places)
      : Tester(entry.name()),
        level_(existing(entry, "level", places.levels)),
        width_(entry.real("width")),
        height_(entry.real("height")) {}

  TesterReading read(const WornGarment& garment) const override {
    LimbSection limb = garment.section(level_);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (limb.problem.empty() && width_ > 2.0 * limb.radius) limb.problem = "the sensor is wider than the limb";
    if (!limb.problem.empty()) return {limb.problem, none, none, none};
    const double ratio = reading_over_pressure(limb.radius);
    return {"", limb.laplace, ratio * limb.pressure_error, ratio * limb.laplace};
  }

 private:
  /// Its reading over the pressure T/R of the bare limb: 2 R sin(beta) / b, beta = atan(b / (2 (R + h))) + acos(R /
  /// sqrt(b^2/4 + (R + h)^2)), if the fabric slides without friction, so that its tension T is the same everywhere.
  double reading_over_pressure(double radius) const {
    const double over = radius + height_, corner = std::hypot(0.5 * width_, over);
    const double beta = std::atan(0.5 * width_ / over) + std::acos(radius / corner);
    return 2.0 * radius * std::sin(beta) / width_;
  }

  std::string level_;
  double width_, height_;  // mm, round the limb and off it
};

}  // namespace

TesterKind rigid_sensor_tester() {
  using base::Range;
  base::Spec spec("rigid sensor",
                  "A stiff sensor between the fabric and the skin, over whose edges the fabric is bent: it reads more "
                  "than the fabric presses with.");
  spec.word("level", "Name of the entry of Levels at which it lies.")
      .real("width", "mm", "Of the sensor, round the limb; no wider than the limb.", base::required,
            Range::between(1.0, 200.0))
      .real("height", "mm", "Of the sensor.", base::required, Range::between(0.01, 20.0));
  return {spec, [](const base::List& entry, const TesterPlaces& places) -> std::shared_ptr<const Tester> {
            return std::make_shared<RigidSensor>(entry, places);
          }};
}

}  // namespace toile::scene
