#pragma once

#include <vector>

#include "toile/solve/fields.hpp"

namespace toile::solve {

/// All elements of one block of the mesh in a state, in the layout of element::Batch. Not to be copied: the batch
/// points into it.
class BlockArrays {
 public:
  /// `position`: node_positions of the state.
  BlockArrays(const Problem& problem, size_t block, const State& state, const std::vector<Vec3>& position);
  BlockArrays(const BlockArrays&) = delete;
  BlockArrays& operator=(const BlockArrays&) = delete;

  const element::Batch& batch() const { return batch_; }

 private:
  void add_shell(const Problem& problem, const mesh::Block& block, const BlockModel& model, const State& state);

  std::vector<double> pattern_, x_, params_;
  std::vector<double> frames_, reference_, frozen_;  // of shells
  element::Batch batch_;
};

}  // namespace toile::solve
