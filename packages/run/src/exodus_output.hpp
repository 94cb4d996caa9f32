#pragma once

#include "folder.hpp"
#include "toile/run/record.hpp"

namespace toile::run {

/// start.exo: what the scene starts from, with the fields that results.exo has. `record`: before its first step. Throws
/// InputError.
void write_start(const Record& record, const Folder& folder);

}  // namespace toile::run
