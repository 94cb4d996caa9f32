#include "layers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace toile::result {
namespace {

using mesh::Vec3;

constexpr double reach = 5.0;       // mm from one layer to the next, as far as garment and body in BodyMapOptions
constexpr double parallel = 0.7;    // cosine between their tangents
constexpr double most_of_it = 0.5;  // of the shorter one's length

/// Place on a section that lies over a point.
struct Beside {
  const Segment* segment = nullptr;  ///< null: none within reach
  double share = 0.0;                ///< from the first to the second end
};

Beside beside(const Section& section, const Vec3& point, const Vec3& tangent, double limit) {
  Beside best;
  double nearest = limit;
  for (const Segment& segment : section.segments) {
    const double length = segment.length();
    if (!(length > 0.0) || std::abs(segment.step().dot(tangent)) < parallel * length) continue;
    const double share = std::clamp(segment.step().dot(point - segment.point[0]) / (length * length), 0.0, 1.0);
    const double distance = (segment.point[0] + share * segment.step() - point).norm();
    if (distance > nearest) continue;
    nearest = distance;
    best = {&segment, share};
  }
  return best;
}

bool lies_over(const Section& one, const Section& other) {
  const bool is_shorter = one.girth() <= other.girth();
  const Section& shorter = is_shorter ? one : other;
  const Section& longer = is_shorter ? other : one;
  double covered = 0.0;
  for (const Segment& segment : shorter.segments)
    if (beside(longer, segment.middle(), segment.step().normalized(), reach).segment != nullptr)
      covered += segment.length();
  return covered > most_of_it * shorter.girth();
}

}  // namespace

std::vector<std::vector<std::size_t>> layers(const std::vector<Section>& sections) {
  std::vector<std::size_t> group(sections.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t a = 0; a < sections.size(); ++a)
    for (std::size_t b = a + 1; b < sections.size(); ++b)
      if (group[a] != group[b] && lies_over(sections[a], sections[b]))
        std::replace(group.begin(), group.end(), std::size_t{group[b]}, std::size_t{group[a]});
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t first = 0; first < group.size(); ++first) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < group.size(); ++k)
      if (group[k] == first) members.push_back(k);
    if (members.size() > 1) found.push_back(std::move(members));
  }
  return found;
}

Section sum_of(const std::vector<const Section*>& layers) {
  const auto longest = std::max_element(layers.begin(), layers.end(), [](const Section* a, const Section* b) {
    return std::make_pair(a->closed, a->girth()) < std::make_pair(b->closed, b->girth());
  });
  const double reach_of_all = reach * static_cast<double>(layers.size() - 1);
  Section sum = **longest;
  for (const Section* layer : layers) {
    if (layer == *longest) continue;
    for (Segment& segment : sum.segments) {
      const Vec3 tangent = segment.step().normalized();
      const auto at = [](const std::array<double, 2>& ends, double share) {
        return (1.0 - share) * ends[0] + share * ends[1];
      };
      for (std::size_t k = 0; k < 2; ++k) {
        const Beside there = beside(*layer, segment.point[k], tangent, reach_of_all);
        if (there.segment == nullptr) continue;
        segment.pressure[k] += at(there.segment->pressure, there.share);
        for (std::size_t part = 0; part < segment.errors[k].size(); ++part)
          segment.errors[k][part] += at({there.segment->errors[0][part], there.segment->errors[1][part]}, there.share);
      }
      const Beside there = beside(*layer, segment.middle(), tangent, reach_of_all);
      if (there.segment == nullptr) continue;
      segment.tension += there.segment->tension;
      segment.missed += there.segment->missed;
    }
  }
  return sum;
}

}  // namespace toile::result
