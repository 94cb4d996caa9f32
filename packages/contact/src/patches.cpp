#include "patches.hpp"

#include <algorithm>
#include <utility>

namespace toile::contact {

Patches::Patches(const FabricInContact& fabric)
    : fabric_(fabric),
      at_(fabric.site_cluster.size()),
      few_(fabric.site_cluster.size(), false),
      element_taken_(fabric.elements.size(), 0),
      site_taken_(fabric.site_cluster.size(), 0) {
  for (size_t e = 0; e < fabric.elements.size(); ++e)
    for (int i = 0; i < fabric.elements[e].nodes; ++i)
      at_[static_cast<size_t>(fabric.elements[e].site[static_cast<size_t>(i)])].push_back(static_cast<int>(e));
  for (size_t s = 0; s < at_.size(); ++s) few_[s] = at_[s].size() < 3;
  find_edges();
}

void Patches::find_edges() {
  std::vector<std::pair<int, int>> sides;
  for (const FabricElement& element : fabric_.elements)
    for (int i = 0; i < element.nodes; ++i) {
      const int a = element.site[static_cast<size_t>(i)],
                b = element.site[static_cast<size_t>((i + 1) % element.nodes)];
      sides.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(sides.begin(), sides.end());
  for (size_t i = 0; i < sides.size();) {
    size_t next = i + 1;
    while (next < sides.size() && sides[next] == sides[i]) ++next;
    if (next == i + 1)
      for (const int site : {sides[i].first, sides[i].second}) few_[static_cast<size_t>(site)] = true;
    i = next;
  }
}

void Patches::add_ring() {
  const size_t end = patch_.size();
  for (size_t k = ring_begin_; k < end; ++k) {
    const FabricElement& element = fabric_.elements[static_cast<size_t>(patch_[k])];
    for (int i = 0; i < element.nodes; ++i) {
      const auto site = static_cast<size_t>(element.site[static_cast<size_t>(i)]);
      if (std::exchange(site_taken_[site], stamp_) == stamp_) continue;
      for (const int other : at_[site])
        if (std::exchange(element_taken_[static_cast<size_t>(other)], stamp_) != stamp_) patch_.push_back(other);
    }
  }
  ring_begin_ = end;
}

const std::vector<int>& Patches::around(int site, int more) {
  ++stamp_;
  patch_ = at(site);
  for (const int e : patch_) element_taken_[static_cast<size_t>(e)] = stamp_;
  site_taken_[static_cast<size_t>(site)] = stamp_;
  ring_begin_ = 0;
  for (int ring = few_[static_cast<size_t>(site)] ? -1 : 0; ring < more; ++ring) add_ring();
  return patch_;
}

}  // namespace toile::contact
