#pragma once

#include <optional>
#include <string>

#include "polygon_soup.hpp"
#include "toile/body/import.hpp"

namespace toile::body {

/// Lengths of the box round the corners of all polygons, mm.
Vec3 extents(const PolygonSoup& soup);
/// "120 x 80 x 1700 mm".
std::string shown_extents(const Vec3& lengths);

/// Each throws InputError with the file, what was found, where, and what can be done.
/// The height along z, and what hints at a wrong unit or at a body that lies.
void check_extents(const std::string& file, const PolygonSoup& soup, const ImportOptions& options);
/// The unit that would make a person of a body which is none with this scale; none if there is no such unit.
std::optional<OtherUnit> person_in_another_unit(double height, double scale);
void check_manifold(const std::string& file, const PolygonSoup& soup);
void check_closed(const std::string& file, PolygonSoup soup);

/// Whether neighbours run through their common edge in opposite directions; an error if not, unless repair is asked
/// for.
bool check_consistent(const std::string& file, const PolygonSoup& soup, const ImportOptions& options);

/// Turns each connected piece that looks inwards, or refuses it; returns how many pieces were turned.
int orient_outwards(const std::string& file, const ImportOptions& options, TriangleMesh* mesh);

}  // namespace toile::body
