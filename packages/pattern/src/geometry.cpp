#include "geometry.hpp"

#include <sstream>

#include "ring.hpp"

namespace toile::pattern {
namespace {

std::string reason(bg::validity_failure_type failure, const std::string& detail) {
  // The library tells the place as "(x, y)" in its own sentence.
  const std::size_t at = detail.find('('), end = detail.find(')');
  const std::string place = at == std::string::npos || end == std::string::npos
                                ? ""
                                : " near " + detail.substr(at, end - at + 1) + " mm of its pattern";
  switch (failure) {
    case bg::failure_spikes:
      return "the outline folds back on itself" + place;
    case bg::failure_self_intersections:
    case bg::failure_disconnected_interior:
      return "it overlaps itself" + place + "; its outline must not cross or touch itself or a hole";
    case bg::failure_interior_rings_outside:
      return "a hole lies outside of the outline" + place;
    case bg::failure_nested_interior_rings:
    case bg::failure_intersecting_interiors:
      return "two holes overlap" + place;
    case bg::failure_wrong_orientation:
      return "the outline must run counter-clockwise and holes clockwise, seen from the right side of the fabric";
    default:
      return "its outline encloses no piece of fabric: " + detail;
  }
}

Line ring_line(const Loop& loop) {
  const Polygon::ring_type points = ring(loop);
  return Line(points.begin(), points.end());
}

/// The library lets a hole touch the outline in single points; a mesh does not.
std::string touching(const Panel& panel) {
  std::vector<Line> lines;
  const auto add = [&lines](const Loop& loop) {
    const Polygon::ring_type points = ring(loop);
    lines.emplace_back(points.begin(), points.end());
  };
  add(panel.outline);
  for (const Loop& hole : panel.holes) add(hole);
  for (std::size_t i = 1; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (bg::intersects(lines[i], lines[j]))
        return "the hole with edge \"" + panel.holes[i - 1].front().name + "\" touches or crosses " +
               (j == 0 ? "the outline" : "the hole with edge \"" + panel.holes[j - 1].front().name + "\"");
  return "";
}

/// Where two edges of the outline meet apart from their common corner, as the library would tell it; empty: nowhere.
std::string crossing(const Loop& loop) {
  std::vector<Line> edges;
  for (const Edge& edge : loop) {
    edges.emplace_back();
    for (const Vec2& p : edge.curve.points(chord * edge.curve.length())) edges.back().emplace_back(p.x(), p.y());
  }
  for (std::size_t i = 1; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::vector<Point> common;
      bg::intersection(edges[i], edges[j], common);
      const double near = chord * (bg::length(edges[i]) + bg::length(edges[j]));
      for (const Point& p : common) {
        const auto is_corner = [&](const Line& edge) {
          return bg::distance(p, edge.front()) <= near || bg::distance(p, edge.back()) <= near;
        };
        if (is_corner(edges[i]) && is_corner(edges[j])) continue;
        std::ostringstream text;
        text << "(" << p.x() << ", " << p.y() << ")";
        return text.str();
      }
    }
  return "";
}

}  // namespace

double signed_area(const Loop& loop) {
  return bg::area(Polygon{ring(loop)});
}

bool lies_on(const Panel& panel, const Vec2& point) {
  Polygon polygon = polygon_of(panel);
  bg::correct(polygon);
  return bg::covered_by(Point(point.x(), point.y()), polygon);
}

std::string problem_of_lines(const Panel& panel) {
  Polygon polygon = polygon_of(panel);
  // Ends lie on a curve, and so a little beside the polygon that stands for it.
  const double near = 10.0 * chord * bg::length(ring_line(panel.outline));
  const auto text = [](const Point& p) {
    std::ostringstream out;
    out << " near (" << p.x() << ", " << p.y() << ") mm";
    return out.str();
  };
  std::vector<Line> lines;
  for (const InternalLine& line : panel.lines) {
    lines.emplace_back();
    for (const Vec2& p : line.curve.points(chord * line.curve.length())) lines.back().emplace_back(p.x(), p.y());
    std::vector<Line> outside;
    bg::difference(lines.back(), polygon, outside);
    for (const Line& part : outside)
      if (bg::length(part) > near)
        return "line \"" + line.name + "\" leaves the panel" + text(part.front()) + "; end it at an edge";
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
      std::vector<Point> common;
      bg::intersection(lines[k], lines.back(), common);
      for (const Point& p : common) {
        const auto is_end = [&](const Line& l) {
          return bg::distance(p, l.front()) <= near || bg::distance(p, l.back()) <= near;
        };
        if (!is_end(lines[k]) && !is_end(lines.back()))
          return "lines \"" + panel.lines[k].name + "\" and \"" + line.name + "\" cross" + text(p) +
                 "; divide one of them into two lines that end there";
      }
    }
  }
  return "";
}

std::string why_invalid(const Panel& panel) {
  Polygon polygon = polygon_of(panel);
  if (std::string problem = touching(panel); !problem.empty()) return problem;
  std::string detail;
  bg::validity_failure_type failure{};
  if (bg::is_valid(polygon, failure)) return "";
  // A figure of eight has no orientation: turning its loops does not help.
  Panel turned = panel;
  orient(turned);
  if (failure == bg::failure_wrong_orientation && !bg::is_valid(polygon_of(turned)))
    return reason(bg::failure_self_intersections, crossing(panel.outline));
  bg::is_valid(polygon, detail);
  return reason(failure, detail);
}

}  // namespace toile::pattern
