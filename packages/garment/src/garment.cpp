#include "toile/garment/garment.hpp"

#include "imperfection.hpp"
#include "placement.hpp"

namespace toile::garment {

Garment build_garment(const base::List& panels, const base::List* seams, const body::Surface* body) {
  Garment garment;
  for (const base::List& entry : panels.entries()) {
    const Panel panel = build_panel(entry);
    mesh::Placed placed = place_panel(entry, panel.grid, body);
    add_imperfection(entry, panel.grid, placed);
    mesh::add_panel(garment.mesh, panel.name, panel.material, panel.grid, placed, panel.wale_angle);
    garment.materials.push_back(panel.material);
    garment.shells.push_back(panel.shell);
  }
  if (seams != nullptr) garment.seams = build_seams(*seams, garment.mesh);
  garment.clusters = build_clusters(garment.mesh.nodes(), garment.seams);
  return garment;
}

}  // namespace toile::garment
