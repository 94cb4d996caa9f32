#pragma once

#include <map>
#include <string>
#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::scene {

/// What a scene is, as far as it decides the result of a run: by which a run that goes on knows that it is the same.
struct Fingerprint {
  std::map<std::string, std::string> values;  ///< [path] of the input, defaults included
  std::vector<std::string> stages;            ///< their names, in their order
  std::map<std::string, std::vector<double>>
      figures;  ///< of what was built: sizes, sums, distances of some nodes to the body
};

/// `list` was validated against `spec`, and the scene built from it. The same on every rank.
Fingerprint fingerprint(const base::List& list, const base::Spec& spec, const Scene& scene);

/// What differs in a way that a run which is in the stage with this index cannot take up, a line each; empty: it can go
/// on. Free to change are the lists "Output", "Checks" and "Solver", the title, the limits of the stage ("most steps",
/// "most time", "most iterations in all"), and all of the stages after it. `finished`: the stage has reached its end.
std::vector<std::string> differences(const Fingerprint& before, const Fingerprint& now, int stage, bool finished);

}  // namespace toile::scene
