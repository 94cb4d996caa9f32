#pragma once

#include <string>

#include "toile/run/session.hpp"

namespace toile::app {

/// What the command line says of a run.
struct RunArguments {
  std::string scene;        ///< XML file
  std::string output = "";  ///< folder of the results; empty: results/<name of the scene>
  int threads = 1;          ///< for the element loops of each rank
  bool quiet = false;
  bool report = false;         ///< write the page of the results too
  bool no_pictures = false;    ///< tables without plots
  bool restart = false;        ///< go on after the last step in the folder
  bool allow_plugins = false;  ///< the scene may load programs
  double heartbeat = 5.0;      ///< s without a line after which a step that is sought is told of
};

run::Options options_of(const RunArguments& arguments);
/// Writes results and tells of the run as `toile run` does. Throws what Session::run() throws, with how to go on.
void run_session(run::Session& session, const RunArguments& arguments);

}  // namespace toile::app
