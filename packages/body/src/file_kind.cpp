#include <cmath>

#include "file_kind.hpp"

namespace toile::body {
namespace {

using base::Range;
using base::Reals;
using base::Spec;

Spec file_spec() {
  Spec spec("file", "Triangles or quads from an OBJ, STL, PLY or OFF file, made smooth.");
  spec.word("file", "Path of the file, from the folder of the scene.");
  spec.real("scale", "", "Factor that turns the coordinates of the file into mm (1000 for metres).", 1.0,
            Range::positive());
  spec.choice(
      "up",
      "Axis of the file that is the height; it becomes z, with y up x stays. If this or \"height range\" is given, a "
      "body that is much wider than high is accepted as well.",
      {"x", "y", "z"}, std::string("z"));
  spec.reals(
      "height range", "mm",
      "Smallest and largest allowed height (extent in z) after scaling; guards against a wrong unit. A body that "
      "is smaller than 300 mm in truth (a wrist, a head) needs a range of its own.",
      Reals{300.0, 3000.0}, Range::non_negative());
  spec.flag("closed", "true: the surface must have no border; false: a tube with open ends is meant.", true);
  spec.flag("repair orientation",
            "true: a body whose facets look inwards is turned; false: it is refused. Closed pieces inside another one "
            "(cavities) are left out in any case, pieces that intersect are refused.",
            false);
  spec.real(
      "weld", "mm",
      "Vertices on borders (of an STL: copies of one vertex) that are no further apart become one. 0: 1e-5 of the "
      "diagonal of the body, at most 2 % of the border's edges.",
      0.0, Range::non_negative());
  spec.choice("surface",
              "What the fabric lies on: a smooth surface fitted to the facets. The facets themselves are refused: "
              "without friction, fabric comes to rest on their edges, where the normal jumps and no iteration "
              "converges.",
              {"smooth", "facets"}, std::string("smooth"));
  return add_fit(spec);
}

}  // namespace

Spec add_fit(Spec spec) {
  spec.real("cell", "mm",
            "Cell of the smooth surface. 0: from the mean edge length: 7 for edges of 5-12 mm, above that 0.55 edges.",
            0.0, Range::non_negative());
  spec.real("smoothing", "",
            "Weight of the third derivatives. 0: from the mean edge length and the cell, (0.4 edge/cell)^6/3 and at "
            "least 1e-3, so that facets do not show in the pressure.",
            0.0, Range::non_negative());
  Spec reach(
      "Reach",
      "Part of the body that the garment can reach; all else is left out. Without this list: all of it, or, if all "
      "panels are wrapped round one axis, the piece that holds the axis, between their heights and 50 mm more.");
  reach.real("bottom", "mm", "Lowest z, or a landmark of the body (crotch - 50).", -HUGE_VAL);
  reach.real("top", "mm", "Highest z, or a landmark.", HUGE_VAL);
  reach.reals("lower corner", "mm", "Lower x, y, z of a box that bounds it further; {}: none.", Reals{});
  reach.reals("upper corner", "mm", "Upper x, y, z of that box; {}: none.", Reals{});
  reach.reals(
      "seed", "mm",
      "Point (x, y, z) inside or near the wanted piece, for instance one of two legs, or a landmark (left calf); "
      "{}: all pieces.",
      Reals{});
  return spec.list(reach);
}

Kind file_kind() {
  return {file_spec(), make_from_file};
}

}  // namespace toile::body
