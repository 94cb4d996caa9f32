#pragma once

#include <string>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Under this key files of ours tell what the format has no words for: in an edge its name, in a panel holes, internal
/// lines, notches and grain, in the pattern its stitches with names and parts. Other programs pass over it.
constexpr const char* json_key = "toile";

Pattern read_json(const std::string& path);
void write_json(const Pattern& pattern, const std::string& path);

}  // namespace toile::pattern
