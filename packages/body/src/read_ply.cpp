#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "body_file.hpp"
#include "text_lines.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

struct Head {
  bool text = true, big_endian = false;
  std::vector<Element> elements;
};

Type to_type(const TextLines& lines, std::string_view word) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (word == names[i][0] || word == names[i][1]) return static_cast<Type>(i);
  }
  lines.fail(shown(word) + " is not a type of PLY: char, uchar, short, ushort, int, uint, float, double");
}

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

Property read_property(const TextLines& lines) {
  const auto& words = lines.words();
  if (words.size() == 5 && words[1] == "list") {
    const Type count = to_type(lines, words[2]);
    if (count == Type::float32 || count == Type::float64) lines.fail("the length of a list must be a whole number");
    return {std::string(words[4]), to_type(lines, words[3]), count};
  }
  if (words.size() != 3) lines.fail("a property needs a type and a name, or 'list', two types and a name");
  return {std::string(words[2]), to_type(lines, words[1]), std::nullopt};
}

void read_format(const TextLines& lines, Head* head) {
  const auto& words = lines.words();
  const std::string_view format = words.size() == 3 ? words[1] : "";
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian") {
    lines.fail("the format must be ascii, binary_little_endian or binary_big_endian, and its version 1.0");
  }
  head->text = format == "ascii";
  head->big_endian = format == "binary_big_endian";
}

Head read_head(TextLines* lines) {
  if (!lines->next() || lines->words()[0] != "ply") lines->fail("a PLY file begins with 'ply'");
  Head head;
  bool has_format = false;
  while (lines->next() && lines->words()[0] != "end_header") {
    const auto& words = lines->words();
    if (words[0] == "format") {
      read_format(*lines, &head);
      has_format = true;
    } else if (words[0] == "element") {
      if (words.size() != 3) lines->fail("an element needs a name and a number");
      head.elements.push_back({std::string(words[1]), lines->integer(2), {}});
      if (head.elements.back().count < 0) lines->fail("the number of elements must not be negative");
    } else if (words[0] == "property") {
      if (head.elements.empty()) lines->fail("a property before any element");
      head.elements.back().properties.push_back(read_property(*lines));
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      lines->fail("the keyword " + shown(words[0]) + " is not known in the head of a PLY file");
    }
  }
  if (lines->words().empty()) lines->fail("the file ends before 'end_header'");
  if (!has_format) lines->fail("the head names no format");
  return head;
}

/// The numbers behind the head, row by row.
class Rows {
 public:
  Rows(std::string file, const Head& head, TextLines* lines)
      : file_(std::move(file)), head_(head), lines_(lines), bytes_(lines->rest()) {}

  void begin(const Element& element, long row) {
    row_ = element.name + " " + std::to_string(row + 1) + " of " + std::to_string(element.count);
    word_ = 0;
    if (head_.text && !lines_->next()) fail("the file ends before it");
  }
  void end() const {
    if (head_.text && word_ < lines_->words().size()) fail("more values than its properties");
  }
  double number(Type type);
  long whole(Type type) {
    const double value = number(type);
    if (value != std::floor(value) || std::abs(value) > 4294967295.0) fail("a whole number is due");
    return static_cast<long>(value);
  }
  /// Length of a list of that type.
  long length(const Property& list) {
    const long count = whole(*list.count);
    const std::size_t left = head_.text ? lines_->words().size() - word_ : bytes_.size() / size_of(list.type);
    if (count < 0 || static_cast<std::size_t>(count) > left) {
      fail("the list '" + list.name + "' announces " + std::to_string(count) + " values, and " + std::to_string(left) +
           " follow");
    }
    return count;
  }
  void finish() {
    if (head_.text ? lines_->next() : bytes_.find_first_not_of("\r\n") != std::string_view::npos) {
      throw base::InputError(file_ + ": the file goes on after the elements that its head announces");
    }
  }
  [[noreturn]] void fail(const std::string& what) const { throw base::InputError(where() + ": " + what); }
  std::string where() const { return head_.text ? lines_->where() + ": " + row_ : file_ + ": " + row_; }

 private:
  template <class Number>
  double take(const std::array<char, 8>& bytes) const {
    Number value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  }

  std::string file_;
  const Head& head_;
  TextLines* lines_;
  std::string_view bytes_;
  std::string row_;
  std::size_t word_ = 0;
};

double Rows::number(Type type) {
  if (head_.text) {
    if (word_ >= lines_->words().size()) fail("fewer values than its properties");
    return lines_->real(word_++);
  }
  const std::size_t size = size_of(type);
  if (bytes_.size() < size) fail("the file ends within it");
  std::array<char, 8> bytes{};
  for (std::size_t i = 0; i < size; ++i) bytes[i] = bytes_[head_.big_endian ? size - 1 - i : i];
  bytes_.remove_prefix(size);
  switch (type) {
    case Type::int8:
      return take<std::int8_t>(bytes);
    case Type::uint8:
      return take<std::uint8_t>(bytes);
    case Type::int16:
      return take<std::int16_t>(bytes);
    case Type::uint16:
      return take<std::uint16_t>(bytes);
    case Type::int32:
      return take<std::int32_t>(bytes);
    case Type::uint32:
      return take<std::uint32_t>(bytes);
    case Type::float32:
      return take<float>(bytes);
    case Type::float64:
      break;
  }
  return take<double>(bytes);
}

bool is_corners(const Element& element, const Property& property) {
  return element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void check_elements(const std::string& file, const Head& head) {
  std::array<int, 4> found{};  // x, y, z, corners
  for (const Element& element : head.elements) {
    if (element.properties.empty()) {
      throw base::InputError(file + ": the element '" + element.name + "' has no property");
    }
    if (element.name == "tristrips") {
      throw base::InputError(file + ": strips of triangles are not read: export the body as facets");
    }
    for (const Property& property : element.properties) {
      const bool coordinate =
          element.name == "vertex" && (property.name == "x" || property.name == "y" || property.name == "z");
      const bool corners = is_corners(element, property);
      if ((coordinate || corners) && property.count.has_value() != corners) {
        throw base::InputError(file + ": the property '" + property.name + "' of '" + element.name + "' must be " +
                               (corners ? "a list" : "a number, not a list"));
      }
      if (coordinate) ++found[property.name[0] - 'x'];
      if (corners) ++found[3];
    }
  }
  if (found != std::array<int, 4>{1, 1, 1, 1}) {
    throw base::InputError(file +
                           ": the head must have one 'vertex' with x, y, z and one 'face' with the list "
                           "'vertex_indices'");
  }
}

void read_row(const Element& element, long row, Rows* rows, SoupBuilder* soup) {
  rows->begin(element, row);
  Vec3 point = Vec3::Zero();
  for (const Property& property : element.properties) {
    if (property.count) {
      std::vector<long> corners(rows->length(property));
      const bool wanted = is_corners(element, property);
      for (long& corner : corners) corner = wanted ? rows->whole(property.type) : (rows->number(property.type), 0);
      if (wanted) soup->add_polygon(row + 1, corners);
      continue;
    }
    const double value = rows->number(property.type);
    if (element.name == "vertex" && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z') {
      point[property.name[0] - 'x'] = value;
    }
  }
  rows->end();
  if (element.name == "vertex") {
    check_coordinates(point, rows->where());
    soup->add_point(point);
  }
}

}  // namespace

BodyFile read_ply(const std::string& file, std::string_view text) {
  TextLines lines(file, text, false);
  const Head head = read_head(&lines);
  check_elements(file, head);
  SoupBuilder soup(file, "face", 0);
  Rows rows(file, head, &lines);
  for (const Element& element : head.elements) {
    for (long row = 0; row < element.count; ++row) {
      read_row(element, row, &rows, &soup);
    }
  }
  rows.finish();
  return {soup.finish(), ""};
}

}  // namespace toile::body
