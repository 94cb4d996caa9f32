#pragma once

#include <string>

namespace toile::solve {

/// "normal", 3 components: normal_x, normal_y, normal_z, which viewers show as one vector.
inline std::string component_name(const std::string& name, int components, int component) {
  return components == 1 ? name : name + "_" + "xyz"[component];
}

}  // namespace toile::solve
