// Runs a scene and prints the pressure at each of its levels. Arguments: the scene's file, and a folder for its
// results.
#include <Tpetra_Core.hpp>
#include <cstdio>
#include <exception>

#include "toile/base/units.hpp"
#include "toile/run/outputs.hpp"

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard mpi(&argc, &argv);
  if (argc < 2) return std::fprintf(stderr, "usage: %s scene.xml [folder]\n", argv[0]), 2;
  try {
    toile::run::Session session(argv[1]);
    toile::run::OutputOptions options;
    if (argc > 2) options.folder = argv[2];  // results.exo, tables and plots; without a folder no file is written
    toile::run::add_outputs(session, options);
    session.run();
    for (const auto& level : session.record().pressure().levels)
      std::printf("%s: %.4f +- %.4f kPa\n", level.title().c_str(), toile::base::mpa_to_kpa(level.pressure_mean),
                  toile::base::mpa_to_kpa(level.pressure_error));
    for (const auto& warning : session.log().warnings()) std::printf("warning: %s\n", warning.c_str());
  } catch (const std::exception& error) {  // bad input, a stage that fails, a check that does not hold
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
  return 0;
}
