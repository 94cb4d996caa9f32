#include "shape.hpp"

#include <cmath>
#include <string>

#include "toile/mesh/four_sided.hpp"

namespace toile::garment {
namespace {

using mesh::FourSides;
using mesh::Vec2;
using pattern::Curve;

/// Four sides, of which top and left run against the outline.
Cut cut_of(const FourSides& sides) {
  Cut cut;
  cut.panel.outline = {{"bottom", sides.bottom}, {"right", sides.right}, {"top", sides.top}, {"left", sides.left}};
  cut.backwards = {"top", "left"};
  return cut;
}

base::Spec rectangle_spec() {
  return base::Spec("rectangle", "Rectangle with its lower left corner at the origin of the pattern.")
      .real("width", "mm", "Extent along the pattern's x axis.", base::required, base::Range::positive())
      .real("height", "mm", "Extent along the pattern's y axis.", base::required, base::Range::positive());
}

Cut rectangle_sides(const base::List& panel) {
  return cut_of(mesh::rectangle(panel.real("width"), panel.real("height")));
}

base::Spec four_sided_spec() {
  return base::Spec("four-sided",
                    "Panel between four curves that are given by points from corner to corner. Seen from the "
                    "right side of the fabric, bottom, right, top, left go round counter-clockwise.")
      .reals("bottom", "mm", "Points x, y, x, y, ... of the lower side, from the left to the right corner.")
      .reals("right", "mm", "Points of the right side, from the lower to the upper corner.")
      .reals("top", "mm", "Points of the upper side, from the left to the right corner.")
      .reals("left", "mm", "Points of the left side, from the lower to the upper corner.")
      .choice("sides", "What joins the points of a side: natural cubic splines or straight lines.",
              {"smooth", "polyline"}, std::string("smooth"));
}

Curve read_side(const base::List& panel, const std::string& side) {
  const base::Reals& values = panel.reals(side);
  if (values.size() < 4 || values.size() % 2 != 0) {
    panel.fail(side, "has " + std::to_string(values.size()) +
                         " numbers; allowed are pairs x, y, and at least two of them, one for each corner");
  }
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < values.size(); k += 2) {
    points.emplace_back(values[k], values[k + 1]);
    if (k > 0 && points[k / 2] == points[k / 2 - 1]) {
      panel.fail(side, "repeats its point number " + std::to_string(k / 2) +
                           "; each point must differ from the one "
                           "before it");
    }
  }
  return panel.word("sides") == "smooth" ? Curve::spline(points) : Curve::polyline(points);
}

Cut four_sided_sides(const base::List& panel) {
  const FourSides sides{read_side(panel, "bottom"), read_side(panel, "right"), read_side(panel, "top"),
                        read_side(panel, "left")};
  if (const auto gap = sides.open_corner())
    panel.fail("shape",
               "the outline of panel \"" + panel.name() + "\" is not closed: " + *gap + " must be the same point");
  return cut_of(sides);
}

base::Spec profile_spec() {
  return base::Spec("profile", "Panel that is symmetric about x = 0, by its width at some levels (a leg or a sleeve).")
      .reals("levels", "mm", "Pattern coordinates y, strictly increasing.")
      .reals("widths", "mm", "Full width at each level; the sides are natural cubic splines through them.",
             base::required, base::Range::positive());
}

Cut profile_sides(const base::List& panel) {
  const base::Reals& levels = panel.reals("levels");
  const base::Reals& widths = panel.reals("widths");
  if (levels.size() < 2) panel.fail("levels", "has fewer than two values; a panel needs a lower and an upper end");
  if (widths.size() != levels.size()) {
    panel.fail("widths", "has " + std::to_string(widths.size()) + " values, but \"levels\" has " +
                             std::to_string(levels.size()) + "; there must be one width for each level");
  }
  std::vector<Vec2> left, right;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (k > 0 && levels[k] <= levels[k - 1]) {
      panel.fail("levels", "must increase strictly, but value number " + std::to_string(k + 1) + " does not");
    }
    left.emplace_back(-0.5 * widths[k], levels[k]);
    right.emplace_back(0.5 * widths[k], levels[k]);
  }
  return cut_of({Curve::line(left.front(), right.front()), Curve::spline(right, levels),
                 Curve::line(left.back(), right.back()), Curve::spline(left, levels)});
}

base::Spec sector_spec() {
  return base::Spec("sector",
                    "Part of a ring round the origin of the pattern, up to the whole ring. Its bottom is the outer arc "
                    "and its top the inner one, both run from 'from angle' to 'to angle'; its left side lies at 'from "
                    "angle', its right side at 'to angle', and both run inwards. After a full turn left and right lie "
                    "on each other, open unless a seam joins them.")
      .real("inner radius", "mm", "Radius of the top.", base::required, base::Range::positive())
      .real("outer radius", "mm", "Radius of the bottom, greater than the inner one.", base::required,
            base::Range::positive())
      .real("from angle", "deg", "Where the left side lies, counter-clockwise from the pattern's x axis.", 0.0)
      .real("to angle", "deg", "Where the right side lies: beyond 'from angle' by at most 360.");
}

Cut sector_sides(const base::List& panel) {
  const double inner = panel.real("inner radius"), outer = panel.real("outer radius");
  if (inner >= outer) panel.fail("inner radius", "must be smaller than \"outer radius\"");
  const double from = panel.real("from angle"), to = panel.real("to angle");
  if (to <= from || to > from + 360.0) {
    panel.fail("to angle", "must lie beyond \"from angle\" by more than 0 and at most 360 degrees");
  }
  return cut_of(mesh::sector(inner, outer, from * M_PI / 180.0, to * M_PI / 180.0));
}

base::Spec disc_spec() {
  return base::Spec("disc",
                    "Disc round the origin of the pattern, whose four sides are the quarters of its rim between the "
                    "diagonals. With even numbers of elements a node lies in the centre.")
      .real("radius", "mm", "Radius of the disc.", base::required, base::Range::positive());
}

Cut disc_sides(const base::List& panel) {
  return cut_of(mesh::disc(panel.real("radius")));
}

base::Spec quarter_disc_spec() {
  return base::Spec("quarter disc",
                    "Quarter of a disc round the origin of the pattern, for models with two planes of symmetry: its "
                    "bottom and left sides lie on the x and y axes, its right and top sides are the halves of the rim.")
      .real("radius", "mm", "Radius of the disc.", base::required, base::Range::positive());
}

Cut quarter_disc_sides(const base::List& panel) {
  return cut_of(mesh::quarter_disc(panel.real("radius")));
}

}  // namespace

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{{rectangle_spec(), rectangle_sides, false},
                                      {four_sided_spec(), four_sided_sides, true},
                                      {profile_spec(), profile_sides, true},
                                      {sector_spec(), sector_sides, false},
                                      {disc_spec(), disc_sides, false},
                                      {quarter_disc_spec(), quarter_disc_sides, false},
                                      outline_shape(),
                                      pattern_file_shape()};
  return all;
}

}  // namespace toile::garment
