#include <algorithm>
#include <cstdint>
#include <cstring>

#include "body_file.hpp"
#include "text_lines.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr std::size_t head_size = 84, facet_size = 50;  ///< bytes of a binary file

template <class Number>
Number number_at(std::string_view text, std::size_t position) {
  Number value;
  std::memcpy(&value, text.data() + position, sizeof value);  // both are little-endian
  return value;
}

BodyFile read_binary(const std::string& file, std::string_view text, std::size_t facets) {
  SoupBuilder soup(file, "facet", 0);
  for (std::size_t i = 0; i < facets; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 point;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        point[axis] = number_at<float>(text, head_size + i * facet_size + 12 + corner * 12 + axis * 4);
      }
      check_coordinates(point, file + ": facet " + std::to_string(i + 1) + ", corner " + std::to_string(corner + 1));
      soup.add_point(point);
    }
    const long last = soup.points() - 1;
    soup.add_polygon(static_cast<long>(i + 1), {last - 2, last - 1, last});
  }
  return {soup.finish(), ""};
}

/// The words of a line in lower case, as far as they are keywords.
bool begins_with(const TextLines& lines, const std::vector<std::string_view>& keywords) {
  if (lines.words().size() < keywords.size()) {
    return false;
  }
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  for (std::size_t i = 0; i < keywords.size(); ++i) {
    const std::string_view word = lines.words()[i];
    if (!std::equal(word.begin(), word.end(), keywords[i].begin(), keywords[i].end(), same)) {
      return false;
    }
  }
  return true;
}

void need(TextLines* lines, const std::vector<std::string_view>& keywords, std::size_t words) {
  std::string wanted;
  for (const std::string_view keyword : keywords) {
    wanted += (wanted.empty() ? "" : " ") + std::string(keyword);
  }
  if (!lines->next()) {
    lines->fail("the file ends where '" + wanted + "' is due");
  }
  if (!begins_with(*lines, keywords) || lines->words().size() < words) {
    lines->fail("'" + wanted + "' is due, found " + shown(lines->words()[0]));
  }
}

BodyFile read_text(const std::string& file, std::string_view text) {
  TextLines lines(file, text, false);
  SoupBuilder soup(file, "line", 0);
  bool open = false;
  while (lines.next()) {
    if (!open) {
      if (!begins_with(lines, {"solid"})) lines.fail("'solid' is due, found " + shown(lines.words()[0]));
      open = true;
    } else if (begins_with(lines, {"endsolid"})) {
      open = false;
    } else if (begins_with(lines, {"facet", "normal"})) {
      const long line = lines.number();  // the normal is not read: the order of the corners says the same
      need(&lines, {"outer", "loop"}, 2);
      for (int corner = 0; corner < 3; ++corner) {
        need(&lines, {"vertex"}, 4);
        soup.add_point(lines.point(1));
      }
      need(&lines, {"endloop"}, 1);
      need(&lines, {"endfacet"}, 1);
      soup.add_polygon(line, {soup.points() - 3, soup.points() - 2, soup.points() - 1});
    } else {
      lines.fail("'facet normal' or 'endsolid' is due, found " + shown(lines.words()[0]));
    }
  }
  if (open) {
    lines.fail("the file ends without 'endsolid': its end is missing");
  }
  return {soup.finish(), ""};
}

}  // namespace

BodyFile read_stl(const std::string& file, std::string_view text) {
  const std::size_t facets = text.size() >= head_size ? number_at<std::uint32_t>(text, head_size - 4) : 0;
  if (text.size() >= head_size && text.size() == head_size + facets * facet_size) {
    return read_binary(file, text, facets);
  }
  // Some binary files begin with "solid" too, but their bytes are no text.
  const bool is_text = text.substr(0, std::min(text.size(), head_size)).find('\0') == std::string_view::npos;
  if (is_text) {
    return read_text(file, text);
  }
  throw base::InputError(file + ": is neither text nor a whole binary STL: of its " + std::to_string(text.size()) +
                         " bytes, " + std::to_string(head_size) + " are the head, which announces " +
                         std::to_string(facets) + " facets of " + std::to_string(facet_size) + " bytes");
}

}  // namespace toile::body
