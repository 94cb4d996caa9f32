#include <limits>

#include "landmark_places.hpp"
#include "pressure_line.hpp"
#include "toile/body/body.hpp"
#include "toile/drape/drape.hpp"
#include "toile/garment/finer.hpp"
#include "toile/garment/panel.hpp"
#include "toile/garment/pattern.hpp"
#include "toile/garment/seam.hpp"
#include "toile/material/formula.hpp"
#include "toile/material/material.hpp"
#include "toile/material/plugin_files.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/spec.hpp"

namespace toile::scene {

using base::Range;
using base::Spec;

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Spec output_spec() {
  Spec level("level", "A height at which the pressure is averaged around the body.");
  level.real("height", "mm",
             "Height along the axis, or the landmark of the body that lies there (bust, left knee + 20).");
  Spec curve("curve", "Reaction of a support along its movement, drawn against the stretch.");
  curve.word("support", "Name of the entry of Supports that is moved.")
      .real("length", "mm", "Pattern length that the support's displacement stretches.", base::required,
            Range::positive());
  Spec distance("distance", "Distance of two points on edges, written at every step.");
  distance.word("first", "Name of an edge, for instance strip.left.")
      .real("first at", "", "Place on the first edge, from 0 at its start to 1 at its end.", 0.5,
            Range::between(0.0, 1.0))
      .word("second", "Name of the other edge, for instance strip.right.")
      .real("second at", "", "Place on the second edge, from 0 at its start to 1 at its end.", 0.5,
            Range::between(0.0, 1.0));
  Spec point("point", "A node whose displacement is written at every step.");
  point.word("on", "A corner (front.top-left), a place on an edge (front.top@0.5) or in a panel (front@0.5,0.25).");
  Spec body_point("body point", "A place on the body, whatever fabric lies there.");
  body_point.reals("at", "mm", "x, y, z within 20 mm of the body's skin, or a landmark on it (left bust point).");
  Spec output("Output", "What is written beyond the fields of the Exodus file.");
  output
      .reals("axis point", "mm",
             "Point of the axis along which heights are measured, or a landmark of the body; it has height 0.",
             base::Reals{0.0, 0.0, 0.0})
      .reals("axis direction", "", "Direction of that axis.", base::Reals{0.0, 0.0, 1.0})
      .reals("axis", "mm",
             "Instead of both, the axis of a bent limb: points x, y, z, x, y, z, ... or landmarks. Heights count along "
             "it from the first point; sections lie across it, and of those only the ones that surround it are told.",
             base::Reals{})
      .real("smoothing", "mm",
            "Of 'axis': length over which each corner is spread to either side; 0: the shortest distance of two "
            "neighbouring points.",
            0.0, Range::non_negative())
      .integer("stations", "Points of the pressure curve along the axis, at least 2; 0: no curve.", 0,
               Range::between(0, 10000))
      .real("body size", "mm",
            "Edge length of the triangles that show the body. Left out: 5 of a body given by a formula; of one from a "
            "file the mean side of the garment's elements, near the garment, and beyond it the file's own triangles.",
            std::numeric_limits<double>::quiet_NaN(), Range::positive())
      .flag("crossings",
            "Whether fabric that passes through itself or through other panels is looked for: at the start, in every "
            "written state and at the end of each stage, which warns. Elements that have a node or a seam in common do "
            "not count, nor does fabric that lies on fabric (less than a tenth of an element's side deep).",
            true)
      .list(Spec("Levels", "Named heights, for instance the hosiery levels.").entries(level))
      .list(Spec("Force curves", "Force against stretch, as in a tensile test.").entries(curve))
      .list(Spec("Distances", "Distances that are followed, for instance the width of a necking strip.")
                .entries(distance))
      .list(Spec("Points",
                 "Nodes whose displacements are followed (points.csv), and their pressure at the end "
                 "(pressure-points.csv).")
                .entries(point))
      .list(Spec("Body points",
                 "Places on the body, at which the pressure of whatever fabric lies there is told "
                 "(pressure-points.csv): the same places whatever the mesh.")
                .entries(body_point))
      .list(lines_spec())
      .list(Spec("Testers", "What testers of a hosiery laboratory would read (testers.csv).").entries(tester_spec()))
      .list(drapemeter_spec());
  return output;
}

Spec accuracy_spec() {
  return Spec("Accuracy",
              "How small the error of the pressure is to be: the scene is run again on finer meshes (parameter "
              "\"finer\") "
              "until it is. The results are those of the last run; accuracy.csv tells what each run has reached and "
              "what it took. If the error cannot be reached the last run is kept, and the exit status is 4.")
      .real("error", "%", "Largest allowed error of a pressure, of its size.", base::required, Range::positive())
      .words("at",
             "Names of entries of Levels, Points and Body points. Left out: all levels, or all points if there are "
             "none.",
             base::Texts{})
      .integer("most runs", "Runs after which it is given up.", 6, Range::between(1, 20))
      .integer("most nodes", "Of a mesh that is still run.", 200000, Range::at_least(1));
}

Spec checks_spec() {
  Spec check("check", "A bound that the result must keep.");
  check
      .word(
          "quantity",
          "What is bounded: largest pressure or smallest principal stress (kPa), force balance (residual over the sum "
          "of magnitudes), largest gap of a node in contact (mm), dissipation ratio, extrapolated elements (their "
          "number, outside the calibrated range of their fabric); drape coefficient or folds of the Drapemeter; "
          "pressure at level <level> (kPa, the mean round the "
          "section) or ratio of levels <level> to <level>; or compression class (of the pressure at level B) or "
          "compression class at level <level>. Of several sections at a level one is named as in pressure-levels.csv, "
          "for instance C (2).")
      .real("lower", "", "Least allowed value.", -unbounded)
      .real("upper", "", "Greatest allowed value.", unbounded)
      .choice("standard", "Of a compression class: who defines it.", compression_standards(), std::string("RAL-GZ 387"))
      .word("class",
            "Of a compression class: its name, I, II, III or IV, in ENV 12718 A as well. The error of the pressure "
            "counts: the check holds if all of pressure +- error lies within the class; if a part does, it is not "
            "decided, which is told and does not hold either.",
            std::string());
  return Spec("Checks", "Bounds on the result; one that does not hold ends the run with exit status 4.").entries(check);
}

}  // namespace

Spec materials_spec(const material::Laws& laws) {
  return Spec("Materials", "The fabrics, by name.").entries(material::material_spec(laws), 1);
}

Spec scene_spec(const material::Laws& laws, std::vector<std::string>* warnings) {
  return Spec("scene", "One garment, the body that wears it, and what happens to it.")
      .word("title", "What the scene shows.", std::string())
      .add(base::include_parameter())
      .add(garment::finer_parameter())
      .list(body::body_spec())
      .list(material::plugins_spec())
      .list(material::formulas_spec())
      .list(materials_spec(laws), true)
      .list(garment::pattern_spec())
      .list(garment::panels_spec(), true)
      .list(garment::seams_spec())
      .list(drape::drape_spec())
      .list(solve::supports_spec())
      .list(solve::loads_spec())
      .list(solve::contact_spec())
      .list(solve::stages_spec(), true)
      .list(solve::solver_spec())
      .list(output_spec())
      .list(checks_spec())
      .list(accuracy_spec())
      .completed_by([warnings](Teuchos::ParameterList& list, base::Origins& origins) {
        const base::Texts found = put_landmarks(list, origins);
        if (warnings != nullptr) *warnings = found;
        garment::add_pattern(list, origins);
        garment::make_finer(list);
      });
}

}  // namespace toile::scene
