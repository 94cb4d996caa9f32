#pragma once

#include <string>

#include "toile/body/body.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// How a body file is read and what is demanded of it.
struct ImportOptions {
  double scale = 1.0;               ///< mm per unit of the file
  double least_height = 300.0;      ///< mm, after scaling; a person or a leg in centimetres is below
  double greatest_height = 3000.0;  ///< mm
  bool closed = true;               ///< a border is an error
  bool repair_orientation = false;  ///< turn inside-out bodies instead of refusing them
};

/// A body as it came out of a file.
struct Import {
  TriangleMesh mesh;  ///< oriented outwards (if closed), manifold, no degenerate facets
  std::string notes;  ///< what was repaired and what is suspicious, for the summary; empty if nothing
};

/// Reads OBJ, STL, PLY or OFF (by extension), cuts polygons into triangles and checks the result.
/// Throws InputError: missing or unreadable file, not manifold, open, inside-out, wrong unit.
Import import_body(const std::string& file, const ImportOptions& options);

/// Triangles that meet the region; with a seed, the connected piece nearest to it and what continues that piece within
/// the margin. Unused vertices are dropped. May be empty.
TriangleMesh clip(const TriangleMesh& mesh, const Region& region);

}  // namespace toile::body
