#include "toile/study/spec.hpp"

#include <limits>

namespace toile::study {

namespace {

using base::Range;
using base::Spec;

Spec vary_spec() {
  Spec spec("change", "One parameter of the scene, or several that get the same value. Each value of it is a case.");
  spec.words("paths",
             "What is set: paths in the scene, Panels/front/size. Beside them: include (a file that is read after the "
             "scene and goes before it, its path from the folder of this file; - for none), run/threads, run/ranks.")
      .words("values",
             "Values, as an XML file has them; the entries of an array stand apart by blanks (numbers) or semicolons "
             "(texts).")
      .words("labels", "What tables call the values; empty: as they are written.", base::Texts{})
      .word("with",
            "Name of another change that has as many values: both go through them together. Empty: every value is "
            "combined with all of the others.",
            std::string())
      .flag("problem",
            "true: each value is another problem with a result of its own. false: a way to solve the same problem, "
            "which must lead to the same result.",
            false)
      .reals("sizes", "mm",
             "Element size of each value, or any measure that goes to zero as it does, for the order of convergence. "
             "Empty: the number of unknowns to the power -1/2.",
             base::Reals{}, Range::positive());
  return Spec("Vary", "What is varied.").entries(spec, 1);
}

Spec quantities_spec() {
  const base::Texts components = {"x", "y", "z"};
  Spec spec("quantity", "A number that a run writes.");
  spec.variant(
          "type", "Where it stands.",
          {Spec("level", "Mean pressure at a level of the scene's Output, kPa.").word("of", "Name of the level."),
           Spec("point", "Pressure at a point of the scene's Output, kPa.").word("of", "Name of the point."),
           Spec("displacement", "Displacement of a point at the end, mm.")
               .word("of", "Name of the point.")
               .choice("component", "", components),
           Spec("distance", "A distance of the scene's Output at the end, mm.").word("of", "Name of the distance."),
           Spec("reaction", "Force of a support on the garment at the end, N.")
               .word("of", "Name of the support.")
               .choice("component", "", components),
           Spec("body force", "Force of the body on the garment at the end, N.")
               .choice("component", "Along which axis.", components),
           Spec("torque", "Torque of a support that turns, at the end, N mm.").word("of", "Name of the support."),
           Spec("figure", "A row of figures.csv, which every run writes.").word("of", "Its name: largest pressure.")})
      .reals("reference", "",
             "Exact value, in the quantity's unit, not 0: one for all, or one for each value of the first change that "
             "is a "
             "problem. Empty: see below.",
             base::Reals{})
      .word("reference file",
            "CSV file with exact values, its path from the folder of this file; its rows are found by the columns that "
            "have the name of a change. Empty: the result is extrapolated along \"refine\".",
            std::string())
      .word("reference column", "Column of that file.", std::string("value"));
  return Spec("Quantities", "What is looked at.").entries(spec, 1);
}

}  // namespace

base::Spec study_spec() {
  return Spec("study", "Runs of one scene that are compared: how large the error is, and what it costs.")
      .word("title", "What is studied.", std::string())
      .add(base::include_parameter())
      .word("scene", "File of the scene, its path from the folder of this file. To be given, unless 'studies' are.",
            std::string())
      .words(
          "studies",
          "Files of other studies, their paths from the folder of this file, that are run one after the other instead; "
          "nothing else is then given.",
          base::Texts{})
      .word("refine",
            "Name of the change that refines the mesh, the coarsest value first: along it results are extrapolated and "
            "the order of convergence is found. Empty: none.",
            std::string())
      .integer("jobs", "Cases that run side by side.", 1, Range::between(1, 1024))
      .real("time limit", "s", "After which a case is ended.", 600.0, Range::positive())
      .choice("time",
              "What a case costs: the time that the user waits, or that of all processors, which does not depend on "
              "what else the machine does.",
              {"wall", "processor"}, std::string("wall"))
      .reals("targets", "%", "Errors for which the cheapest setting is looked for; {}: none.",
             base::Reals{5.0, 1.0, 0.2}, Range::positive())
      .real(
          "tolerance", "%",
          "A quantity is right if its error is at most its own error bar and this share of it together; a case that is "
          "wrong, and does not say so, then ends the study with exit status 4. Default: cases are not judged.",
          std::numeric_limits<double>::infinity(), Range::non_negative())
      .list(vary_spec())
      .list(quantities_spec());
}

}  // namespace toile::study
