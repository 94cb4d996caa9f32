#pragma once

#include <optional>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::result {

/// The body as results show it.
struct ShownBody {
  body::TriangleMesh mesh;
  /// [vertex] mm, how far the smooth surface lies outside of the body's own triangles. Empty: they were made from it.
  std::vector<double> error = {};
};

/// The triangles of a body; those of an imported one are divided where the garment can come, until their edges are
/// about as long as `size` (mm; none: the mean side of the garment's elements), and laid onto the smooth surface there:
/// within some sizes of the garment where it starts, or everywhere if it does not start on the body. At most some
/// 200,000 triangles are made. The same arguments make the same triangles.
ShownBody shown_body(const body::Surface& surface, body::TriangleMesh triangles, const mesh::Mesh& garment,
                     std::optional<double> size);

}  // namespace toile::result
