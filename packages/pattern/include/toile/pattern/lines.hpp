#pragma once

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Throws InputError that names the line and the place where an internal line leaves the panel or crosses another one.
/// Lines may end on edges and on other lines.
void check_lines(const Panel& panel);

}  // namespace toile::pattern
