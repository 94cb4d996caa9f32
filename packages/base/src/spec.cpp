#include <algorithm>
#include <stdexcept>

#include "text.hpp"
#include "toile/base/parameters.hpp"

namespace toile::base {

bool Range::contains(double value) const {
  const bool above = lower_open ? value > lower : value >= lower;
  const bool below = upper_open ? value < upper : value <= upper;
  return above && below;
}

std::string Range::text() const {
  const bool bounded_below = lower != -std::numeric_limits<double>::infinity();
  const bool bounded_above = upper != std::numeric_limits<double>::infinity();
  if (bounded_below && bounded_above) {
    return number_text(lower) + (lower_open ? " < value " : " <= value ") + (upper_open ? "< " : "<= ") +
           number_text(upper);
  }
  if (bounded_below) return (lower_open ? "> " : ">= ") + number_text(lower);
  if (bounded_above) return (upper_open ? "< " : "<= ") + number_text(upper);
  return "";
}

Spec& Spec::add(Parameter parameter) {
  const auto twice = [&parameter](const Parameter& other) { return other.name == parameter.name; };
  if (std::any_of(parameters_.begin(), parameters_.end(), twice)) {
    throw std::logic_error("parameter '" + parameter.name + "' is declared twice in '" + name_ + "'");
  }
  const int* whole = std::get_if<int>(&parameter.fallback);
  if (parameter.type == Type::real && whole != nullptr) parameter.fallback = static_cast<double>(*whole);
  parameters_.push_back(std::move(parameter));
  return *this;
}

Spec& Spec::real(const std::string& name, const std::string& unit, const std::string& text, Value fallback,
                 Range range) {
  return add({name, Type::real, unit, text, std::move(fallback), range});
}

Spec& Spec::integer(const std::string& name, const std::string& text, Value fallback, Range range) {
  return add({name, Type::integer, "", text, std::move(fallback), range});
}

Spec& Spec::flag(const std::string& name, const std::string& text, Value fallback) {
  return add({name, Type::flag, "", text, std::move(fallback)});
}

Spec& Spec::word(const std::string& name, const std::string& text, Value fallback) {
  return add({name, Type::text, "", text, std::move(fallback)});
}

Spec& Spec::choice(const std::string& name, const std::string& text, Texts choices, Value fallback) {
  return add({name, Type::text, "", text, std::move(fallback), Range::any(), std::move(choices)});
}

Spec& Spec::reals(const std::string& name, const std::string& unit, const std::string& text, Value fallback,
                  Range range) {
  return add({name, Type::reals, unit, text, std::move(fallback), range});
}

Spec& Spec::words(const std::string& name, const std::string& text, Value fallback) {
  return add({name, Type::texts, "", text, std::move(fallback)});
}

Spec& Spec::list(Spec spec, bool is_required) {
  lists_.emplace_back(std::move(spec), is_required);
  return *this;
}

Spec& Spec::entries(Spec spec, int least) {
  entry_ = std::make_shared<Spec>(std::move(spec));
  least_entries_ = least;
  return *this;
}

Spec& Spec::variant(const std::string& selector, const std::string& text, std::vector<Spec> variants, Value fallback) {
  Texts names;
  for (const Spec& one : variants) names.push_back(one.name());
  choice(selector, text, std::move(names), std::move(fallback));
  variants_.emplace_back(selector, std::move(variants));
  return *this;
}

Spec& Spec::completed_by(Completion completion) {
  completion_ = std::move(completion);
  return *this;
}

}  // namespace toile::base
