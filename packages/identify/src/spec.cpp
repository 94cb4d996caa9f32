#include "toile/identify/spec.hpp"

#include <limits>

#include "toile/identify/curve.hpp"
#include "toile/material/formula.hpp"
#include "toile/material/given_values.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::identify {
namespace {

using base::Range;
using base::Spec;

constexpr double unbounded = std::numeric_limits<double>::infinity();

Spec free_spec() {
  Spec spec("parameter", "A parameter of the material that the data determine; the list has the parameter's name.");
  spec.real("lower", "", "Least value, in the parameter's unit; default: the least that the material allows.",
            -unbounded)
      .real("upper", "", "Greatest value; default: the greatest that the material allows.", unbounded)
      .choice("scale", "How the search divides the interval; logarithmic needs a positive lower bound.",
              {"linear", "logarithmic"}, std::string("linear"));
  return Spec("Free",
              "The parameters to be found. A value that the material gives them as well is one of the first candidates "
              "and must be within the bounds; one of its set or a default is moved into them.")
      .entries(spec, 1);
}

Spec constraints_spec() {
  Spec spec("constraint", "factors . parameters <= at most, for instance that weights sum to at most one.");
  spec.words("parameters", "Names of parameters.")
      .reals("factors", "", "One for each; empty: all 1.", base::Reals{})
      .real("at most", "", "Bound of the sum.");
  return Spec("Constraints",
              "Linear conditions between parameters. Those of the material itself always hold: the "
              "search keeps to them; a condition that is written here as well guides the polish too.")
      .entries(spec);
}

Spec algorithm_spec() {
  Spec spec("Algorithm", "Global search, then a gradient polish with the exact derivatives of the law.");
  spec.choice("search", "Global search of pagmo: self-adaptive differential evolution (sade), or sga.",
              {"differential evolution", "genetic algorithm"}, std::string("differential evolution"))
      .integer("population", "Candidates; for the genetic algorithm an even number.", 60, Range::between(8, 100000))
      .integer("generations", "Generations of each start; 0: only the polish of the best first candidate.", 400,
               Range::at_least(0))
      .integer("starts", "Independent searches; the best one is the result, all are reported.", 3, Range::at_least(1))
      .integer("seed", "Seed of the first start; the same seed gives the same result.", 1, Range::at_least(0))
      .flag("polish", "Whether the best candidate of each start is polished (damped Gauss-Newton steps).", true)
      .flag("keep tangent positive",
            "true: the nominal stress of every fitted curve must rise from each of its stretches to the next.", false);
  return spec;
}

}  // namespace

Spec fit_spec(const material::Laws& laws) {
  return Spec("fit", "Identification of a material's parameters from tests of the fabric.")
      .word("title", "What is fitted.", std::string())
      .add(base::include_parameter())
      .list(material::plugins_spec())
      .list(material::formulas_spec())
      .list(Spec("Material",
                 "The fabric: one entry, as in the list Materials of a scene. Parameters in Free need no "
                 "value.")
                .entries(material::fitted_material_spec(laws), 1),
            true)
      .list(free_spec(), true)
      .list(constraints_spec())
      .list(Spec("Data", "The measured curves, by name.").entries(curve_spec(), 1), true)
      .list(algorithm_spec(), true)
      .list(Spec("Output", "What is written.")
                .word("folder", "Folder of the results; empty: results/ and the name of this file.", std::string()));
}

Algorithm::Algorithm(const base::List& list)
    : genetic(list.word("search") == "genetic algorithm"),
      population(list.integer("population")),
      generations(list.integer("generations")),
      starts(list.integer("starts")),
      seed(static_cast<unsigned>(list.integer("seed"))),
      polish(list.flag("polish")) {
  if (genetic && population % 2 != 0) list.fail("population", "must be even: the genetic algorithm pairs candidates");
}

}  // namespace toile::identify
