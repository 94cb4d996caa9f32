// Measured pressures of a CSV file, and those that a run computed at the same places.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace toile::app {

/// Pressures of named places with their scatter or error, kPa.
struct Pressures {
  std::vector<std::string> names;
  std::vector<double> values, errors;
};

struct MeasuredPlaces {
  std::string path;
  Pressures pressures;
  std::vector<std::array<double, 3>> positions;  ///< [place] mm; empty: the places are levels or points of the scene
};

/// Columns name, pressure and scatter, and x, y, z if the places are given by positions. Throws InputError.
MeasuredPlaces read_measured(const std::string& path);

/// What the run whose results are in `folder` computed there: by name from its tables, by position from the body of its
/// results.exo. Throws InputError where it has no such place, or no error is told of it.
Pressures computed_at(const MeasuredPlaces& measured, const std::string& folder);

}  // namespace toile::app
