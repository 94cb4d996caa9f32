#include "toile/garment/panel.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "imperfection.hpp"
#include "placement.hpp"
#include "shape.hpp"
#include "toile/base/error.hpp"
#include "toile/mesh/polygon.hpp"

namespace toile::garment {
namespace {

constexpr int outline_points_per_side = 200;
/// More would take the memory of a large machine before the first step.
constexpr int most_elements_a_side = 10000, most_elements = 1000000;

base::Spec panel_spec() {
  base::Spec spec("panel", "One flat piece of fabric. Its pattern is the stress-free state.");
  spec.word("material", "Name of an entry of the list Materials.")
      .real("wale angle", "deg", "Angle from the pattern's x axis to the fabric's wale direction.", 90.0)
      .integer("elements across", "Number of elements from left to right.", base::required,
               base::Range::between(1, most_elements_a_side))
      .integer("elements along", "Number of elements from bottom to top.", base::required,
               base::Range::between(1, most_elements_a_side))
      .choice("elements", "Kind of elements.", {"quadrilateral", "triangle"}, std::string("quadrilateral"))
      .real("grading across", "",
            "Exponent g of the node spacing towards the left and right side: nodes at 1/2 (2t)^g from either end; "
            "1: uniform.",
            1.0, base::Range::at_least(1.0))
      .real("grading along", "", "The same towards the bottom and the top.", 1.0, base::Range::at_least(1.0))
      .list(placement_spec())
      .list(imperfection_spec())
      .list(shell_spec());
  std::vector<base::Spec> variants;
  for (const Shape& shape : shapes()) variants.push_back(shape.spec);
  spec.variant("shape", "How the outline is described.", variants);
  return spec;
}

void check_outline(const base::List& entry, const mesh::FourSides& sides) {
  if (const auto gap = sides.open_corner()) {
    entry.fail("shape",
               "the outline of panel \"" + entry.name() + "\" is not closed: " + *gap + " must be the same point");
  }
  const std::vector<mesh::Vec2> outline = sides.polygon(outline_points_per_side);
  if (const auto at = mesh::find_self_intersection(outline)) {
    std::ostringstream text;
    text << "panel \"" << entry.name() << "\" overlaps itself near (" << at->x() << ", " << at->y()
         << ") mm of its pattern; its outline must not cross or touch itself";
    entry.fail("shape", text.str());
  }
  if (mesh::signed_area(outline) <= 0.0) {
    entry.fail("shape",
               "the outline of panel \"" + entry.name() +
                   "\" runs clockwise: \"bottom\" and \"top\" must run from left to right, \"left\" and \"right\" "
                   "from bottom to top, with the right side of the fabric facing the reader");
  }
}

mesh::FourSides read_sides(const base::List& entry) {
  const std::string& wanted = entry.word("shape");
  const auto& all = shapes();
  const auto shape =
      std::find_if(all.begin(), all.end(), [&wanted](const Shape& s) { return s.spec.name() == wanted; });
  mesh::FourSides sides = shape->sides(entry);
  if (shape->drawn) check_outline(entry, sides);
  return sides;
}

}  // namespace

base::Spec panels_spec() {
  base::Spec spec("Panels", "The pieces of fabric; the name of each entry is the name of the panel.");
  spec.entries(panel_spec(), 1);
  return spec;
}

Panel build_panel(const base::List& entry) {
  const mesh::FourSides sides = read_sides(entry);
  mesh::GridOptions options;
  options.across = entry.integer("elements across");
  options.along = entry.integer("elements along");
  options.triangles = entry.word("elements") == "triangle";
  options.grading_across = entry.real("grading across");
  options.grading_along = entry.real("grading along");
  if (options.along > most_elements / options.across)
    entry.fail("elements along", "with \"elements across\" = " + std::to_string(options.across) +
                                     " the panel has more than " + std::to_string(most_elements) + " elements");
  Panel panel{entry.name(), entry.word("material"), entry.real("wale angle") * M_PI / 180.0, {}, read_shell(entry)};
  try {
    panel.grid = mesh::mesh_four_sided(entry.name(), sides, options);
  } catch (const base::InputError& error) {
    entry.fail("shape", error.what());
  }
  return panel;
}

}  // namespace toile::garment
