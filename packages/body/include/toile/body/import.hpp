#pragma once

#include <string>

#include "toile/body/body.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

enum class Axis { x, y, z };

/// How a body file is read and what is demanded of it.
struct ImportOptions {
  double scale = 1.0;               ///< mm per unit of the file
  double least_height = 300.0;      ///< mm, after scaling; a person or a leg in centimetres is below
  double greatest_height = 3000.0;  ///< mm
  Axis up = Axis::z;                ///< axis of the file that becomes z
  bool up_is_known = false;         ///< true: a body that is wider than high does stand
  /// Vertices on borders within this distance become one, mm; 0: 1e-5 of the diagonal of the body's box.
  double weld = 0.0;
  bool closed = true;               ///< a border is an error
  bool repair_orientation = false;  ///< turn inside-out bodies instead of refusing them
  Region reach;                     ///< connected pieces that both have facets here must not intersect
};

/// A body as it came out of a file.
struct Import {
  TriangleMesh mesh;            ///< oriented outwards (if closed), manifold, no degenerate facets
  Vec3 extents = Vec3::Zero();  ///< mm
  std::string notes;  ///< what was repaired or left out and what is suspicious, for the summary; empty if nothing
};

/// Reads OBJ, STL, PLY or OFF (by extension), welds near-copies of vertices, cuts polygons into triangles, leaves out
/// pieces inside others and checks the result.
/// Throws InputError: missing or unreadable file, not manifold, open, inside-out, pieces that intersect, wrong unit,
/// lying.
Import import_body(const std::string& file, const ImportOptions& options);

/// Cuts triangles of CAD programs (more than ten times as long as wide, or more than four times and 100 mm) until they
/// are four times as long, so that there are vertices all along them: on the edges at which flat faces meet, which lie
/// on the round body that the faces are chords of. The faces get no vertices inside: their diagonals are laid across.
/// No edge shorter than 15 mm is cut; the surface stays what it is. Returns how far the middle of an edge lies inside
/// the round body at most, mm: 0 where the strips run straight, more where their ends are turned against each other.
double split_long_triangles(TriangleMesh* mesh);

/// Triangles that meet the region; with a seed, the connected piece nearest to it and what continues that piece within
/// the margin. Unused vertices are dropped. May be empty.
TriangleMesh clip(const TriangleMesh& mesh, const Region& region);

}  // namespace toile::body
