// Results read back with the Exodus library alone.
#pragma once

#include <string>
#include <vector>

namespace toile::test {

/// The last step of a results.exo. Empty where something cannot be read.
struct ExodusStep {
  int steps = 0;                              ///< in the file
  int nodes = 0;                              ///< of garment and body together
  std::vector<double> times;                  ///< [step]
  std::vector<std::vector<double>> position;  ///< [x, y, z][node] coordinates and displacement, mm

  explicit ExodusStep(const std::string& file);
  /// A nodal field by its name, [node].
  std::vector<double> nodal(const std::string& name) const;
  /// A field of elements, of all blocks that have it one after another.
  std::vector<double> element(const std::string& name) const;
  /// A value of the whole model by its name; not a number if there is none.
  double global(const std::string& name) const;

 private:
  std::string file_;
};

}  // namespace toile::test
