#include <algorithm>

#include "membrane3.hpp"
#include "membrane4.hpp"
#include "shell3.hpp"
#include "shell4.hpp"
#include "shell4r.hpp"
#include "toile/element/element.hpp"

namespace toile::element {

const std::vector<const Element*>& registry() {
  static const std::vector<const Element*> elements = {&membrane3(), &membrane4(), &shell3(), &shell4(), &shell4r()};
  return elements;
}

const Element* find(const std::string& name) {
  const auto& elements = registry();
  const auto found =
      std::find_if(elements.begin(), elements.end(), [&](const Element* e) { return e->name() == name; });
  return found == elements.end() ? nullptr : *found;
}

}  // namespace toile::element
