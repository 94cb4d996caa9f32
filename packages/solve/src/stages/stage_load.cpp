#include "stages/stage_parameters.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

namespace {

using base::List;
using base::Spec;

Spec until_spec() {
  Spec displacement("displacement", "Of a node from where it is placed.");
  displacement.word("on", "Name of a corner (front.top-left) or of a place (front.top@0.5).")
      .choice("direction", "Component of the displacement.", {"x", "y", "z"})
      .real("value", "mm", "At which the stage ends.");
  Spec reaction("reaction", "Force of a support on the garment.");
  reaction.word("on", "Name of the support.")
      .choice("direction", "Component of the force.", {"x", "y", "z"})
      .real("value", "N", "At which the stage ends.");
  Spec volume("volume",
              "Volume that all panels under pressure have swept along their normals since they were placed: of a "
              "closed part, or one whose edges are held or slide in planes, the change of what it encloses.");
  volume.real("value", "mm^3", "At which the stage ends.");
  Spec until("Until",
             "Of arc length: the stage ends where the quantity first has the value, on falling branches too, instead "
             "of where the load first reaches \"target\" (which then only scales the steps). Left out: the load.");
  until.variant("quantity", "What ends the stage.", {displacement, reaction, volume}, std::string("displacement"));
  return until;
}

PathTarget read_until(const List& until) {
  PathTarget target;
  target.value = until.real("value");
  target.volume = until.word("quantity") == "volume";
  if (target.volume) return target;
  target.on = until.word("on");
  target.direction = until.word("direction")[0] - 'x';
  if (until.word("quantity") == "reaction") target.support = 0;
  return target;
}

class Load : public StageKind {
 public:
  const char* name() const override { return "load"; }
  Spec spec() const override;
  void read(const List& list, StageOptions& stage) const override;
  Drive drive(const StageOptions& stage, const State& start) const override {
    return {start.seam, start.seam, start.load, stage.target};
  }
  bool changes_load() const override { return true; }
};

Spec Load::spec() const {
  Spec load = stage_spec(name(), "Moves the supports and applies the loads step by step.");
  load.real("target", "", "Load factor at the end of the stage; 1: the full displacements and loads.", 1.0)
      .choice("continuation",
              "natural: step by step in the load. arc length: along the path of equilibria, through limit points where "
              "the load turns back, until the load first reaches \"target\"; steps are arc lengths, scaled so that the "
              "first is \"first step\" of the load. Without body and damping only.",
              {"natural", "arc length"}, std::string("natural"));
  add_steps(load);
  return load.list(damping_spec()).list(until_spec());
}

void Load::read(const List& list, StageOptions& stage) const {
  read_stage(list, stage);
  stage.target = list.real("target");
  stage.arc_length = list.word("continuation") == "arc length";
  if (list.has_list("Until")) stage.until = read_until(list.list("Until"));
  if (stage.until && !stage.arc_length)
    list.fail("continuation", "must be \"arc length\" in a stage with a list \"Until\"");
  read_steps(list, stage);
  stage.stability_every_step = stage.stability_every_step || stage.arc_length;
  read_damping(list, stage);
  if (stage.arc_length && stage.damping.active)
    list.fail("continuation",
              "must be \"natural\" in a stage with a list \"Damping\": arc length continuation follows undamped "
              "equilibria, unstable ones too. Leave out one of them");
}

}  // namespace

const StageKind& load_stage() {
  static const Load kind;
  return kind;
}

}  // namespace toile::solve
