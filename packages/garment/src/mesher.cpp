#include "mesher.hpp"

#include <algorithm>

namespace toile::garment {

const std::vector<Mesher>& meshers() {
  static const std::vector<Mesher> all{structured_mesher(), free_mesher()};
  return all;
}

const Mesher& mesher_of(const base::List& panel) {
  const std::string& name = panel.word("mesher");
  const auto& all = meshers();
  return *std::find_if(all.begin(), all.end(), [&name](const Mesher& m) { return m.spec.name() == name; });
}

}  // namespace toile::garment
