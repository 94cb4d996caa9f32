// Two flat jaws, or legs of wood, over which a stocking is drawn and which are driven apart. The tester tells the
// pressure on a limb of the girth that the stocking then has, by Laplace's law.
#include <cmath>

#include "tester_kind.hpp"

namespace toile::scene {

namespace {

class FlatJaws : public Tester {
 public:
  FlatJaws(const base::List& entry, const TesterPlaces& places)
      : Tester(entry.name()),
        support_(existing(entry, "support", places.supports)),
        width_(entry.real("width")),
        girth_(entry.real("girth")) {}

  TesterReading read(const WornGarment& garment) const override {
    const double tension = garment.force(support_) / width_, pressure = tension * 2.0 * M_PI / girth_;
    return {"", pressure, 0.0, pressure};
  }

 private:
  std::string support_;
  double width_, girth_;  // mm
};

}  // namespace

TesterKind flat_jaws_tester() {
  using base::Range;
  base::Spec spec("flat jaws",
                  "Two jaws, or legs of wood, that stretch the fabric between them: tension = force / width, and "
                  "pressure = tension / radius on a limb of the girth.");
  spec.word("support", "Name of the entry of Supports that holds the fabric's one layer on one of the jaws.")
      .real("width", "mm", "Width of the jaws, along which they hold the fabric.", base::required, Range::positive())
      .real("girth", "mm", "Of the limb, twice the distance of the jaws.", base::required, Range::positive());
  return {spec, [](const base::List& entry, const TesterPlaces& places) -> std::shared_ptr<const Tester> {
            return std::make_shared<FlatJaws>(entry, places);
          }};
}

}  // namespace toile::scene
