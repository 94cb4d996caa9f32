#pragma once

namespace toile::base {

/// Most memory that this process has held so far, in MB (1e6 bytes).
double peak_memory();

}  // namespace toile::base
