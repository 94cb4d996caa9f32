#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polygon_soup.hpp"

namespace toile::body {

/// What a file holds, in its own unit and axes.
struct BodyFile {
  PolygonSoup soup;   ///< finite points; every corner is a point, every polygon has three corners or more
  std::string notes;  ///< what of the file is no surface and was left out; empty if nothing
};

/// Reads OBJ, STL, PLY or OFF (by extension). Throws InputError with the file, the line (or the number of the facet or
/// vertex in a binary file) and what was found there for all that it does not understand.
BodyFile read_body_file(const std::string& file);

BodyFile read_obj(const std::string& file, std::string_view text);
BodyFile read_off(const std::string& file, std::string_view text);
BodyFile read_ply(const std::string& file, std::string_view text);
BodyFile read_stl(const std::string& file, std::string_view text);

/// Collects a soup whose corners may be named before the points, with the place of each polygon for messages.
class SoupBuilder {
 public:
  /// `place`: "line" or "facet"; `first`: index of the first point in the file's own counting.
  SoupBuilder(std::string file, std::string place, long first)
      : file_(std::move(file)), place_(std::move(place)), first_(first) {}
  void add_point(const Vec3& point) { soup_.points.push_back(point); }
  void add_polygon(long place, const std::vector<long>& corners);
  long points() const { return static_cast<long>(soup_.points.size()); }
  /// Throws InputError for a corner that is no point, a polygon of fewer than three corners, and if there is none.
  PolygonSoup finish();

 private:
  std::string file_;
  std::string place_;
  long first_;
  PolygonSoup soup_;
  std::vector<long> places_;
};

}  // namespace toile::body
