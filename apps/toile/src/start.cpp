#include "start.hpp"

#include <map>

#include "toile/base/error.hpp"
#include "toile/result/exodus_writer.hpp"
#include "torques.hpp"

namespace toile::app {

namespace {

[[noreturn]] void fail_name(const base::List& entry, const std::string& problem) {
  throw base::InputError(entry.file() + ": " + entry.path() + ": " + problem);
}

/// `added`: characters that results.exo puts to the name.
void check_length(const base::List& entry, const std::string& kind, const std::string& added) {
  const size_t most = static_cast<size_t>(result::longest_name) - added.size();
  if (entry.name().size() <= most) return;
  fail_name(entry, "the name of this " + kind + " has " + std::to_string(entry.name().size()) +
                       " characters; results.exo holds at most " + std::to_string(most) + " (with \"" + added +
                       "\" " + std::to_string(result::longest_name) + ")");
}

}  // namespace

void check_names(const scene::Scene& scene, const base::List& list) {
  for (const base::List& panel : list.list("Panels").entries()) {
    check_length(panel, "panel", ".bottom");
    if (panel.name() == "body" && scene.surface() != nullptr)
      fail_name(panel, "a panel cannot be named \"body\" in a scene with a body, which has this name in results.exo");
  }
  if (!list.has_list("Supports")) return;
  std::map<std::string, std::string> support_of;  // name of its torque in the files
  const std::vector<base::List> entries = list.list("Supports").entries();
  for (size_t s = 0; s < entries.size(); ++s) {
    if (!scene.problem().supports[s].turn) continue;
    check_length(entries[s], "support that turns", "torque_");
    const std::string field = torque_name(scene.problem().supports[s]);
    const auto [other, is_new] = support_of.insert({field, entries[s].name()});
    if (!is_new)
      fail_name(entries[s], "the torque of this support and that of \"" + other->second +
                                "\" would both be named \"" + field +
                                "\" in the results: they differ in characters only that are no letter and no digit");
  }
}

void tell_start(const scene::StartReport& start, base::Log& log) {
  std::string text = "Start";
  for (const std::string& line : start.lines) text += "\n  " + line;
  log.info(text);
  for (const std::string& warning : start.warnings) log.warn(warning);
  if (start.errors.empty()) return;
  std::string all;
  for (const std::string& error : start.errors) all += (all.empty() ? "" : "\n") + error;
  throw base::InputError(all);
}

}  // namespace toile::app
