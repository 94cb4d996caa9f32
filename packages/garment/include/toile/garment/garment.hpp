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

/// Meshes, places and sews. `seams` may be null (none); `body` may be null if no panel is wrapped round it.
/// Throws InputError, see build_panel and build_seams; also if the placement fails (axis outside of the body, ...).
Garment build_garment(const base::List& panels, const base::List* seams, const body::Surface* body);

/// Part of the body that the panels of the list "Panels" can touch: between the lowest and the highest of them, with a
/// margin. Nothing if a panel is not wrapped round an axis, or not all round the same one: then it may be all of it.
std::optional<body::Region> reach_of(const base::List& panels);

}  // namespace toile::garment
