#include "toile/pattern/area.hpp"

#include <algorithm>
#include <sstream>

#include "ring.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

using Lines = bg::model::multi_linestring<Line>;
using Polygons = bg::model::multi_polygon<Polygon>;

Line line_of(const Curve& curve) {
  Line line;
  for (const Vec2& p : curve.points(chord * curve.length())) line.emplace_back(p.x(), p.y());
  return line;
}

Polygon polygon_of(const Area& area) {
  Polygon polygon;
  for (const Vec2& p : area.border) bg::append(polygon.outer(), Point(p.x(), p.y()));
  bg::correct(polygon);
  return polygon;
}

std::string extent(const Polygon& polygon) {
  const auto box = bg::return_envelope<bg::model::box<Point>>(polygon);
  std::ostringstream text;
  text << "x from " << box.min_corner().x() << " to " << box.max_corner().x() << ", y from " << box.min_corner().y()
       << " to " << box.max_corner().y() << " mm";
  return text.str();
}

/// Divides the panel by one area after another.
class Borders {
 public:
  explicit Borders(const Panel& panel) : panel_(panel), fabric_(pattern::polygon_of(panel)) {
    const auto add_loop = [this](const Loop& loop) {
      for (const Edge& edge : loop) edges_.push_back(&edge.curve);
      const Polygon::ring_type points = ring(loop);
      drawn_.emplace_back(points.begin(), points.end());
    };
    add_loop(panel.outline);
    for (const Loop& hole : panel.holes) add_loop(hole);
    for (const InternalLine& line : panel.lines) drawn_.push_back(line_of(line.curve));
    near_ = 10.0 * chord * bg::length(drawn_.front());
  }

  void add(const Area& area) {
    const Polygon polygon = polygon_of(area);
    if (area.border.size() < 3 || !bg::is_valid(polygon))
      throw base::InputError("the border of zone \"" + area.name +
                             "\" encloses no area, or crosses itself: give its corners one after another, round it");
    check_fabric(area, polygon);
    Lines inside;
    bg::intersection(Line(polygon.outer().begin(), polygon.outer().end()), fabric_, inside);
    int count = 0;
    for (const Line& whole : inside)
      for (Line& part : new_parts(whole)) {
        lines.push_back({area.name + " border" + (++count == 1 ? "" : " " + std::to_string(count)), curve_of(part)});
        drawn_.push_back(std::move(part));
      }
  }

  std::vector<InternalLine> lines;

 private:
  void check_fabric(const Area& area, const Polygon& polygon) {
    Polygons fabric;
    bg::intersection(polygon, fabric_, fabric);
    if (bg::area(fabric) <= near_ * near_)
      throw base::InputError("zone \"" + area.name + "\" (" + extent(polygon) + ") holds no fabric of panel \"" +
                             panel_.name + "\", which has " + extent(fabric_));
    for (const auto& [name, other] : taken_) {
      Polygons common;
      bg::intersection(fabric, other, common);
      double widest = 0.0;
      for (const Polygon& part : common)
        widest = std::max(widest, static_cast<double>(bg::area(part) / bg::perimeter(part)));
      if (widest > near_)
        throw base::InputError("the zones \"" + name + "\" and \"" + area.name + "\" overlap (" +
                               extent(common.front()) + "); a place of the panel can be in one zone only");
    }
    taken_.emplace_back(area.name, std::move(fabric));
  }

  bool is_drawn(const Point& a, const Point& b) const {
    const Point middle(0.5 * (a.x() + b.x()), 0.5 * (a.y() + b.y()));
    const auto holds = [&](const Point& p) {
      return std::any_of(drawn_.begin(), drawn_.end(),
                         [&](const Line& line) { return bg::distance(p, line) <= near_; });
    };
    return holds(a) && holds(middle) && holds(b);
  }

  /// What of a line is not drawn yet, in parts that are open.
  std::vector<Line> new_parts(const Line& whole) const {
    std::vector<Line> parts(1);
    for (std::size_t k = 1; k < whole.size(); ++k) {
      if (bg::distance(whole[k - 1], whole[k]) <= near_ || is_drawn(whole[k - 1], whole[k])) {
        if (!parts.back().empty()) parts.emplace_back();
        continue;
      }
      if (parts.back().empty()) parts.back().push_back(whole[k - 1]);
      parts.back().push_back(whole[k]);
    }
    if (parts.back().empty()) parts.pop_back();
    for (std::size_t k = parts.size(); k-- > 0;) {
      if (bg::distance(parts[k].front(), parts[k].back()) > near_) continue;
      const auto half = parts[k].begin() + static_cast<std::ptrdiff_t>(parts[k].size() / 2);
      Line second(half, parts[k].end());
      parts[k].erase(half + 1, parts[k].end());
      parts.push_back(std::move(second));
    }
    return parts;
  }

  /// Where a straight line that comes from `from` and ends near an edge meets it. Seams carry such places to the other
  /// edge, so they must agree far closer than the points that stand for an edge. A point near a corner is meant to be
  /// it.
  Vec2 on_edge(const Point& from, const Point& end) const {
    const Vec2 p(end.x(), end.y()), along = (p - Vec2(from.x(), from.y())).normalized();
    for (const Curve* edge : edges_)
      for (const Vec2& corner : {edge->front(), edge->back()})
        if ((corner - p).norm() <= near_) return corner;
    for (const Curve* edge : edges_) {
      const double at = nearest(*edge, p);
      if ((edge->at(at) - p).norm() <= near_) return edge->at(crossing(*edge, at, p, along));
    }
    return p;
  }

  /// Relative arc length near `at` where an edge crosses the line through `p`; `at` if it runs along it.
  double crossing(const Curve& edge, double at, const Vec2& p, const Vec2& along) const {
    const auto beside = [&](double s) {
      const Vec2 to = edge.at(s) - p;
      return along.x() * to.y() - along.y() * to.x();
    };
    const double reach = 10.0 * near_ / edge.length();
    double low = std::max(0.0, at - reach), high = std::min(1.0, at + reach);
    const bool rises = beside(high) > 0.0;
    if ((beside(low) > 0.0) == rises) return at;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      ((beside(middle) > 0.0) == rises ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }

  Curve curve_of(const Line& line) const {
    std::vector<Vec2> points;
    for (const Point& p : line) points.emplace_back(p.x(), p.y());
    points.front() = on_edge(line[1], line.front());
    points.back() = on_edge(line[line.size() - 2], line.back());
    return Curve::polyline(points);
  }

  const Panel& panel_;
  Polygon fabric_;
  std::vector<const Curve*> edges_;
  std::vector<Line> drawn_;  ///< outline, holes and lines
  std::vector<std::pair<std::string, Polygons>> taken_;
  double near_ = 0.0;  ///< mm, that curves and the lines that stand for them are apart
};

}  // namespace

Area band(const Panel& panel, const std::string& name, double low, double high) {
  const auto box = bg::return_envelope<bg::model::box<Point>>(pattern::polygon_of(panel));
  const double left = box.min_corner().x(), right = box.max_corner().x(), beyond = right - left;
  return {name, {{left - beyond, low}, {right + beyond, low}, {right + beyond, high}, {left - beyond, high}}};
}

std::vector<InternalLine> borders(const Panel& panel, const std::vector<Area>& areas) {
  Borders all(panel);
  for (const Area& area : areas) all.add(area);
  return std::move(all.lines);
}

}  // namespace toile::pattern
