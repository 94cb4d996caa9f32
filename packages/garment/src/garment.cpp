#include "toile/garment/garment.hpp"

#include <algorithm>
#include <map>

#include "imperfection.hpp"
#include "layers.hpp"
#include "placement.hpp"
#include "toile/base/error.hpp"

namespace toile::garment {

namespace {

/// What a block of the mesh is to who wrote the scene.
std::string part_text(const mesh::Mesh& mesh, const std::vector<Panel>& panels, const mesh::Block& block) {
  const std::string& panel = mesh.panels[static_cast<std::size_t>(block.panel)].name;
  if (block.name == panel) return "panel \"" + panel + "\"";
  const std::string rest = block.name.substr(panel.size() + 1);
  const bool is_zone = panels[static_cast<std::size_t>(block.panel)].fabrics.count(rest) > 0;
  return (is_zone ? "zone \"" + rest + "\"" : "part \"" + rest + "\"") + " of panel \"" + panel + "\"";
}

/// Results name each part of a panel by the panel, a hyphen and the part.
void check_names(const base::List& list, const mesh::Mesh& mesh, const std::vector<Panel>& panels) {
  std::map<std::string, const mesh::Block*> taken;
  for (const mesh::Block& block : mesh.blocks) {
    const auto [place, is_new] = taken.emplace(block.name, &block);
    if (is_new) continue;
    throw base::InputError(list.file() + ": " + list.path() + ": " + part_text(mesh, panels, *place->second) + " and " +
                           part_text(mesh, panels, block) + " would both be named \"" + block.name +
                           "\" in the results; rename one of them");
  }
}

}  // namespace

CutGarment cut_garment(const base::List& panels, const base::List* seams) {
  CutGarment cut;
  cut.panels = build_panels(panels, seams);
  Garment& garment = cut.garment;
  for (const Panel& panel : cut.panels) {
    const std::vector<mesh::Vec3> nowhere(panel.mesh.nodes.size(), mesh::Vec3::Zero());
    mesh::add_panel(garment.mesh, panel.name, panel.mesh, {nowhere, nowhere}, panel.fabrics);
  }
  check_names(panels, garment.mesh, cut.panels);
  garment.beneath = read_layers(panels.entries());
  for (const mesh::Block& block : garment.mesh.blocks)
    garment.shells.push_back(cut.panels[static_cast<std::size_t>(block.panel)].shell);
  if (seams != nullptr) garment.seams = build_seams(*seams, garment.mesh);
  garment.clusters = build_clusters(garment.mesh.nodes(), garment.seams);
  return cut;
}

Garment place_garment(CutGarment cut, const base::List& panels, const body::Surface* body) {
  mesh::Mesh& mesh = cut.garment.mesh;
  const std::vector<base::List> entries = panels.entries();
  for (std::size_t p = 0; p < cut.panels.size(); ++p) {
    const Panel& panel = cut.panels[p];
    mesh::Placed placed = place_panel(entries[p], {panel.mesh, panel.drawn, body});
    add_imperfection(entries[p], panel.mesh, placed);
    const auto put = [first = mesh.panels[p].first](const std::vector<mesh::Vec3>& from, std::vector<mesh::Vec3>& to) {
      std::copy(from.begin(), from.end(), to.begin() + first);
    };
    put(placed.position, mesh.placed);
    put(placed.normal, mesh.normal);
    put(placed.axis, mesh.axis);
  }
  return std::move(cut.garment);
}

Garment build_garment(const base::List& panels, const base::List* seams, const body::Surface* body) {
  return place_garment(cut_garment(panels, seams), panels, body);
}

}  // namespace toile::garment
