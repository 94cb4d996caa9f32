#include "toile/mesh/panel_mesh.hpp"

#include <algorithm>
#include <cassert>

namespace toile::mesh {
namespace {

std::string block_name(const Mesh& mesh, const std::string& panel, const PanelMesh& all, const PanelPart& part) {
  if (all.parts.size() == 1) return panel;
  std::string name = panel + (part.zone.empty() ? "" : "-" + part.zone);
  const auto is_taken = [&](const Block& block) { return block.name == name; };
  if (std::any_of(mesh.blocks.begin(), mesh.blocks.end(), is_taken)) name += "-triangles";
  return name;
}

Block make_block(const PanelMesh& panel, const PanelPart& part, double bottom, double top) {
  Block block;
  block.nodes_per_element = part.nodes_per_element;
  block.connectivity = part.connectivity;
  for (int e = 0; e < block.size(); ++e) {
    double y = 0.0;
    for (int k = 0; k < block.nodes_per_element; ++k)
      y += panel.nodes[block.connectivity[e * block.nodes_per_element + k]].y() / block.nodes_per_element;
    block.position.push_back((y - bottom) / (top - bottom));
  }
  return block;
}

}  // namespace

std::vector<bool> on_edges(const PanelMesh& panel) {
  std::vector<bool> found(panel.nodes.size(), false);
  for (const auto& [name, nodes] : panel.edges)
    for (const int node : nodes) found[static_cast<std::size_t>(node)] = true;
  return found;
}

void add_panel(Mesh& mesh, const std::string& name, const PanelMesh& panel, const Placed& placed,
               const std::map<std::string, ZoneFabric>& fabrics) {
  assert(placed.position.size() == panel.nodes.size() && placed.normal.size() == panel.nodes.size());
  const int first = mesh.nodes();
  mesh.pattern.insert(mesh.pattern.end(), panel.nodes.begin(), panel.nodes.end());
  mesh.placed.insert(mesh.placed.end(), placed.position.begin(), placed.position.end());
  mesh.normal.insert(mesh.normal.end(), placed.normal.begin(), placed.normal.end());
  mesh.axis.insert(mesh.axis.end(), placed.axis.begin(), placed.axis.end());
  mesh.axis.resize(mesh.placed.size(), Vec3::Zero());
  mesh.panels.push_back({name, first, static_cast<int>(panel.nodes.size()), panel.across, panel.notches});
  for (Notch& notch : mesh.panels.back().notches) notch.node += first;

  const auto [low, high] = std::minmax_element(panel.nodes.begin(), panel.nodes.end(),
                                               [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  for (const PanelPart& part : panel.parts) {
    Block block = make_block(panel, part, low->y(), high->y());
    block.name = block_name(mesh, name, panel, part);
    block.panel = static_cast<int>(mesh.panels.size()) - 1;
    const ZoneFabric& fabric = fabrics.at(part.zone);
    block.material = fabric.material;
    block.wale_angle.assign(static_cast<std::size_t>(block.size()), fabric.wale_angle);
    for (int& node : block.connectivity) node += first;
    mesh.blocks.push_back(std::move(block));
  }
  for (const auto& [edge, nodes] : panel.edges) {
    std::vector<int>& numbered = mesh.edges[name + "." + edge];
    for (const int node : nodes) numbered.push_back(node + first);
  }
}

}  // namespace toile::mesh
