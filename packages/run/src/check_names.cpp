#include "toile/run/outputs.hpp"

#include <map>

#include "toile/base/error.hpp"
#include "toile/result/exodus_writer.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::run {

namespace {

[[noreturn]] void fail_name(const base::List& entry, const std::string& problem) {
  throw base::InputError(entry.file() + ": " + entry.path() + ": " + problem);
}

/// `held`: the longest name in results.exo that is made of the entry's.
void check_length(const base::List& entry, const std::string& held) {
  constexpr size_t most = result::longest_name;
  if (held.size() <= most) return;
  fail_name(entry, "this name is too long for results.exo, where it makes \"" + held + "\" of " +
                       std::to_string(held.size()) + " characters; at most " + std::to_string(most) +
                       " are possible, so shorten the name by " + std::to_string(held.size() - most));
}

}  // namespace

void check_names(const scene::Scene& scene, const base::List& list) {
  for (const base::List& panel : list.list("Panels").entries()) {
    for (const auto& [edge, nodes] : scene.garment().mesh.edges)
      if (edge.compare(0, panel.name().size() + 1, panel.name() + ".") == 0) check_length(panel, edge);
    if (panel.name() == "body" && scene.surface() != nullptr)
      fail_name(panel, "a panel cannot be named \"body\" in a scene with a body, which has this name in results.exo");
  }
  if (!list.has_list("Supports")) return;
  std::map<std::string, std::string> support_of;  // [name of a field]
  const std::vector<base::List> entries = list.list("Supports").entries();
  for (size_t s = 0; s < entries.size(); ++s)
    for (const std::string& field : solve::field_names_of(scene.problem().supports[s])) {
      check_length(entries[s], field);
      const auto [other, is_new] = support_of.insert({field, entries[s].name()});
      if (!is_new)
        fail_name(entries[s], "this support and \"" + other->second + "\" would both have the field \"" + field +
                                  "\" in the results, because their names differ only in signs that are no letters "
                                  "and no digits; give one of them another name");
    }
}

}  // namespace toile::run
