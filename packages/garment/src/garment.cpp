#include "toile/garment/garment.hpp"

#include <algorithm>

#include "imperfection.hpp"
#include "layers.hpp"
#include "placement.hpp"

namespace toile::garment {

CutGarment cut_garment(const base::List& panels, const base::List* seams) {
  CutGarment cut;
  cut.panels = build_panels(panels, seams);
  Garment& garment = cut.garment;
  for (const Panel& panel : cut.panels) {
    const std::vector<mesh::Vec3> nowhere(panel.mesh.nodes.size(), mesh::Vec3::Zero());
    mesh::add_panel(garment.mesh, panel.name, panel.mesh, {nowhere, nowhere}, panel.fabrics);
  }
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
