#include "toile/contact/laws.hpp"

#include <algorithm>
#include <string>

namespace toile::contact {

// Every law of contact, the default first: each is a function NAME_law() in a source of its own.
#define TOILE_CONTACT_LAWS(LAW) LAW(frictionless)

#define TOILE_DECLARE(name) LawKind name##_law();
TOILE_CONTACT_LAWS(TOILE_DECLARE)
#undef TOILE_DECLARE

const std::vector<LawKind>& laws() {
#define TOILE_CALL(name) name##_law(),
  static const std::vector<LawKind> all{TOILE_CONTACT_LAWS(TOILE_CALL)};
#undef TOILE_CALL
  return all;
}

void add_law(base::Spec& spec) {
  std::vector<base::Spec> specs;
  for (const LawKind& kind : laws()) specs.push_back(kind.spec);
  spec.variant("law", "What the body does to the fabric that touches it.", specs, specs.front().name());
}

LawPtr make_law(const base::List& list) {
  const auto named = [&](const LawKind& kind) { return kind.spec.name() == list.word("law"); };
  return std::find_if(laws().begin(), laws().end(), named)->make(list);
}

}  // namespace toile::contact
