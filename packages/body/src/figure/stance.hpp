#pragma once

#include <optional>

#include "figure/scan.hpp"

namespace toile::body {

/// By how much the body is turned about z from looking towards -y, radians, from the long axes of its trunk's sections;
/// between -pi/4 and pi/4; none if its trunk is round and has no long axis. Throws InputError if it looks sideways.
std::optional<double> heading(const FigureScan& scan);

/// Points turned about z by an angle, radians.
TriangleMesh turned_about_z(const TriangleMesh& mesh, double angle);
Vec3 turned_about_z(const Vec3& point, double angle);

/// Of a body of which neither crotch nor armpits were found: throws InputError if it lies or stands on its head.
void check_upright(const TriangleMesh& mesh, const FigureScan& scan);

}  // namespace toile::body
