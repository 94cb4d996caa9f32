#pragma once

#include <string>
#include <vector>

#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"

namespace toile::scene {

/// What a scene starts from, looked at before anything is solved.
struct StartReport {
  std::vector<std::string> lines;     ///< what is there: stretches, seams, gaps to the body; for the terminal
  std::vector<std::string> warnings;  ///< what is hardly wanted, each with its likely cause
  std::vector<std::string> errors;    ///< what cannot be wanted: complete messages of bad input
};

/// Looks at the start that scene.start() gives: stretch of each panel, gap and order of each seam, girth, pressure that
/// the placed fabric would exert, nodes inside the body, parts that nothing holds. `list`: the one that the scene was
/// built from; the errors name its entries; `fields`: of the start. The same on every rank; communicates nothing.
StartReport look_at_start(const Scene& scene, const base::List& list, const solve::Fields& fields);

}  // namespace toile::scene
