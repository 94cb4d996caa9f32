#include "toile/garment/garment.hpp"

#include "imperfection.hpp"
#include "layers.hpp"
#include "placement.hpp"
#include "toile/garment/panel.hpp"

namespace toile::garment {

Garment build_garment(const base::List& panels, const base::List* seams, const body::Surface* body) {
  Garment garment;
  const std::vector<base::List> entries = panels.entries();
  const std::vector<Panel> all = build_panels(panels, seams);
  for (std::size_t p = 0; p < all.size(); ++p) {
    mesh::Placed placed = place_panel(entries[p], {all[p].mesh, all[p].drawn, body});
    add_imperfection(entries[p], all[p].mesh, placed);
    mesh::add_panel(garment.mesh, all[p].name, all[p].mesh, placed, all[p].fabrics);
  }
  garment.beneath = read_layers(entries);
  for (const mesh::Block& block : garment.mesh.blocks)
    garment.shells.push_back(all[static_cast<std::size_t>(block.panel)].shell);
  if (seams != nullptr) garment.seams = build_seams(*seams, garment.mesh);
  garment.clusters = build_clusters(garment.mesh.nodes(), garment.seams);
  return garment;
}

}  // namespace toile::garment
