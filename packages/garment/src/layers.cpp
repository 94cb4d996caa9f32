#include "layers.hpp"

#include <algorithm>
#include <set>

namespace toile::garment {

namespace {

std::vector<int> named_by(const std::vector<base::List>& panels, const base::List& panel) {
  base::Texts names;
  for (const base::List& other : panels) names.push_back(other.name());
  std::vector<int> found;
  for (const std::string& name : panel.words("over")) {
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) panel.fail("over", "found \"" + name + "\", which is no panel" + base::hint(name, names));
    found.push_back(static_cast<int>(place - names.begin()));
  }
  return found;
}

}  // namespace

std::vector<std::vector<int>> read_layers(const std::vector<base::List>& panels) {
  std::vector<std::vector<int>> named, beneath;
  for (const base::List& panel : panels) named.push_back(named_by(panels, panel));
  for (size_t p = 0; p < panels.size(); ++p) {
    std::set<int> all;
    std::vector<int> next = named[p];
    while (!next.empty()) {
      const int below = next.back();
      next.pop_back();
      if (!all.insert(below).second) continue;
      next.insert(next.end(), named[below].begin(), named[below].end());
    }
    if (all.count(static_cast<int>(p)) > 0)
      panels[p].fail("over", "the panel would lie over itself: what it names lies over it in turn");
    beneath.emplace_back(all.begin(), all.end());
  }
  const bool none = std::all_of(beneath.begin(), beneath.end(), [](const auto& some) { return some.empty(); });
  return none ? std::vector<std::vector<int>>() : beneath;
}

}  // namespace toile::garment
