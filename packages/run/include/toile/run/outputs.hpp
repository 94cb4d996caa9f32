#pragma once

#include <memory>
#include <string>
#include <vector>

#include "toile/run/session.hpp"

namespace toile::run {

struct OutputOptions {
  std::string folder = "";  ///< of the files; empty: none are written
  double heartbeat = 5.0;   ///< s without a line after which the iterations of a step are told of
  bool pictures = true;     ///< whether plots are drawn beside their tables
};

/// Adds every output that the session's scene asks for: what is told to its log, and files if there is a folder.
/// Throws base::InputError, on every rank, if the folder cannot be made or written, a file in it cannot be replaced, or
/// a file could not hold a name of the scene; nothing in it has then changed. Results of an earlier run are replaced
/// when the first step is accepted, not before. Collective.
void add_outputs(Session& session, const OutputOptions& options);

/// Every file that a run may write into its folder.
std::vector<std::string> output_files();

/// Writes the start of the session's scene as start.exo; earlier results stay as they are. Throws base::InputError, on
/// every rank, as add_outputs() does. Collective.
void write_start(Session& session, const std::string& folder);

/// Refuses names of panels and supports that results.exo cannot hold: too long, or equal once they are cleaned.
/// Throws base::InputError; the same on every rank.
void check_names(const scene::Scene& scene, const base::List& list);

}  // namespace toile::run
