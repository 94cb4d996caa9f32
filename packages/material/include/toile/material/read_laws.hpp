#pragma once

#include <string>

#include "toile/base/read_content.hpp"
#include "toile/material/material.hpp"

namespace toile::material {

/// The built-in laws and those that `file` adds by its lists "Plug-ins" and "Formulas" (plugins_spec(),
/// formulas_spec()); they must be known before the rest of the file can be described. `root`: name of its outermost
/// list. Throws base::InputError, also if it has plug-ins that are not allowed.
Laws read_laws(const std::string& file, const std::string& root, bool allow_plugins);
Laws read_laws(const base::Content& content, const std::string& root, bool allow_plugins);

}  // namespace toile::material
