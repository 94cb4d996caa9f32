#include <cctype>
#include <string>
#include <vector>

#include "formula_program.hpp"

namespace toile::material::formula {
namespace {

/// Each level takes a few hundred bytes of the stack in the parser and in the translator.
constexpr int deepest = 200;
constexpr std::size_t longest = 100000;

/// How deep the place is that the parser would be in: parentheses, and powers and signs, which nest to the right.
class Nesting {
 public:
  /// Takes the next character that is not a blank.
  void take(char c) {
    const bool operand_follows = last_ == '\0' || std::string("+-*/^(,<>=;").find(last_) != std::string::npos;
    const bool sign = c == '+' || c == '-';
    if (sign && (last_ == 'e' || last_ == 'E')) {
      // Perhaps of the exponent of a number: counting too much does no harm.
    } else if (c == '(') {
      outer_.push_back(chain_);
      depth_ += chain_ + 1;
      chain_ = 0;
    } else if (c == ')' && !outer_.empty()) {
      chain_ = outer_.back();
      depth_ -= chain_ + 1;
      outer_.pop_back();
    } else if (c == '^' || (operand_follows && sign)) {
      ++chain_;
    } else if (std::string("+-*/,<>;").find(c) != std::string::npos) {
      chain_ = 0;
    }
    last_ = c;
  }
  int depth() const { return depth_ + chain_; }

 private:
  std::vector<int> outer_;  ///< chain_ outside of each parenthesis that is open
  int depth_ = 0;           ///< of the innermost one
  int chain_ = 0;           ///< powers and signs in a row
  char last_ = '\0';
};

}  // namespace

void check_nesting(const std::string& text) {
  if (text.size() > longest)
    throw Problem(longest, "the formula has more than " + std::to_string(longest) + " characters");
  Nesting nesting;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (std::isspace(static_cast<unsigned char>(text[k])) != 0) continue;
    nesting.take(text[k]);
    if (nesting.depth() > deepest)
      throw Problem(k, "parentheses, signs and powers are nested more than " + std::to_string(deepest) + " deep");
  }
}

}  // namespace toile::material::formula
