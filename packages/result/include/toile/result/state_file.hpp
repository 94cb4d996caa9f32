#pragma once

#include <map>
#include <string>
#include <vector>

namespace toile::result {

/// Named arrays from which a run continues; names without '/'.
struct StateData {
  std::map<std::string, std::vector<double>> reals;
  std::map<std::string, std::vector<int>> integers;
  std::map<std::string, std::string> metadata;  ///< for instance the scene's file and the stage's name
};

/// Writes the state as HDF5 (groups "reals", "integers", "metadata") in place of an older one, as a whole or not at all
/// (see Replacement). Before it stand 512 bytes that HDF5 skips, with the format's version, the size and a checksum.
/// Throws InputError if it cannot be written; the older file is then untouched.
void write_state(const std::string& path, const StateData& state);

/// The same arrays, bit for bit. Throws InputError if the file is missing, cut off, damaged in any byte of the state,
/// or not a state of this version of the program.
StateData read_state(const std::string& path);

}  // namespace toile::result
