#include "toile/solve/spec.hpp"

#include <algorithm>

#include "linear_solver_texts.hpp"
#include "read.hpp"

namespace toile::solve {

namespace {

using base::List;
using base::Range;
using base::Spec;

Spec stage_common(const std::string& name, const std::string& text) {
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

Spec& add_steps(Spec& spec) {
  return spec
      .real("first step", "", "First step of the continuation, as a share of the whole stage.", 0.1,
            {0.0, 1.0, true, false})
      .real("smallest step", "", "Smallest step; if it fails as well, the run ends.", 1e-4, {0.0, 1.0, true, false})
      .real("largest step", "", "Largest step of the continuation.", 0.5, {0.0, 1.0, true, false})
      .integer("most steps", "Number of steps after which the run ends.", 200, Range::at_least(1))
      .choice("stability",
              "When the negative pivots of the tangent are counted, which tell a stable equilibrium from an unstable "
              "one and mark limit points and bifurcations.",
              {"at the end", "every step"}, std::string("at the end"));
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

}  // namespace

Spec stages_spec() {
  Spec sew = stage_common("sew", "Closes the seams step by step.");
  Spec load = stage_common("load", "Moves the supports and applies the loads step by step.");
  load.real("target", "", "Load factor at the end of the stage; 1: the full displacements and loads.", 1.0)
      .choice("continuation",
              "natural: step by step in the load. arc length: along the path of equilibria, through limit points where "
              "the load turns back, until the load first reaches \"target\"; steps are arc lengths, scaled so that the "
              "first is \"first step\" of the load. Without body and damping only.",
              {"natural", "arc length"}, std::string("natural"));
  for (Spec* spec : {&sew, &load}) add_steps(*spec).list(damping_spec());
  load.list(until_spec());
  Spec settle = stage_common("settle", "Finds the equilibrium at fixed seams, supports and loads.");
  settle.list(damping_spec());
  Spec stage("stage", "One stage of the run.");
  stage.variant("type", "What happens in the stage.", {sew, load, settle});
  return Spec("Stages", "What happens to the garment, in this order.").entries(stage, 1);
}

std::vector<StageOptions> read_stages(const List& list) {
  std::vector<StageOptions> stages;
  for (const List& entry : list.entries()) {
    StageOptions s;
    s.name = entry.name();
    const std::string& type = entry.word("type");
    s.type = type == "sew" ? StageType::sew : type == "load" ? StageType::load : StageType::settle;
    s.released = entry.words("release");
    s.most_time = entry.real("most time");
    s.most_iterations = entry.integer("most iterations in all");
    if (s.type == StageType::load) {
      s.target = entry.real("target");
      s.arc_length = entry.word("continuation") == "arc length";
      if (entry.has_list("Until")) s.until = read_until(entry.list("Until"));
      if (s.until && !s.arc_length)
        entry.fail("continuation", "must be \"arc length\" in a stage with a list \"Until\"");
    }
    if (s.type != StageType::settle) {
      s.first_step = entry.real("first step");
      s.smallest_step = entry.real("smallest step");
      s.largest_step = entry.real("largest step");
      s.max_steps = entry.integer("most steps");
      s.stability_every_step = s.arc_length || entry.word("stability") == "every step";
      if (s.smallest_step > s.first_step)
        entry.fail("smallest step", "must not be larger than \"first step\" (" + std::to_string(s.first_step) + ")");
    }
    if (entry.has_list("Damping")) {
      const List damping = entry.list("Damping");
      s.damping = {true, damping.real("fraction"), damping.real("limit")};
      if (s.arc_length)
        entry.fail("continuation",
                   "must be \"natural\" in a stage with a list \"Damping\": arc length continuation follows undamped "
                   "equilibria, unstable ones too. Leave out one of them");
    }
    stages.push_back(s);
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
      .real("tolerance", "", "Force residual over the nodal forces that meet in it.", 1e-10, {0.0, 1.0, true, true})
      .real("gap tolerance", "mm", "Largest gap of a node in contact.", 1e-6, Range::positive())
      .integer("most iterations", "Newton iterations of a step before it is cut back.", 60, Range::at_least(1))
      .real("most time", "s", "Time after which the run ends where it is, with its last converged state; 0: no limit.",
            0.0, Range::at_least(0));
}

SolverOptions read_solver(const List& list) {
  SolverOptions o;
  o.linear.method = list.word("linear solver");
  o.linear.tolerance = list.real("linear tolerance");
  o.linear.kept_iterations = list.integer("kept iterations");
  o.newton.tolerance = list.real("tolerance");
  o.newton.gap_tolerance = list.real("gap tolerance");
  o.newton.max_iterations = list.integer("most iterations");
  o.most_time = list.real("most time");
  return o;
}

Spec contact_spec() {
  return Spec("Contact",
              "Frictionless contact of the garment with the body; left out, a scene with a body has it with the "
              "defaults.")
      .choice("contact surface",
              "inner face: half the current thickness inside the mid-surface; mid-surface: as membrane theory has it.",
              {"inner face", "mid-surface"}, std::string("inner face"))
      .choice("pressure area",
              "Current area that the written pressure (and the field area) refers to: of the mid-surface, or of the "
              "inner face, half the current thickness nearer to the body.",
              {"mid-surface", "inner face"}, std::string("mid-surface"))
      .real("relative stiffness", "",
            "Augmentation over the mean diagonal of the tangent; steers the iteration, not the result.", 1.0,
            Range::positive());
}

ContactOptions read_contact(const List& list) {
  return {list.word("contact surface") == "inner face", list.word("pressure area") == "inner face",
          list.real("relative stiffness")};
}

Spec loads_spec() {
  Spec edge("edge", "Force along an edge that keeps its direction.");
  edge.word("on", "Name of an edge, for instance front.top.")
      .reals("traction", "N/mm", "Force per length of the pattern's edge at load 1 (x, y, z).");
  Spec point("point", "Force on each named node that keeps its direction.");
  point.word("on", "Name of a corner (front.top-left), a place on an edge (front.top@0.5) or an edge.")
      .reals("force", "N", "Force at load 1 (x, y, z).");
  Spec moment("edge moment", "Moment along an edge of shells, about an axis that keeps its direction.");
  moment.word("on", "Name of an edge, for instance front.top.")
      .reals("moment", "N mm/mm", "Moment per length of the pattern's edge at load 1 (x, y, z).");
  Spec pressure("pressure", "Pressure that follows the panel: on its current area, along its current normal.");
  pressure.word("on", "Name of a panel.")
      .real("pressure", "MPa",
            "At load 1; positive: towards the side from which the pattern's x and y run counter-clockwise.");
  Spec load("load", "One load.");
  load.variant("type", "Kind of load.", {edge, point, moment, pressure}, std::string("edge"));
  return Spec("Loads", "Forces on the garment.").entries(load);
}

namespace {

/// Length of the pattern's edge that belongs to each of its nodes, mm.
std::vector<double> nodal_lengths(const mesh::Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<double> lengths(nodes.size(), 0.0);
  for (size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double half = 0.5 * (mesh.pattern[nodes[i + 1]] - mesh.pattern[nodes[i]]).norm();
    lengths[i] += half;
    lengths[i + 1] += half;
  }
  return lengths;
}

/// One for each block of the panel.
std::vector<FollowerPressure> read_pressure(const List& entry, const mesh::Mesh& mesh) {
  std::vector<FollowerPressure> pressures;
  for (size_t b = 0; b < mesh.blocks.size(); ++b)
    if (mesh.panel_of(mesh.blocks[b]).name == entry.word("on"))
      pressures.push_back({entry.name(), static_cast<int>(b), entry.real("pressure")});
  if (!pressures.empty()) return pressures;
  base::Texts names;
  for (const mesh::MeshedPanel& panel : mesh.panels) names.push_back(panel.name);
  entry.fail("on", "no panel is named \"" + entry.word("on") + "\"" + base::hint(entry.word("on"), names));
}

NodalLoad read_nodal_load(const List& entry, const mesh::Mesh& mesh) {
  const std::string& type = entry.word("type");
  NodalLoad load;
  load.name = entry.name();
  load.nodes = read_nodes(entry, mesh, entry.word("on"));
  load.moment = type == "edge moment";
  load.value = read_vector(entry, type == "edge" ? "traction" : type == "point" ? "force" : "moment");
  if (type == "point")
    load.share.assign(load.nodes.size(), 1.0);
  else if (load.nodes.size() < 2)
    entry.fail("on", "\"" + entry.word("on") + "\" is a single node; a load per length needs an edge");
  else
    load.share = nodal_lengths(mesh, load.nodes);
  return load;
}

}  // namespace

Loads read_loads(const List& list, const mesh::Mesh& mesh) {
  Loads loads;
  for (const List& entry : list.entries())
    if (entry.word("type") == "pressure")
      for (const FollowerPressure& pressure : read_pressure(entry, mesh)) loads.pressures.push_back(pressure);
    else
      loads.nodal.push_back(read_nodal_load(entry, mesh));
  return loads;
}

}  // namespace toile::solve
