#include "stop_signal.hpp"

#include <csignal>

namespace toile::app {

namespace {

volatile std::sig_atomic_t caught = 0;

extern "C" void remember(int signal) {
  caught = signal;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_stop_signals() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

std::string stop_signal() {
  if (caught == 0) return {};
  return caught == SIGINT ? "it was interrupted (SIGINT)" : "it was asked to end (SIGTERM)";
}

}  // namespace toile::app
