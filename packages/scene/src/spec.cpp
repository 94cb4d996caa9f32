#include "spec.hpp"

#include "toile/body/body.hpp"
#include "toile/garment/panel.hpp"
#include "toile/garment/seam.hpp"
#include "toile/material/material.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/spec.hpp"

namespace toile::scene {

using base::Range;
using base::Spec;

namespace {

Spec output_spec() {
  Spec level("level", "A height at which the pressure around the body is averaged");
  level.real("height", "mm", "Height along the axis");
  Spec curve("curve", "Reaction of a support, drawn against the stretch");
  curve.word("support", "Name of the entry of \"Supports\" that is moved")
      .real("length", "mm", "Pattern length that the support's displacement stretches", base::required,
            Range::positive());
  Spec distance("distance", "Distance of two points on edges, written at every step");
  distance.word("first", "Edge, for instance \"strip.left\"")
      .real("first at", "", "Place on the first edge, 0 to 1", 0.5, Range::between(0.0, 1.0))
      .word("second", "Edge, for instance \"strip.right\"")
      .real("second at", "", "Place on the second edge, 0 to 1", 0.5, Range::between(0.0, 1.0));
  Spec output("Output", "What is written beyond the fields of the Exodus file");
  output.reals("axis point", "mm", "Point of the axis along which heights are measured (height 0)",
               base::Reals{0.0, 0.0, 0.0})
      .reals("axis direction", "", "Direction of that axis", base::Reals{0.0, 0.0, 1.0})
      .integer("stations", "Points of the pressure curve along the axis; 0: no curve", 0, Range::at_least(0))
      .real("body size", "mm", "Edge length of the triangles that show a body given by a formula", 5.0,
            Range::positive())
      .list(Spec("Levels", "Named heights, for instance the hosiery levels").entries(level))
      .list(Spec("Force curves", "Tensile tests").entries(curve))
      .list(Spec("Distances", "For instance the width of a necking strip").entries(distance));
  return output;
}

Spec checks_spec() {
  Spec check("check", "A bound that the result must keep");
  check
      .choice("quantity",
              "largest pressure, smallest principal stress (kPa), force balance (residual over the sum of magnitudes), "
              "largest gap (mm), dissipation ratio, extrapolated elements (number)",
              {"largest pressure", "smallest principal stress", "force balance", "largest gap", "dissipation ratio",
               "extrapolated elements"})
      .real("lower", "", "Least allowed value", -1e300)
      .real("upper", "", "Greatest allowed value", 1e300);
  return Spec("Checks", "A check that does not hold ends the run with exit status 4").entries(check);
}

}  // namespace

Spec materials_spec() {
  return Spec("Materials", "The fabrics, by name").entries(material::material_spec(), 1);
}

Spec scene_spec() {
  return Spec("scene", "One garment, the body it is worn on, and what happens to it")
      .word("title", "What the scene shows", std::string())
      .list(body::body_spec())
      .list(materials_spec(), true)
      .list(garment::panels_spec(), true)
      .list(garment::seams_spec())
      .list(solve::supports_spec())
      .list(solve::loads_spec())
      .list(solve::contact_spec())
      .list(solve::stages_spec(), true)
      .list(solve::solver_spec())
      .list(output_spec())
      .list(checks_spec());
}

}  // namespace toile::scene
