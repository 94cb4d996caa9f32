#include <algorithm>

#include "body_file.hpp"
#include "text_lines.hpp"

namespace toile::body {
namespace {

/// "OFF" with letters before it for normals, colours and texture, which follow x y z and are left out.
void check_head(const TextLines& lines) {
  const std::string_view word = lines.words()[0];
  const bool known = word.size() >= 3 && word.substr(word.size() - 3) == "OFF" &&
                     word.substr(0, word.size() - 3).find_first_not_of("STCN") == std::string_view::npos;
  if (!known) {
    lines.fail("an OFF file begins with OFF (or COFF, NOFF, STOFF), found " + shown(word));
  }
  if (lines.words().size() > 1 && lines.words()[1] == "BINARY") {
    lines.fail("binary OFF is not read: write it as text, or as PLY");
  }
}

/// Next line, the one of the (i + 1)-th of `count` items.
void need_line(TextLines* lines, const std::string& item, long i, long count) {
  if (!lines->next()) {
    lines->fail("the file ends after " + std::to_string(i) + " of the " + std::to_string(count) + " " + item +
                " that its head announces");
  }
}

}  // namespace

BodyFile read_off(const std::string& file, std::string_view text) {
  TextLines lines(file, text, true);
  SoupBuilder soup(file, "line", 0);
  need_line(&lines, "lines", 0, 1);
  check_head(lines);
  std::size_t first = 1;  // the numbers may stand beside the word OFF
  if (lines.words().size() == 1) {
    need_line(&lines, "lines", 1, 2);
    first = 0;
  }
  if (lines.words().size() < first + 2) {
    lines.fail("here the numbers of vertices and facets are due");
  }
  const long points = lines.integer(first);
  const long facets = lines.integer(first + 1);
  if (points < 0 || facets < 0) {
    lines.fail("the numbers of vertices and facets must not be negative");
  }
  for (long i = 0; i < points; ++i) {
    need_line(&lines, "vertices", i, points);
    if (lines.words().size() < 3) {
      lines.fail("a vertex needs x y z, found " + std::to_string(lines.words().size()) + " values");
    }
    soup.add_point(lines.point(0));
  }
  for (long i = 0; i < facets; ++i) {
    need_line(&lines, "facets", i, facets);
    const long corners = lines.integer(0);
    const long values = static_cast<long>(lines.words().size()) - 1;
    if (corners < 3 || corners > values) {
      lines.fail("a facet of " + shown(lines.words()[0]) + " corners is not possible here: three or more, and " +
                 std::to_string(values) + " values follow in its line");
    }
    std::vector<long> polygon;
    for (long k = 1; k <= corners; ++k) {
      polygon.push_back(lines.integer(k));
    }
    soup.add_polygon(lines.number(), polygon);
  }
  if (lines.next()) {
    lines.fail("the file goes on after the " + std::to_string(facets) + " facets that its head announces");
  }
  return {soup.finish(), ""};
}

}  // namespace toile::body
