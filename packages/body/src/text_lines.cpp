#include "text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr double largest_coordinate = 1e15;  ///< in any unit; a person in nanometres has 2e9
constexpr std::string_view spaces = " \t\v\f";

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

/// Adds the words of `line`; true if a '\' at its end asks for the next line.
bool split(std::string_view line, bool comments, bool continued, std::vector<std::string_view>* words) {
  const auto first = line.find_first_not_of(spaces);
  if (first == std::string_view::npos) {
    return false;
  }
  const auto hash = comments ? line.find('#') : std::string_view::npos;
  line = line.substr(0, hash);
  bool goes_on = false;
  const auto last = line.find_last_not_of(spaces);
  if (continued && hash == std::string_view::npos && last != std::string_view::npos && line[last] == '\\') {
    goes_on = true;
    line = line.substr(0, last);
  }
  for (auto begin = line.find_first_not_of(spaces); begin != std::string_view::npos;) {
    const auto end = std::min(line.find_first_of(spaces, begin), line.size());
    words->push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(spaces, end);
  }
  return goes_on;
}

}  // namespace

std::string shown(std::string_view word) {
  constexpr std::size_t most = 30;
  std::string text(word.substr(0, most));
  for (char& c : text) {
    c = static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  }
  return "'" + text + (word.size() > most ? "..." : "") + "'";
}

double to_real(std::string_view word, const std::string& where) {
  const std::string_view digits = without_plus(word);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
    throw base::InputError(where + ": " + shown(word) + " is not a number");
  }
  if (error == std::errc::result_out_of_range) {  // too small is zero, too large infinite
    value = std::strtod(std::string(digits).c_str(), nullptr);
  }
  if (!std::isfinite(value)) {
    throw base::InputError(where + ": " + shown(word) + " is not a finite number");
  }
  return value;
}

long to_integer(std::string_view word, const std::string& where) {
  const std::string_view digits = without_plus(word);
  long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw base::InputError(where + ": " + shown(word) + " is not a whole number");
  }
  return value;
}

void check_coordinates(const Vec3& point, const std::string& where) {
  for (const double x : point) {
    if (!std::isfinite(x)) {
      throw base::InputError(where + ": a vertex has a coordinate that is not a finite number");
    }
    if (std::abs(x) > largest_coordinate) {
      throw base::InputError(where + ": a vertex has the coordinate " + std::to_string(x).substr(0, 8) +
                             "..., too large for a body in any unit");
    }
  }
}

TextLines::TextLines(std::string file, std::string_view text, bool comments, bool continued)
    : file_(std::move(file)), text_(text), comments_(comments), continued_(continued) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) {
    text_.remove_prefix(byte_order_mark.size());
  }
}

std::string_view TextLines::take_line() {
  const auto end = std::min(text_.find_first_of("\r\n"), text_.size());
  const std::string_view line = text_.substr(0, end);
  const std::size_t ending = text_.substr(end, 2) == "\r\n" ? 2 : 1;
  text_.remove_prefix(std::min(end + ending, text_.size()));
  ++lines_read_;
  return line;
}

bool TextLines::next() {
  words_.clear();
  while (words_.empty() && !text_.empty()) {
    number_ = lines_read_ + 1;
    while (split(take_line(), comments_, continued_, &words_) && !text_.empty()) {
    }
  }
  return !words_.empty();
}

void TextLines::fail(const std::string& what) const {
  throw base::InputError(where() + ": " + what);
}

Vec3 TextLines::point(std::size_t first_word) const {
  Vec3 point(real(first_word), real(first_word + 1), real(first_word + 2));
  check_coordinates(point, where());
  return point;
}

}  // namespace toile::body
