#include "toile/garment/finer.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

namespace toile::garment {
namespace {

using Teuchos::ParameterList;

void multiply_count(ParameterList& list, const char* name, double factor) {
  if (!list.isType<int>(name)) return;
  list.set(name, std::max(1, static_cast<int>(std::lround(factor * list.get<int>(name)))));
}

void divide_size(ParameterList& list, const char* name, double factor) {
  if (list.isType<double>(name)) list.set(name, list.get<double>(name) / factor);
  if (list.isType<int>(name)) list.set(name, list.get<int>(name) / factor);
}

/// Calls `change` for each list in the list `name`, if there is one.
template <class Change>
void for_each_list(ParameterList& in, const std::string& name, const Change& change) {
  if (!in.isSublist(name)) return;
  ParameterList& lists = in.sublist(name);
  for (auto entry = lists.begin(); entry != lists.end(); ++entry)
    if (entry->second.isList()) change(lists.sublist(entry->first));
}

}  // namespace

base::Parameter finer_parameter() {
  return {
      "finer",
      base::Type::real,
      "",
      "Divides the sizes of the elements of all panels, and multiplies their numbers along sides: 2 makes four times "
      "as many elements, 0.5 a quarter.",
      1.0,
      base::Range::positive()};
}

void make_finer(ParameterList& scene) {
  if (!scene.isType<double>("finer") && !scene.isType<int>("finer")) return;
  const double factor = scene.isType<int>("finer") ? scene.get<int>("finer") : scene.get<double>("finer");
  if (!(factor > 0.0)) return;
  for_each_list(scene, "Panels", [&](ParameterList& panel) {
    for (const char* count : {"elements across", "elements along"}) multiply_count(panel, count, factor);
    divide_size(panel, "element size", factor);
    for_each_list(panel, "Sizes", [&](ParameterList& place) { divide_size(place, "size", factor); });
  });
}

}  // namespace toile::garment
