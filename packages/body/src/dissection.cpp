#include "dissection.hpp"

#include <algorithm>
#include <numeric>

namespace toile::body {
namespace {

constexpr int layers = 3;        ///< of a separator: nodes further apart share no cell
constexpr int smallest = 96;     ///< nodes; fewer are not parted further
constexpr double balance = 0.4;  ///< least part of the nodes on either side

enum Half : char { elsewhere, lower, upper, between };

struct Cut {
  int axis = -1;  ///< -1: none
  int at = 0;     ///< first layer
  int size = 0;   ///< nodes in its layers
};

class Dissection {
 public:
  explicit Dissection(const SheetGrid& grid)
      : grid_(grid), side_(grid.unknowns(), elsewhere), start_(grid.unknowns() + 1, 0) {
    for (const auto& cell : grid.cells()) {
      for (const int u : cell.unknowns) ++start_[u + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    cells_.resize(start_.back());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (std::size_t c = 0; c < grid.cells().size(); ++c) {
      for (const int u : grid.cells()[c].unknowns) cells_[next[u]++] = static_cast<int>(c);
    }
  }
  void order(std::vector<int> part, std::vector<int>* result);

 private:
  Cut smallest_cut(const std::vector<int>& part) const;
  bool couples(int node, Half side) const;

  const SheetGrid& grid_;
  std::vector<Half> side_;
  std::vector<int> start_, cells_;
};

bool Dissection::couples(int node, Half side) const {
  for (int c = start_[node]; c < start_[node + 1]; ++c) {
    for (const int u : grid_.cells()[cells_[c]].unknowns) {
      if (side_[u] == side) return true;
    }
  }
  return false;
}

/// Of the planes that leave enough on both sides, the one with the fewest nodes.
Cut Dissection::smallest_cut(const std::vector<int>& part) const {
  Cut best;
  const auto& nodes = grid_.nodes();
  const int n = static_cast<int>(part.size());
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&](int a, int b) { return nodes[a][axis] < nodes[b][axis]; };
    const auto [low, high] = std::minmax_element(part.begin(), part.end(), along);
    const int first = nodes[*low][axis], last = nodes[*high][axis];
    std::vector<int> below(last - first + 2, 0);  // nodes below each layer
    for (const int node : part) {
      ++below[nodes[node][axis] - first + 1];
    }
    std::partial_sum(below.begin(), below.end(), below.begin());
    for (int at = first + 1; at + layers <= last; ++at) {
      const int before = below[at - first], size = below[at + layers - first] - before;
      if (std::min(before, n - before - size) >= balance * (n - size) && (best.axis < 0 || size < best.size)) {
        best = {axis, at, size};
      }
    }
  }
  return best;
}

void Dissection::order(std::vector<int> part, std::vector<int>* result) {
  const Cut cut = static_cast<int>(part.size()) > smallest ? smallest_cut(part) : Cut();
  if (cut.axis < 0) {
    result->insert(result->end(), part.begin(), part.end());
    return;
  }
  for (const int node : part) {
    const int off = grid_.nodes()[node][cut.axis] - cut.at;
    side_[node] = off < 0 ? lower : off < layers ? between : upper;
  }
  for (const int node : part) {
    if (side_[node] != between) continue;
    if (!couples(node, lower))
      side_[node] = upper;
    else if (!couples(node, upper))
      side_[node] = lower;
  }
  std::array<std::vector<int>, 3> sides;
  for (const int node : part) {
    sides[side_[node] - 1].push_back(node);
  }
  for (const int node : part) {
    side_[node] = elsewhere;
  }
  order(std::move(sides[0]), result);
  order(std::move(sides[1]), result);
  result->insert(result->end(), sides[2].begin(), sides[2].end());
}

}  // namespace

std::vector<int> dissection_order(const SheetGrid& grid, std::vector<int> unknowns) {
  std::vector<int> result;
  result.reserve(unknowns.size());
  Dissection(grid).order(std::move(unknowns), &result);
  return result;
}

}  // namespace toile::body
