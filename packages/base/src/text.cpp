#include "text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <iterator>

namespace toile::base {
namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string quoted(const std::string& word) {
  return '"' + word + '"';
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b) {
  const std::size_t n = b.size();
  std::vector<int> before_last(n + 1), last(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1])) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[n];
}

std::string nearest_name(const std::string& name, const Texts& valid) {
  std::string nearest;
  int smallest = 1 + std::max<int>(1, static_cast<int>(name.size()) / 3);
  for (const std::string& candidate : valid) {
    const int distance = edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string join(const Texts& words, const std::string& separator) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : separator) + word;
  return joined;
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(buffer.data(), end);
}

std::string value_text(const Value& value) {
  struct Printer {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(double x) const { return number_text(x); }
    std::string operator()(int x) const { return std::to_string(x); }
    std::string operator()(bool x) const { return x ? "true" : "false"; }
    std::string operator()(const std::string& x) const { return quoted(x); }
    std::string operator()(const Reals& values) const {
      Texts texts;
      std::transform(values.begin(), values.end(), std::back_inserter(texts), number_text);
      return '{' + join(texts, ", ") + '}';
    }
    std::string operator()(const Texts& values) const {
      Texts texts;
      std::transform(values.begin(), values.end(), std::back_inserter(texts), quoted);
      return '{' + join(texts, ", ") + '}';
    }
  };
  return std::visit(Printer{}, value);
}

std::string type_text(Type type) {
  switch (type) {
    case Type::real:
      return "double";
    case Type::integer:
      return "int";
    case Type::flag:
      return "bool";
    case Type::text:
      return "string";
    case Type::reals:
      return "Array(double)";
    case Type::texts:
      return "Array(string)";
  }
  return "";
}

std::string hint(const std::string& name, const Texts& valid) {
  const std::string nearest = nearest_name(name, valid);
  const std::string mean = nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?";
  if (valid.empty()) return mean + "; nothing is valid here";
  return mean + (nearest.empty() ? ". Valid here: " : " Valid here: ") + join(valid, ", ");
}

}  // namespace toile::base
