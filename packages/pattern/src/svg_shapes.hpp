#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "svg_path.hpp"

namespace toile::pattern {

/// Whether an element of this kind draws lines that are read: path, polygon, rect and so on.
bool is_shape(const std::string& kind);

/// What it draws, in its own units. Throws InputError.
std::vector<SubPath> shape_paths(const pugi::xml_node& node, const std::string& kind);

}  // namespace toile::pattern
