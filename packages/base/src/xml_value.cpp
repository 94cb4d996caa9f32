#include "xml_value.hpp"

#include <Teuchos_Array.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "text.hpp"

namespace toile::base {
namespace {

std::optional<bool> flag_of(const std::string& word) {
  if (word != "true" && word != "false") return std::nullopt;
  return word == "true";
}

template <class Number>
std::optional<Number> number_of(const std::string& word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  Number value{};
  const auto [end, error] = std::from_chars(word.data() + (plus ? 1 : 0), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<std::string> word_of(const std::string& word) {
  if (word.empty()) return std::nullopt;
  return word;
}

/// The entries of "{a, b, c}"; empty if the braces are missing.
std::optional<Texts> entries_of(const std::string& text) {
  if (text.size() < 2 || text.front() != '{' || text.back() != '}') return std::nullopt;
  const std::string inside = trimmed(text.substr(1, text.size() - 2));
  Texts entries;
  for (std::size_t begin = 0; begin <= inside.size() && !inside.empty();) {
    const std::size_t end = std::min(inside.find(',', begin), inside.size());
    entries.push_back(trimmed(inside.substr(begin, end - begin)));
    begin = end + 1;
  }
  return entries;
}

std::string expected(const std::string& type) {
  if (type == "bool") return "true or false";
  if (type == "Array(string)") return "words in braces, for instance {a, b}";
  if (type.rfind("Array", 0) == 0) return "numbers in braces, for instance {1, 2}";
  return type == "int" ? "a whole number" : "a number";
}

std::string refusal(const std::string& type, const std::string& text) {
  return " is \"" + text + "\", expected " + expected(type) + " (" + type + ")";
}

/// Only doubles can be something else.
template <class Value>
bool is_finite(const Value& value) {
  if constexpr (std::is_same_v<Value, double>) return std::isfinite(value);
  return true;
}

/// `read` takes one trimmed word.
template <class Value>
std::string set_one(Teuchos::ParameterList& list, const std::string& name, const std::string& type,
                    const std::string& text, std::optional<Value> (*read)(const std::string&)) {
  const std::optional<Value> value = read(trimmed(text));
  if (!value) return refusal(type, text);
  if (!is_finite(*value)) return " is " + trimmed(text) + ", not a finite number";
  list.set(name, *value);
  return "";
}

template <class Value>
std::string set_array(Teuchos::ParameterList& list, const std::string& name, const std::string& type,
                      const std::string& text, std::optional<Value> (*read)(const std::string&)) {
  const std::optional<Texts> entries = entries_of(trimmed(text));
  if (!entries) return refusal(type, text);
  Teuchos::Array<Value> values;
  for (const std::string& entry : *entries) {
    const std::optional<Value> value = read(entry);
    if (!value) return refusal(type, text);
    if (!is_finite(*value))
      return ", value number " + std::to_string(values.size() + 1) + ", is " + entry + ", not a finite number";
    values.push_back(*value);
  }
  list.set(name, values);
  return "";
}

}  // namespace

const Texts& xml_types() {
  static const Texts all = {"double", "int", "bool", "string", "Array(double)", "Array(int)", "Array(string)"};
  return all;
}

std::string set_value(Teuchos::ParameterList& list, const std::string& name, const std::string& type,
                      const std::string& text) {
  if (type == "double") return set_one(list, name, type, text, number_of<double>);
  if (type == "int") return set_one(list, name, type, text, number_of<int>);
  if (type == "bool") return set_one(list, name, type, text, flag_of);
  if (type == "Array(double)") return set_array(list, name, type, text, number_of<double>);
  if (type == "Array(int)") return set_array(list, name, type, text, number_of<int>);
  if (type == "Array(string)") return set_array(list, name, type, text, word_of);
  if (type != "string") return " has the unknown type \"" + type + "\"" + hint(type, xml_types());
  list.set(name, text);
  return "";
}

}  // namespace toile::base
