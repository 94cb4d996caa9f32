#pragma once

#include "toile/material/law.hpp"

/// What the author of a plug-in includes: law.hpp, and TOILE_MATERIAL(Law) to end the file with. `toile material build`
/// makes a shared library of it (doc/new-fabric.md).
namespace toile::material {

/// What a plug-in was built with. Its layout never changes, so that a plug-in of any version can be refused by name.
struct Stamp {
  int abi;               ///< of LawV1
  int lanes;             ///< points at once: tells the instruction set
  const char* version;   ///< of Toile, with a hash of the material headers
  const char* compiler;  ///< __VERSION__
};

/// The one symbol of a plug-in, `toile_material`. `law` may be read only if `stamp` is that of the program.
struct PlugIn {
  Stamp stamp;
  LawV1 law;
};

}  // namespace toile::material

/// The build command defines TOILE_MATERIAL_VERSION.
#define TOILE_MATERIAL(Law)                                                                             \
  extern "C" __attribute__((visibility("default"))) const ::toile::material::PlugIn toile_material = {  \
      {::toile::material::material_abi, ::toile::material::lanes, TOILE_MATERIAL_VERSION, __VERSION__}, \
      ::toile::material::make_law<Law>()};
