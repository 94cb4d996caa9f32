#pragma once

#include <memory>
#include <string>
#include <vector>

#include "folder.hpp"
#include "toile/base/log.hpp"
#include "toile/base/timer.hpp"
#include "toile/run/observer.hpp"

namespace toile::run {

/// What an output is made for. All of it outlives the output.
struct OutputContext {
  const scene::Scene& scene;
  base::Log& log;
  base::Timer& timer;
  std::shared_ptr<Folder> folder;  ///< null: no files are wanted
  double heartbeat;                ///< s
};

/// Something that a run tells or writes. Each is a source of its own, with a line in the registry (outputs.cpp).
struct Output {
  std::vector<std::string> files;  ///< that it may write, of any scene
  /// Null if the scene, or who runs it, does not ask for it. Called on the first rank.
  std::unique_ptr<Observer> (*make)(const OutputContext& context);
};

}  // namespace toile::run
