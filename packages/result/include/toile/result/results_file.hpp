#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "toile/result/field_name.hpp"

namespace toile::result {

/// A field of one step.
struct FieldValues {
  FieldName name;
  std::vector<double> values;
};

/// The elements of a panel, or of the body.
struct ResultsBlock {
  std::string name;
  int nodes_per_element = 4;
  std::vector<int> connectivity;    ///< indices of nodes, nodes_per_element each
  std::vector<FieldValues> fields;  ///< [field][element], those that the block has

  int size() const { return static_cast<int>(connectivity.size()) / nodes_per_element; }
};

/// What an ExodusWriter has written: the last step of the fields, and every step of the global ones.
struct Results {
  std::vector<std::vector<double>> position;  ///< [x, y, z][node] of the last step, mm; the garment's nodes come first
  int garment_nodes = 0;
  std::vector<ResultsBlock> garment;  ///< a block a panel
  std::vector<ResultsBlock> body;     ///< one block, or none
  std::vector<FieldValues> nodal;     ///< [field][node] of garment and body; zero where a field has no values
  std::vector<FieldValues> global;    ///< [field][step]
  int steps = 0;
};

/// Reads a results.exo or start.exo. Throws InputError "path: why" if the file is missing, is none that Toile wrote,
/// was cut off, or holds no step.
Results read_results(const std::string& path);

}  // namespace toile::result
