#pragma once

#include <optional>
#include <vector>

#include "toile/body/section.hpp"

namespace toile::scene {

/// The piece that comes closest to a point; at least one is there.
body::SectionPiece nearest_piece(std::vector<body::SectionPiece> pieces, const body::Vec3& point);

/// The part of a section from its place closest to `from` to that closest to `to`, counter-clockwise seen against
/// `normal`; without `to` once round. An open section runs either way, without `to` from the end closer to `from`.
/// Empty: it ends where it starts.
std::vector<body::Vec3> way_on_section(const body::SectionPiece& piece, const body::Vec3& normal,
                                       const body::Vec3& from, const std::optional<body::Vec3>& to);

/// The same way with further points, so that neighbours are at most `step` (mm) apart.
std::vector<body::Vec3> resampled(const std::vector<body::Vec3>& way, double step);

/// [point] length along a way up to it, mm.
std::vector<double> lengths_along(const std::vector<body::Vec3>& way);

/// The point of a way at a length, mm. `lengths`: lengths_along(way).
body::Vec3 point_at(const std::vector<body::Vec3>& way, const std::vector<double>& lengths, double length);

}  // namespace toile::scene
