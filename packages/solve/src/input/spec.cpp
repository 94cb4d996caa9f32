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
              "inner face, half the current thickness nearer to the body.",
              {"mid-surface", "inner face"}, std::string("mid-surface"))
      .real("relative stiffness", "",
            "Augmentation over the mean diagonal of the tangent; steers the iteration, not the result.", 1.0,
            Range::positive());
}

ContactOptions read_contact(const List& list) {
  return {list.word("contact surface") == "inner face", list.word("pressure area") == "inner face",
          list.real("relative stiffness"), contact::make_law(list)};
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
