#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "toile/base/origins.hpp"
#include "toile/base/read_content.hpp"

namespace toile::base {

/// A file with everything that it includes, merged: what a file says goes before what it includes, a later included
/// file before an earlier one. Lists are merged entry by entry; a list with the parameter "replace" = true takes the
/// place of the included list of its name, one with "remove" = true takes it out.
struct Merged {
  Teuchos::ParameterList list;
  Origins origins;
};

/// Reads `file` and the files of its parameter "include" (paths from the folder of the file that names them).
/// `root`: name of the outermost list in messages. Throws InputError that names the file at fault.
Merged read_merged(const std::string& file, const std::string& root);

/// The same of what is in memory.
Merged merged(const Content& content, const std::string& root);

}  // namespace toile::base
