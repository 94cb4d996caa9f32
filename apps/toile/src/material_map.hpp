#pragma once

#include <string>

#include "toile/criteria/check.hpp"

namespace toile::app {

/// Writes the map of `report` to `folder`/<name>.csv (every state) and two pictures (see result::write_plot):
/// <name>-stretches, wale against course stretch at the smallest shear, and <name>-shear, shear against course stretch
/// at the wale stretch nearest to 1. <name>: the fabric's, in letters that suit a file. Returns warnings, one a line.
std::string write_map(const criteria::Report& report, const std::string& folder);

/// <name> of the files.
std::string file_stem(const criteria::Report& report);

}  // namespace toile::app
