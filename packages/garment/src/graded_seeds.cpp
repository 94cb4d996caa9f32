#include "graded_seeds.hpp"

#include <algorithm>
#include <cmath>

namespace toile::garment {
namespace {

double size_at(const SeededEdge& edge, double at) {
  return edge.finer ? std::min(edge.size, edge.finer(at)) : edge.size;
}

/// The number of pairs up to a place, at places of which each is a fraction of a side from the next.
struct Count {
  Fractions places;
  std::vector<double> pairs;
  bool varies = false;
};

Count count_pairs(const SeededEdge& edge, double from, double to) {
  constexpr double of_a_side = 0.25, all_the_same = 0.99;
  Count count{{from}, {0.0}};
  double at = from;
  while (at < to) {
    double size = size_at(edge, at);
    size = std::min(size, size_at(edge, std::min(at + of_a_side * size / edge.length, to)));
    const double next = std::min(at + of_a_side * size / edge.length, to);
    count.pairs.push_back(count.pairs.back() + 0.5 * (next - at) * edge.length / size_at(edge, 0.5 * (at + next)));
    count.places.push_back(next);
    count.varies = count.varies || size < all_the_same * edge.size;
    at = next;
  }
  return count;
}

}  // namespace

double wanted_pairs(const SeededEdge& edge, double from, double to) {
  if (!edge.finer) return (to - from) * edge.length / (2.0 * edge.size);
  return count_pairs(edge, from, to).pairs.back();
}

Fractions graded_places(const SeededEdge& edge, double from, double to) {
  if (!edge.finer) return {};
  const Count count = count_pairs(edge, from, to);
  if (!count.varies) return {};
  const int pairs = static_cast<int>(std::ceil(count.pairs.back()));
  Fractions places;
  for (int k = 1; k < pairs; ++k) {
    const double wanted = count.pairs.back() * k / pairs;
    const auto next = std::lower_bound(count.pairs.begin(), count.pairs.end(), wanted) - count.pairs.begin();
    const double share = (wanted - count.pairs[next - 1]) / (count.pairs[next] - count.pairs[next - 1]);
    places.push_back(count.places[next - 1] + share * (count.places[next] - count.places[next - 1]));
  }
  return places;
}

}  // namespace toile::garment
