#pragma once

#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/contact/law.hpp"

namespace toile::contact {

/// A law of contact that a scene may name.
struct LawKind {
  base::Spec spec;  ///< its name, text and parameters
  LawPtr (*make)(const base::List& list);
};

/// All of them, the default first; a new one is a source of its own and its line in laws.cpp.
const std::vector<LawKind>& laws();

/// Adds the choice of a law, "law", to the description of a list.
void add_law(base::Spec& spec);
/// The law that such a list names. Throws base::InputError.
LawPtr make_law(const base::List& list);

}  // namespace toile::contact
