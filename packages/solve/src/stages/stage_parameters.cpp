#include "stages/stage_parameters.hpp"

namespace toile::solve {

using base::List;
using base::Range;
using base::Spec;

Spec stage_spec(const std::string& name, const std::string& text) {
  return Spec(name, text)
      .words("release", "Names of supports that end with the start of this stage.", base::Texts{})
      .real(
          "most time", "s",
          "Time after which the stage ends where it is, with its last converged state; 0: no limit. See also the list "
          "\"Solver\".",
          0.0, Range::at_least(0))
      .integer(
          "most iterations in all",
          "Newton iterations of all steps, failed attempts and the search for the final state included, after which "
          "the stage ends where it is.",
          5000, Range::at_least(1));
}

void read_stage(const List& list, StageOptions& stage) {
  stage.released = list.words("release");
  stage.most_time = list.real("most time");
  stage.most_iterations = list.integer("most iterations in all");
}

void add_steps(Spec& spec) {
  spec.real("first step", "", "First step of the continuation, as a share of the whole stage.", 0.1,
            {0.0, 1.0, true, false})
      .real("smallest step", "", "Smallest step; if it fails as well, the run ends.", 1e-4, {0.0, 1.0, true, false})
      .real("largest step", "", "Largest step of the continuation.", 0.5, {0.0, 1.0, true, false})
      .integer("most steps", "Number of steps after which the run ends.", 200, Range::at_least(1))
      .choice("stability",
              "When the negative pivots of the tangent are counted, which tell a stable equilibrium from an unstable "
              "one and mark limit points and bifurcations.",
              {"at the end", "every step"}, std::string("at the end"));
}

void read_steps(const List& list, StageOptions& stage) {
  stage.first_step = list.real("first step");
  stage.smallest_step = list.real("smallest step");
  stage.largest_step = list.real("largest step");
  stage.max_steps = list.integer("most steps");
  stage.stability_every_step = list.word("stability") == "every step";
  if (stage.smallest_step > stage.first_step)
    list.fail("smallest step", "must not be larger than \"first step\" (" + std::to_string(stage.first_step) + ")");
}

Spec damping_spec() {
  return Spec("Damping",
              "Artificial viscous damping of the stage (left out: none). It is zero in the stage's final state.")
      .real("fraction", "",
            "Energy that a step dissipates over the strain energy: of the first step over its own, later over the "
            "largest so far (the damping then changes by no more than a factor of 5 a step). Where the first step "
            "stores next to nothing, its damping is 1e-4 of the mean stiffness instead.",
            2e-4, Range::positive())
      .real("limit", "",
            "Accumulated dissipation over the largest strain energy above which the path is reported as "
            "not quasi-static.",
            0.05, Range::positive());
}

void read_damping(const List& list, StageOptions& stage) {
  if (!list.has_list("Damping")) return;
  const List damping = list.list("Damping");
  stage.damping = {true, damping.real("fraction"), damping.real("limit")};
}

}  // namespace toile::solve
