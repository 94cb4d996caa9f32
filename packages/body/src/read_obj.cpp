#include <algorithm>
#include <array>

#include "body_file.hpp"
#include "text_lines.hpp"

namespace toile::body {
namespace {

/// What says nothing about the shape of the facets: texture, normals, groups, smoothing, materials, display.
constexpr std::array<std::string_view, 17> harmless{"vt",  "vn",       "vp",       "g",          "o",        "s",
                                                    "mg",  "usemtl",   "mtllib",   "usemap",     "maplib",   "bevel",
                                                    "lod", "c_interp", "d_interp", "shadow_obj", "trace_obj"};
/// Curved surfaces, which would be missing if they were left out.
constexpr std::array<std::string_view, 16> curved{"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",  "parm",
                                                  "trim",   "hole", "scrv", "sp",   "end",  "con",   "ctech", "stech"};

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Index of the vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn", from 1; negative ones count back from the last.
long corner(const TextLines& lines, std::string_view word, long points) {
  const auto slash = std::min(word.find('/'), word.size());
  const std::string_view others = word.substr(slash);
  if (others.find_first_not_of("/-0123456789") != std::string_view::npos ||
      std::count(others.begin(), others.end(), '/') > 2) {
    lines.fail(shown(word) + " is not a corner of a facet: v, v/vt, v//vn or v/vt/vn");
  }
  const long index = to_integer(word.substr(0, slash), lines.where());
  if (index == 0 || index < -points) {
    lines.fail("the corner " + shown(word) + " is not there: vertices count from 1, or from -1 backwards over the " +
               std::to_string(points) + " before this line");
  }
  return index > 0 ? index : points + 1 + index;
}

}  // namespace

BodyFile read_obj(const std::string& file, std::string_view text) {
  TextLines lines(file, text, true, true);
  SoupBuilder soup(file, "line", 1);
  long loose = 0;
  while (lines.next()) {
    const auto& words = lines.words();
    const std::string_view keyword = words[0];
    const std::size_t values = words.size() - 1;
    if (keyword == "v") {
      // x y z, with a weight, a colour, or both
      if (values != 3 && values != 4 && values != 6 && values != 7) {
        lines.fail("a vertex 'v' needs x y z, perhaps with a weight or a colour, found " + std::to_string(values) +
                   " values");
      }
      soup.add_point(lines.point(1));
    } else if (keyword == "f") {
      std::vector<long> corners;
      for (std::size_t i = 1; i < words.size(); ++i) {
        corners.push_back(corner(lines, words[i], soup.points()));
      }
      soup.add_polygon(lines.number(), corners);
    } else if (keyword == "l" || keyword == "p") {
      ++loose;
    } else if (contains(curved, keyword)) {
      lines.fail("the curved surfaces of " + shown(keyword) + " are not read: export the body as facets");
    } else if (!contains(harmless, keyword)) {
      lines.fail("the keyword " + shown(keyword) + " is not known in an OBJ file; facets are 'f', vertices 'v'");
    }
  }
  BodyFile result;
  result.soup = soup.finish();
  if (loose > 0) {
    result.notes = std::to_string(loose) + " loose lines or points left out";
  }
  return result;
}

}  // namespace toile::body
