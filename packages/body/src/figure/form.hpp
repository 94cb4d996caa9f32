#pragma once

#include <string>

#include "toile/body/landmarks.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// A body without head, hands and feet: cut above the neck, beyond the wrists and below the ankles, closed by smooth
/// caps, with facets of edges of about `edge` mm, and without details that are smaller than some of them. Throws
/// InputError if the body lacks one of these landmarks.
TriangleMesh dress_form(const TriangleMesh& body, const Landmarks& landmarks, double edge);

/// Throws InputError if facets intersect: how many, where, and `when`.
void check_intersections(const TriangleMesh& mesh, const std::string& when);

}  // namespace toile::body
