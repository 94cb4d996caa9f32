#pragma once

#include <string>

#include "toile/base/parameters.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::garment {

/// What the parameter "file" of a list says to the user, with the formats.
std::string pattern_file_text();

/// The path that the parameter "file" of a list stands for, which counts from the folder of the file that wrote it.
std::string path_of_pattern(const base::List& list);

/// Reads that file. Throws InputError.
pattern::Pattern read_pattern_file(const base::List& list);

}  // namespace toile::garment
