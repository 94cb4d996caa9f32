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
  std::vector<std::string> notes = {};  ///< what must be known of some of them
};

struct MeasuredPlaces {
  std::string path;
  Pressures pressures;
  std::vector<std::array<double, 3>> positions;  ///< [place] mm; empty: the places are levels or points of the scene
};

/// Columns name, pressure and scatter, and x, y, z if the places are given by positions. A place that was measured more
/// than once has the mean of its pressures, and as scatter the root of the mean square of its scatters plus the
/// variance of its pressures: that of all readings together. Throws InputError.
MeasuredPlaces read_measured(const std::string& path);

/// What the run whose results are in `folder` computed there: by name from its tables, by position from the fabric of
/// its results.exo that lies on the body there, layers added up; 0, and a note, where none does. Throws InputError
/// where it has no such place, or no error is told of it.
Pressures computed_at(const MeasuredPlaces& measured, const std::string& folder);

}  // namespace toile::app
