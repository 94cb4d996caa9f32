// Forces on the garment.
#include <algorithm>
#include <utility>

#include "input/read.hpp"
#include "terms/pattern_areas.hpp"
#include "toile/mesh/find_nodes.hpp"
#include "toile/solve/spec.hpp"

namespace toile::solve {

using base::List;
using base::Range;
using base::Spec;

Spec loads_spec() {
  Spec edge("edge", "Force along an edge that keeps its direction.");
  edge.word("on", "Name of an edge or a part of one, for instance front.top or front.top[20mm:50mm].")
      .reals("traction", "N/mm", "Force per length of the pattern's edge at load 1 (x, y, z).");
  Spec point("point", "Force on one node that keeps its direction.");
  point.word("on", "Name of a corner (front.top-left), or a place on an edge (front.top@0.5) or in a panel.")
      .reals("force", "N", "Force at load 1 (x, y, z).");
  Spec moment("edge moment", "Moment along an edge of shells, about an axis that keeps its direction.");
  moment.word("on", "Name of an edge or a part of one, for instance front.top or front.top[20mm:50mm].")
      .reals("moment", "N mm/mm", "Moment per length of the pattern's edge at load 1 (x, y, z).");
  Spec pressure("pressure", "Pressure that follows the panel: on its current area, along its current normal.");
  pressure.word("on", "Name of a panel.")
      .real("pressure", "MPa",
            "At load 1; positive: towards the side from which the pattern's x and y run counter-clockwise.");
  Spec weight("weight", "Weight of the fabric. A stage of type load puts it on.");
  weight.words("on", "Names of panels; {}: all.", base::Texts())
      .real("area density", "g/m^2", "Mass of the flat fabric per area: a light T-shirt has 150.", base::required,
            Range::positive())
      .reals("direction", "", "Where it falls; its length does not count.", base::Reals{0.0, 0.0, -1.0});
  Spec load("load", "One load.");
  load.variant("type", "Kind of load.", {edge, point, moment, pressure, weight}, std::string("edge"));
  return Spec("Loads", "Forces on the garment.").entries(load);
}

namespace {

/// Of the panel that parameter "on" of the entry calls `name`. Throws base::InputError.
std::vector<int> blocks_of(const List& entry, const mesh::Mesh& mesh, const std::string& name) {
  std::vector<int> blocks;
  for (size_t b = 0; b < mesh.blocks.size(); ++b)
    if (mesh.panel_of(mesh.blocks[b]).name == name) blocks.push_back(static_cast<int>(b));
  if (!blocks.empty()) return blocks;
  base::Texts names;
  for (const mesh::MeshedPanel& panel : mesh.panels) names.push_back(panel.name);
  entry.fail("on", "no panel is named \"" + name + "\"" + base::hint(name, names));
}

/// One for each block of the panel.
std::vector<FollowerPressure> read_pressure(const List& entry, const mesh::Mesh& mesh) {
  std::vector<FollowerPressure> pressures;
  for (const int block : blocks_of(entry, mesh, entry.word("on")))
    pressures.push_back({entry.name(), block, entry.real("pressure")});
  return pressures;
}

NodalLoad read_weight(const List& entry, const mesh::Mesh& mesh) {
  constexpr double gravity = 9.80665, mm2_in_m2 = 1e6, g_in_kg = 1e3;
  const Vec3 direction = read_vector(entry, "direction");
  if (direction.isZero()) entry.fail("direction", "has no length");
  base::Texts names = entry.words("on");
  for (const std::string& name : names)
    if (std::count(names.begin(), names.end(), name) > 1)
      entry.fail("on", "names panel \"" + name + "\" twice, and its weight would count twice");
  if (names.empty())
    for (const mesh::MeshedPanel& panel : mesh.panels) names.push_back(panel.name);
  std::vector<double> area(mesh.nodes(), 0.0);
  for (const std::string& name : names)
    for (const int b : blocks_of(entry, mesh, name)) {
      const mesh::Block& block = mesh.blocks[b];
      const std::vector<double> own = pattern_areas(mesh, block);
      for (size_t i = 0; i < own.size(); ++i) area[block.connectivity[i]] += own[i];
    }
  NodalLoad load;
  load.name = entry.name();
  load.value = entry.real("area density") * gravity / (g_in_kg * mm2_in_m2) * direction.normalized();
  for (size_t i = 0; i < area.size(); ++i)
    if (area[i] > 0.0) {
      load.nodes.push_back(static_cast<int>(i));
      load.share.push_back(area[i]);
    }
  return load;
}

NodalLoad read_nodal_load(const List& entry, const mesh::Mesh& mesh) {
  const std::string& type = entry.word("type");
  NodalLoad load;
  load.name = entry.name();
  load.nodes = read_nodes(entry, mesh, entry.word("on"));
  load.moment = type == "edge moment";
  load.value = read_vector(entry, type == "edge" ? "traction" : type == "point" ? "force" : "moment");
  const std::string& on = entry.word("on");
  const auto called = [&on](const mesh::MeshedPanel& panel) { return panel.name == on; };
  if (type == "point" && load.nodes.size() > 1)
    entry.fail("on",
               "\"" + on + "\" has " + std::to_string(load.nodes.size()) +
                   " nodes, as many as the mesh has there, and each would get the force: name a corner or a place "
                   "on an edge, or give a load of type \"edge\" its force per length");
  if (type == "point") {
    load.share = {1.0};
  } else if (std::any_of(mesh.panels.begin(), mesh.panels.end(), called)) {
    entry.fail("on", "\"" + on + "\" is a panel; a load per length needs an edge of it, as " + on + ".top");
  } else if (load.nodes.size() < 2) {
    entry.fail("on", "\"" + on + "\" is a single node; a load per length needs an edge");
  } else {
    mesh::EdgeLengths edge = mesh::edge_lengths(mesh, on);
    load.nodes = std::move(edge.nodes);
    load.share = std::move(edge.lengths);
  }
  return load;
}

}  // namespace

Loads read_loads(const List& list, const mesh::Mesh& mesh) {
  Loads loads;
  for (const List& entry : list.entries())
    if (entry.word("type") == "pressure")
      for (const FollowerPressure& pressure : read_pressure(entry, mesh)) loads.pressures.push_back(pressure);
    else if (entry.word("type") == "weight")
      loads.nodal.push_back(read_weight(entry, mesh));
    else
      loads.nodal.push_back(read_nodal_load(entry, mesh));
  return loads;
}

}  // namespace toile::solve
