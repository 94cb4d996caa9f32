#include <algorithm>

#include "tester_kind.hpp"

namespace toile::scene {

// Every kind of tester: each is a function NAME_tester() in a source of its own.
#define TOILE_TESTERS(TESTER) \
  TESTER(flat_jaws)           \
  TESTER(rigid_sensor)

#define TOILE_DECLARE(name) TesterKind name##_tester();
TOILE_TESTERS(TOILE_DECLARE)
#undef TOILE_DECLARE

namespace {

const std::vector<TesterKind>& kinds() {
#define TOILE_CALL(name) name##_tester(),
  static const std::vector<TesterKind> all{TOILE_TESTERS(TOILE_CALL)};
#undef TOILE_CALL
  return all;
}

}  // namespace

const std::string& existing(const base::List& entry, const std::string& parameter, const base::Texts& valid) {
  const std::string& name = entry.word(parameter);
  if (std::find(valid.begin(), valid.end(), name) == valid.end())
    entry.fail(parameter, "no " + parameter + " is named \"" + name + "\"" + base::hint(name, valid));
  return name;
}

base::Spec tester_spec() {
  std::vector<base::Spec> specs;
  for (const TesterKind& kind : kinds()) specs.push_back(kind.spec);
  base::Spec tester("tester", "A tester of a hosiery laboratory, and what it would read.");
  tester.variant("type", "Kind of tester.", specs);
  return tester;
}

std::shared_ptr<const Tester> read_tester(const base::List& entry, const TesterPlaces& places) {
  const auto named = [&](const TesterKind& kind) { return kind.spec.name() == entry.word("type"); };
  return std::find_if(kinds().begin(), kinds().end(), named)->make(entry, places);
}

}  // namespace toile::scene
