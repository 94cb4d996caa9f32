#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/body.hpp"
#include "toile/garment/panel.hpp"
#include "toile/garment/seam.hpp"
#include "toile/garment/shell.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::garment {

/// Everything that the lists "Panels" and "Seams" describe; the same on every rank.
struct Garment {
  mesh::Mesh mesh;  ///< panels in the order of the file
  std::vector<Seam> seams;
  Clusters clusters;
  std::vector<std::optional<ShellOptions>> shells;  ///< [block] none: a membrane
  std::vector<std::vector<int>> beneath;            ///< as solve::Problem::beneath: panels between one and the body
};

/// A garment that is meshed and sewn, and lies nowhere in space yet: what does not need the body.
struct CutGarment {
  Garment garment;
  std::vector<Panel> panels;
};

/// Meshes and sews. `seams` may be null (none). Throws InputError, see build_panels and build_seams.
CutGarment cut_garment(const base::List& panels, const base::List* seams);

/// Places it. `panels`: as it was cut from; `body` may be null if no panel is wrapped round it. Throws InputError if
/// the placement fails (axis outside of the body, ...).
Garment place_garment(CutGarment cut, const base::List& panels, const body::Surface* body);

/// Both.
Garment build_garment(const base::List& panels, const base::List* seams, const body::Surface* body);

/// Part of the body that the panels of the list "Panels" can touch: between the lowest and the highest of them, with a
/// margin. Nothing if a panel is not wrapped round an axis, or not all round the same one: then it may be all of it.
std::optional<body::Region> reach_of(const base::List& panels);

}  // namespace toile::garment
