#pragma once

#include <string>

namespace toile::app {

/// From now on SIGINT and SIGTERM are remembered instead of ending the program; a second one ends it at once.
void catch_stop_signals();
/// Why a run is to end, or empty.
std::string stop_signal();

}  // namespace toile::app
