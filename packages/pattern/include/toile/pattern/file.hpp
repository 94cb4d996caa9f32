#pragma once

#include <string>
#include <vector>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Reads a file of patterns; its ending tells the format. What is returned is checked: loops are closed and oriented,
/// names are unique, stitches join edges that exist. Throws InputError that begins with the path.
Pattern read_pattern(const std::string& path);

/// Writes a file of patterns; its ending tells the format. A file of this name is replaced when all is written.
/// Throws InputError for an unknown ending, a pattern that check() refuses, or a path that cannot be written.
void write_pattern(const Pattern& pattern, const std::string& path);

/// One line a format, as messages and documentation show them: ".json (Garment-Pattern-Generator, GarmentCode)".
std::vector<std::string> formats();

}  // namespace toile::pattern
