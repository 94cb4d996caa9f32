#pragma once

#include <map>
#include <utility>
#include <vector>

#include "meetings.hpp"

namespace toile::crossing {

/// How far fabric is through fabric at its meetings.
class Depth {
 public:
  /// Keeps references to both.
  Depth(const Fabric& fabric, const std::vector<Meeting>& meetings);

  /// Within two elements of the meeting's lines, and on the side of each sheet on which less of the other one lies; mm.
  double of(const Meeting& meeting);

 private:
  double through(int element, int panel);
  double height(int node, int panel);
  std::vector<int> met_by(const std::vector<int>& elements, int panel) const;
  std::vector<int> rings(const std::vector<int>& elements);
  const std::vector<int>& ring(int element);

  const Fabric& fabric_;
  std::map<int, std::vector<int>> partners_;       ///< by element: those that it meets
  std::map<int, std::vector<int>> rings_;          ///< by element
  std::map<std::pair<int, int>, double> heights_;  ///< by node and panel
  std::map<std::pair<int, int>, double> through_;  ///< by element and panel
};

}  // namespace toile::crossing
