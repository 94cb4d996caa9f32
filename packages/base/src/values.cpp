#include "toile/base/values.hpp"

#include <algorithm>
#include <sstream>

namespace toile::base {

namespace {

std::string text_of(double value) {
  constexpr int exact = 17;  // digits
  std::ostringstream out;
  out.precision(exact);
  out << value;
  return out.str();
}
std::string text_of(const std::string& value) {
  return value;
}

template <class T>
std::string text_of(const std::vector<T>& values) {
  std::string all;
  for (const T& value : values) all += (all.empty() ? "" : ", ") + text_of(value);
  return "{" + all + "}";
}

std::string table_text(const List& list, const std::string& name) {
  std::string all;
  for (const auto& [position, value] : list.table(name)) all += text_of(position) + ": " + text_of(value) + "; ";
  return all;
}

std::string value_text(const List& list, const Parameter& parameter) {
  const std::string& name = parameter.name;
  if (parameter.may_table && list.has_table(name)) return table_text(list, name);
  switch (parameter.type) {
    case Type::real:
      return text_of(list.real(name));
    case Type::integer:
      return std::to_string(list.integer(name));
    case Type::flag:
      return list.flag(name) ? "true" : "false";
    case Type::text:
      return list.word(name);
    case Type::reals:
      return text_of(list.reals(name));
    case Type::texts:
      return text_of(list.words(name));
  }
  return {};
}

void add(const List& list, const Spec& spec, std::map<std::string, std::string>& values) {
  for (const Parameter& parameter : spec.parameters())
    values[list.path() + " > " + parameter.name] = value_text(list, parameter);
  for (const auto& [inner, is_required] : spec.lists())
    if (list.has_list(inner.name())) add(list.list(inner.name()), inner, values);
  for (const auto& [selector, variants] : spec.variants()) {
    const std::string& chosen = list.word(selector);
    values[list.path() + " > " + selector] = chosen;
    for (const Spec& variant : variants)
      if (variant.name() == chosen) add(list, variant, values);
  }
  if (spec.entry() == nullptr) return;
  for (const List& entry : list.entries()) add(entry, *spec.entry(), values);
}

}  // namespace

std::map<std::string, std::string> values_of(const List& list, const Spec& spec) {
  std::map<std::string, std::string> values;
  add(list, spec, values);
  return values;
}

}  // namespace toile::base
