#pragma once

#include <string>

#include "toile/material/material.hpp"

namespace toile::material {

/// One run of the compiler on a fabric's file.
struct PlugInBuild {
  bool good = false;
  std::string command;   ///< as for a shell
  std::string messages;  ///< the first errors, with the author's file and line, and hints; all of what the compiler
                         ///< said if `verbose`
};

/// Compiles the C++ file `source` (see plugin.hpp) to the plug-in `library` with the compiler, the flags and the
/// headers that Toile itself was built with. A source without TOILE_MATERIAL is an error of the build. Throws
/// InputError if the source, the compiler or Toile's headers are not there, or the source is not .cpp, .cc or .cxx.
PlugInBuild build_plugin(const std::string& source, const std::string& library, bool verbose = false);

/// The law in the plug-in `library`; the library stays loaded as long as the law lives. Throws InputError, naming the
/// library, if there is no such file, it is no shared library, it holds no fabric or it was built for another Toile.
Laws::Law load_plugin(const std::string& library);

/// Description of the list "Plug-ins": entry name = law name, "file" = library.
base::Spec plugins_spec();

/// The library that an entry of that list names.
std::string plugin_path(const base::List& entry);

/// Adds the laws of the list "Plug-ins" to `laws`. Files count from the folder of the file that names them. Throws
/// InputError: not `allowed` (naming what would be run), what load_plugin() says, a name that is taken, another name in
/// the library than that of the entry.
void add_plugins(const base::List& list, bool allowed, Laws& laws);

}  // namespace toile::material
