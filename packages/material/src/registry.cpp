#include "toile/material/hencky.hpp"
#include "toile/material/isotropic_elastic.hpp"
#include "toile/material/itskov.hpp"
#include "toile/material/neo_hookean.hpp"
#include "toile/material/rebar.hpp"

namespace toile::material {

const std::vector<const LawV1*>& registry() {
  // One explicit list, because a static library drops objects that register themselves. A new material: its header
  // above and its line here, in alphabetical order.
  static constexpr LawV1 laws[] = {make_law<hencky::Law>(), make_law<isotropic_elastic::Law>(), make_law<itskov::Law>(),
                                   make_law<neo_hookean::Law>(), make_law<rebar::Law>()};
  static const std::vector<const LawV1*> list = [] {
    std::vector<const LawV1*> pointers;
    for (const LawV1& law : laws) pointers.push_back(&law);
    return pointers;
  }();
  return list;
}

const LawV1* find(const std::string& name) {
  for (const LawV1* law : registry())
    if (name == law->name) return law;
  return nullptr;
}

Laws::Laws() {
  const auto keep = [](const LawV1*) {};  // compiled in: never freed
  for (const LawV1* law : registry()) all_.emplace_back(law, keep);
}

bool Laws::add(Law law) {
  if (find(law->name) != nullptr) return false;
  all_.push_back(std::move(law));
  return true;
}

Laws::Law Laws::find(const std::string& name) const {
  for (const Law& law : all_)
    if (name == law->name) return law;
  return nullptr;
}

}  // namespace toile::material
