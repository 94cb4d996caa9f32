#include "toile/solve/spec.hpp"

#include <algorithm>

#include "input/read.hpp"
#include "linear/linear_solver_texts.hpp"
#include "toile/contact/laws.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

using base::List;
using base::Range;
using base::Spec;

Spec stages_spec() {
  std::vector<Spec> kinds;
  for (const StageKind* kind : stage_kinds()) kinds.push_back(kind->spec());
  Spec stage("stage", "One stage of the run.");
  stage.variant("type", "What happens in the stage.", kinds);
  return Spec("Stages", "What happens to the garment, in this order.").entries(stage, 1);
}

std::vector<StageOptions> read_stages(const List& list) {
  std::vector<StageOptions> stages;
  for (const List& entry : list.entries()) {
    StageOptions& stage = stages.emplace_back();
    stage.name = entry.name();
    stage.kind = &stage_kind(entry.word("type"));
    stage.kind->read(entry, stage);
  }
  return stages;
}

Spec solver_spec() {
  std::vector<std::string> names;
  std::string text;
  for (const auto& [name, what] : linear_solver_texts()) {
    text += (text.empty() ? "" : "; ") + name + ": " + what;
    names.push_back(name);
  }
  return Spec("Solver", "How the equations are solved; the defaults suit most scenes.")
      .choice("linear solver", text + ".", names, names.front())
      .real("linear tolerance", "", "Relative residual of the linear iteration.", 1e-10, {0.0, 1.0, true, true})
      .integer("kept iterations", "A kept factorisation that needs more iterations is renewed.", 12, Range::at_least(1))
      .flag("condition number",
            "Whether the condition number of the tangent is told (figures.csv, the step table): the largest over the "
            "smallest magnitude of its eigenvalues, in N, mm and radians, wherever its negative pivots are counted. It "
            "takes some tens of solutions.",
            false)
      .real("tolerance", "", "Force residual over the nodal forces that meet in it.", 1e-10, {0.0, 1.0, true, true})
      .real("gap tolerance", "mm", "Largest gap of a node in contact.", 1e-6, Range::positive())
      .integer("most iterations",
               "Newton iterations of a step before it is cut back. At the undamped end of a stage, where nothing can "
               "be cut back, up to five times as many as long as the residual halves in every third of them.",
               60, Range::at_least(1))
      .real("most time", "s", "Time after which the run ends where it is, with its last converged state; 0: no limit.",
            0.0, Range::at_least(0));
}

SolverOptions read_solver(const List& list) {
  SolverOptions o;
  o.linear.method = list.word("linear solver");
  o.linear.tolerance = list.real("linear tolerance");
  o.linear.kept_iterations = list.integer("kept iterations");
  o.linear.condition = list.flag("condition number");
  o.newton.tolerance = list.real("tolerance");
  o.newton.gap_tolerance = list.real("gap tolerance");
  o.newton.max_iterations = list.integer("most iterations");
  o.most_time = list.real("most time");
  return o;
}

Spec contact_spec() {
  Spec spec("Contact", "Contact of the garment with the body; left out, a scene with a body has it with the defaults.");
  contact::add_law(spec);
  return spec
      .choice("contact surface",
              "inner face: half the current thickness inside the mid-surface; mid-surface: as membrane theory has it.",
              {"inner face", "mid-surface"}, std::string("inner face"))
      .choice("pressure area",
              "Current area that the written pressure (and the field area) refers to: of the mid-surface, or of the "
              "inner face, half the current thickness nearer to the body; of panels that lie over others, of the body "
              "below them.",
              {"mid-surface", "inner face"}, std::string("mid-surface"))
      .real("relative stiffness", "",
            "Augmentation over the mean diagonal of the tangent; steers the iteration, not the result.", 1.0,
            Range::positive());
}

ContactOptions read_contact(const List& list) {
  return {list.word("contact surface") == "inner face", list.word("pressure area") == "inner face",
          list.real("relative stiffness"), contact::make_law(list)};
}

}  // namespace toile::solve
