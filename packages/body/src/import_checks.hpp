#pragma once

#include <string>
#include <vector>

#include "toile/body/import.hpp"

namespace toile::body {

/// Polygons over shared points, mm.
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// Each throws InputError with the file, what was found, where, and what can be done.
void check_height(const std::string& file, const PolygonSoup& soup, const ImportOptions& options);
void check_manifold(const std::string& file, const PolygonSoup& soup);
void check_closed(const std::string& file, const PolygonSoup& soup);

/// Whether neighbours run through their common edge in opposite directions; an error if not, unless repair is asked
/// for.
bool check_consistent(const std::string& file, const PolygonSoup& soup, const ImportOptions& options);

/// Turns each connected piece that looks inwards, or refuses it; returns how many pieces were turned.
int orient_outwards(const std::string& file, const ImportOptions& options, TriangleMesh* mesh);

}  // namespace toile::body
