#include "depth.hpp"

#include <algorithm>
#include <utility>

namespace toile::crossing {

namespace {

std::vector<int> each_once(std::vector<int> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

Depth::Depth(const Fabric& fabric, const std::vector<Meeting>& meetings) : fabric_(fabric) {
  for (const Meeting& meeting : meetings) {
    partners_[meeting.first].push_back(meeting.second);
    partners_[meeting.second].push_back(meeting.first);
  }
}

double Depth::of(const Meeting& meeting) {
  return std::min(through(meeting.first, fabric_.panel(meeting.second)),
                  through(meeting.second, fabric_.panel(meeting.first)));
}

/// Of the sheet of the element through that of the panel. A mesh line may lie along the other sheet, so that the
/// neighbours are needed to tell how far the fabric goes.
double Depth::through(int element, int panel) {
  const auto [found, is_new] = through_.try_emplace({element, panel}, 0.0);
  if (!is_new) return found->second;
  double above = 0.0, below = 0.0;
  for (const int e : ring(element))
    for (const int node : fabric_.nodes(e)) {
      const double h = height(node, panel);
      above = std::max(above, h);
      below = std::max(below, -h);
    }
  return found->second = std::min(above, below);
}

/// Above those elements of the panel that the elements around the node meet, or else their neighbours do.
double Depth::height(int node, int panel) {
  const auto [found, is_new] = heights_.try_emplace({node, panel}, 0.0);
  if (!is_new) return found->second;
  std::vector<int> near = rings(met_by(fabric_.around(node), panel));
  if (near.empty()) near = rings(rings(met_by(rings(fabric_.around(node)), panel)));
  std::vector<Triangle> triangles;
  for (const int e : near) {
    if (fabric_.has_cluster_of(e, node)) continue;
    for (const Triangle& t : fabric_.triangles(e)) triangles.push_back(t);
  }
  return found->second = height_above(triangles, fabric_.at(node));
}

/// In ascending order.
std::vector<int> Depth::met_by(const std::vector<int>& elements, int panel) const {
  std::vector<int> met;
  for (const int e : elements) {
    const auto partners = partners_.find(e);
    if (partners == partners_.end()) continue;
    for (const int partner : partners->second)
      if (fabric_.panel(partner) == panel) met.push_back(partner);
  }
  return each_once(std::move(met));
}

/// The elements and their neighbours, in ascending order.
std::vector<int> Depth::rings(const std::vector<int>& elements) {
  std::vector<int> all;
  for (const int e : elements) all.insert(all.end(), ring(e).begin(), ring(e).end());
  return each_once(std::move(all));
}

const std::vector<int>& Depth::ring(int element) {
  const auto [found, is_new] = rings_.try_emplace(element);
  if (is_new) found->second = fabric_.ring(element);
  return found->second;
}

}  // namespace toile::crossing
