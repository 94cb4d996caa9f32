#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// A finite number of a word, with its place in messages: "<where>: 'nan' is not a finite number". Throws InputError.
double to_real(std::string_view word, const std::string& where);
/// The same for a whole number.
long to_integer(std::string_view word, const std::string& where);
/// Throws InputError for a coordinate that is not finite or so large that no body has it.
void check_coordinates(const Vec3& point, const std::string& where);

/// The words of a text, line by line; lines without words are left out. The text must outlive this.
class TextLines {
 public:
  /// `comments`: what follows a '#' is left out. `continued`: a '\' at the end of a line goes on with the next.
  TextLines(std::string file, std::string_view text, bool comments, bool continued = false);

  /// Reads the next line that holds a word; false at the end of the text.
  bool next();
  const std::vector<std::string_view>& words() const { return words_; }
  long number() const { return number_; }  ///< of the line just read, from 1
  std::string where() const { return file_ + ": line " + std::to_string(number_); }
  [[noreturn]] void fail(const std::string& what) const;
  double real(std::size_t word) const { return to_real(words_[word], where()); }
  long integer(std::size_t word) const { return to_integer(words_[word], where()); }
  Vec3 point(std::size_t first_word) const;        ///< three words
  std::string_view rest() const { return text_; }  ///< what was not read yet

 private:
  std::string_view take_line();

  std::string file_;
  std::string_view text_;
  bool comments_, continued_;
  std::vector<std::string_view> words_;
  long number_ = 0;  ///< where the line just read begins
  long lines_read_ = 0;
};

/// A word for a message: not longer than 30 characters, without control characters.
std::string shown(std::string_view word);

}  // namespace toile::body
