#include "toile/dress/dress.hpp"

#include <algorithm>
#include <cmath>

#include "girths.hpp"
#include "place.hpp"
#include "scaled.hpp"
#include "text.hpp"
#include "toile/base/error.hpp"
#include "wearer.hpp"

namespace toile::dress {
namespace {

/// A pattern that must be stretched by more, or is wider by more everywhere, is not of this body.
constexpr double most_stretch = 2.0, most_wide = 3.0;

std::string mm(double length) {
  return decimals(length, 0) + " mm";
}

std::string place_of(const Girth& girth) {
  return girth.of == name_of_side(0) ? "trunk at height " + mm(girth.at)
                                     : girth.of + " " + mm(girth.at) + " down from the shoulder";
}

std::string compared(const Girth& girth) {
  return "the garment measures " + mm(girth.garment) + " round the " + place_of(girth) + ", and the body " +
         mm(girth.body);
}

/// In percent of the body.
std::string ease_of(const Girth& girth) {
  const double ease = 100.0 * (girth.garment / girth.body - 1.0);
  return ease < 0.0 ? "stretched to " + decimals(girth.stretch(), 2) + " times its width"
                    : decimals(ease, 0) + " % wider than the body";
}

class Dressing {
 public:
  Dressing(const pattern::Pattern& pattern, const body::TriangleMesh& mesh, const Options& options)
      : pattern_(pattern), wearer_(mesh), options_(options) {}

  Dressed run() {
    const Placed placed = at_scale(options_.scale);
    Dressed dressed;
    dressed.pattern = placed.pattern;
    dressed.wraps = placed.wraps;
    dressed.hems = placed.hems;
    dressed.girths = girths_of(placed, wearer_);
    dressed.tightest = tightest_of(dressed.girths);
    dressed.fitting_scale = fitting_scale(dressed.tightest.stretch());
    dressed.lowest = placed.lowest;
    dressed.armholes = placed.underarm;
    dressed.highest = placed.highest;
    check(dressed);
    dressed.lines = lines_of(placed, dressed);
    return dressed;
  }

 private:
  Placed at_scale(double scale) const { return place(scaled(pattern_, scale), wearer_, options_); }

  /// The pattern at this scale is as wide as the body where it is tightest. Its places move with the scale, and with
  /// them where that is: 0 if none was found.
  double fitting_scale(double stretch) const {
    double scale = options_.scale;
    for (int k = 0; k < 20 && std::abs(stretch - 1.0) > 2e-3; ++k) {
      scale *= std::pow(stretch, 0.8);
      stretch = tightest_of(girths_of(at_scale(scale), wearer_)).stretch();
    }
    return std::abs(stretch - 1.0) > 0.01 ? 0.0 : scale;
  }

  std::string scale_text(const Dressed& dressed) const {
    if (dressed.fitting_scale <= 0.0) return "no --scale was found with which it is as wide as the body";
    return "with --scale " + decimals(dressed.fitting_scale, 2) + " its tightest place would be as wide as the body, " +
           (dressed.tightest.stretch() > 1.0 ? "so that it would no longer press (a garment that presses is narrower)"
                                             : "so that a little less makes it press");
  }

  void check(const Dressed& dressed) const {
    for (const Girth& girth : dressed.girths)
      if (girth.stretch() > most_stretch)
        throw base::InputError("the pattern is too small: " + compared(girth) + ", so that it would be stretched to " +
                               decimals(girth.stretch(), 2) + " times its width (allowed: up to " +
                               decimals(most_stretch, 0) + "). Check the unit of the pattern and of the body; " +
                               scale_text(dressed));
    if (std::none_of(dressed.girths.begin(), dressed.girths.end(),
                     [](const Girth& girth) { return girth.of == name_of_side(0) && girth.body > 0.0; }))
      throw base::InputError("nothing of the trunk lies round the body below its armpits: the hem is at the height " +
                             mm(dressed.lowest) +
                             ". Is the pattern too short, too small (--scale), or --hem too high?");
    const Girth& tightest = dressed.tightest;
    if (tightest.stretch() * most_wide < 1.0)
      throw base::InputError("the pattern is too large: where it is tightest, " + compared(tightest) + ": " +
                             decimals(1.0 / tightest.stretch(), 1) + " times as much (allowed: up to " +
                             decimals(most_wide, 0) + "). Check the unit of the pattern and of the body; " +
                             scale_text(dressed));
    constexpr double elements = 8.0;
    for (const Girth& girth : dressed.girths)
      if (girth.body > 0.0 && girth.body < elements * options_.element_size)
        throw base::InputError("elements of " + mm(options_.element_size) + " (--size) are too long for the " +
                               place_of(girth) + ", which measures " + mm(girth.body) + " round: at least " +
                               decimals(elements, 0) + " go round it with --size " +
                               decimals(std::floor(10.0 * girth.body / elements) / 10.0, 1));
  }

  std::vector<std::string> lines_of(const Placed& placed, const Dressed& dressed) const {
    std::vector<std::string> lines;
    for (const int side : {0, 1, -1}) {
      std::string text;
      for (const Part& part : placed.parts)
        if (part.side == side)
          text += (text.empty() ? "" : ", ") + placed.pattern.panels[part.panel].name +
                  (part.whole   ? " (whole)"
                   : part.front ? " (front)"
                                : " (back)");
      if (!text.empty()) lines.push_back(name_of_side(side) + ": " + text);
    }
    lines.push_back("from height " + mm(dressed.lowest) + " (hem, held there) to " + mm(dressed.highest));
    for (const Girth& girth : dressed.girths) {
      if (girth.body <= 0.0) continue;
      lines.push_back(place_of(girth) + ": garment " + decimals(girth.garment, 0) + ", body " +
                      decimals(girth.body, 0) + " mm, " + ease_of(girth));
    }
    lines.push_back("tightest: " + place_of(dressed.tightest) + ", " + ease_of(dressed.tightest) + "; " +
                    scale_text(dressed));
    for (const std::string& text : wearer_.warnings()) lines.push_back("warning: " + text);
    constexpr double loose = 1.1;  // width of a garment, over the body's, that nothing holds in shape
    if (dressed.tightest.stretch() * loose < 1.0)
      lines.push_back(
          "loose everywhere: little will press, and what is loose stays about where it is draped (nothing rubs, and "
          "nothing hangs)");
    return lines;
  }

  const pattern::Pattern& pattern_;
  Wearer wearer_;
  Options options_;
};

}  // namespace

Dressed dress(const pattern::Pattern& pattern, const body::TriangleMesh& body, const Options& options) {
  return Dressing(pattern, body, options).run();
}

}  // namespace toile::dress
