#include "scope.hpp"

#include <algorithm>

namespace toile::base {
namespace {

const Parameter* find(const std::vector<Parameter>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&name](const Parameter& p) { return p.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// What the input, or else the default, says for a selector; empty if neither does.
std::string selected(const Spec& spec, const std::string& selector, const Teuchos::ParameterList& list) {
  if (list.isType<std::string>(selector)) return list.get<std::string>(selector);
  const auto* fallback = std::get_if<std::string>(&find(spec.parameters(), selector)->fallback);
  return fallback == nullptr || list.isParameter(selector) ? "" : *fallback;
}

Texts sorted(Texts names) {
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

Scope::Scope(const Spec& spec, const Teuchos::ParameterList& list) {
  add(spec, list);
}

void Scope::add(const Spec& spec, const Teuchos::ParameterList& list) {
  for (const Parameter& one : spec.parameters()) parameters.push_back(&one);
  for (const auto& one : spec.lists()) lists.push_back(&one);
  if (spec.entry()) {
    entry = spec.entry().get();
    least_entries = spec.least_entries();
  }
  for (const auto& [selector, variants] : spec.variants()) {
    const std::string wanted = selected(spec, selector, list);
    bool found = false;
    for (const Spec& variant : variants) {
      if (variant.name() == wanted) {
        found = true;
        add(variant, list);
      } else {
        others_.emplace_back(selector, &variant);
      }
    }
    complete = complete && found;
  }
}

const Parameter* Scope::parameter(const std::string& name) const {
  for (const Parameter* one : parameters) {
    if (one->name == name) return one;
  }
  return nullptr;
}

const Spec* Scope::list(const std::string& name) const {
  for (const auto* one : lists) {
    if (one->first.name() == name) return &one->first;
  }
  return nullptr;
}

Texts Scope::parameter_names() const {
  Texts names;
  for (const Parameter* one : parameters) names.push_back(one->name);
  return sorted(std::move(names));
}

Texts Scope::list_names() const {
  Texts names;
  for (const auto* one : lists) names.push_back(one->first.name());
  for (const Parameter* one : parameters) {
    if (one->may_table) names.push_back(one->name);
  }
  return sorted(std::move(names));
}

std::string Scope::belongs(const std::string& name) const {
  for (const auto& [selector, variant] : others_) {
    const bool has_list = std::any_of(variant->lists().begin(), variant->lists().end(),
                                      [&n = name](const auto& one) { return one.first.name() == n; });
    if (has_list || find(variant->parameters(), name) != nullptr) {
      return " (it belongs to " + selector + " \"" + variant->name() + "\")";
    }
  }
  return "";
}

}  // namespace toile::base
