// Faults at random places of a text, the same ones everywhere.
#pragma once

#include <cstddef>
#include <iterator>
#include <random>
#include <string>

namespace toile::test {

/// Changes one or two places of a text: a letter, some that are lost, repeated or cut off at the end, a value between
/// quotes. None of the standard's distributions, which differ from library to library.
class Mutation {
 public:
  explicit Mutation(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (int k = below(4) / 2; k >= 0; --k) mutate(text);
    return text;
  }

 private:
  int below(std::size_t limit) { return static_cast<int>(random_() % limit); }

  void mutate(std::string& text) {
    if (text.empty()) return;
    static const std::string letters = "<>/\"= {},.-+0159eExanif&;!?\\\n\t\xE9\x01";
    static const char* const words[] = {"nan", "inf", "1e999", "-1", "2147483647", "0", "",  "<!--",
                                        "-->", "]]>", "&#0;",  "3",  "0.5",        "y", "z", "strip"};
    const auto at = static_cast<std::size_t>(below(text.size()));
    const auto length = static_cast<std::size_t>(1 + below(40));
    switch (below(8)) {
      case 0:
        text[at] = letters[static_cast<std::size_t>(below(letters.size()))];
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(static_cast<std::size_t>(below(text.size())), length));
        break;
      case 4:
        text.resize(at + 1);
        break;
      default:
        replace_value(text, words[below(std::size(words))]);
    }
  }

  /// One of the values between quotes.
  void replace_value(std::string& text, const std::string& word) {
    const std::size_t value = text.find("value=\"", static_cast<std::size_t>(below(text.size())));
    if (value == std::string::npos) return;
    const std::size_t begin = value + 7, end = text.find('"', begin);
    if (end != std::string::npos) text.replace(begin, end - begin, word);
  }

  std::mt19937 random_;
};

}  // namespace toile::test
