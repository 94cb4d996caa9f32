#include "toile/pattern/panel.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry.hpp"
#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"
#include "toile/pattern/lines.hpp"

namespace toile::pattern {
namespace {

/// Of the outline's length: ends that are no further apart are one point.
constexpr double closed = 1e-6;

std::string text_of(const Vec2& p) {
  std::ostringstream text;
  text << "(" << p.x() << ", " << p.y() << ") mm";
  return text.str();
}

[[noreturn]] void fail(const Panel& panel, const std::string& problem) {
  throw base::InputError("panel \"" + panel.name + "\": " + problem);
}

template <class F>
void for_each_edge(const Panel& panel, const F& work) {
  for (const Edge& edge : panel.outline) work(edge);
  for (const Loop& hole : panel.holes)
    for (const Edge& edge : hole) work(edge);
}

double length_of(const Loop& loop) {
  double sum = 0.0;
  for (const Edge& edge : loop) sum += edge.curve.length();
  return sum;
}

void check_closed(const Panel& panel, const Loop& loop, double tolerance) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Edge& next = loop[(k + 1) % loop.size()];
    const Vec2 end = loop[k].curve.back(), start = next.curve.front();
    if ((end - start).norm() > tolerance)
      fail(panel, "the outline is open: edge \"" + loop[k].name + "\" ends at " + text_of(end) + ", and edge \"" +
                      next.name + "\" starts at " + text_of(start) + "; they must be the same point");
  }
}

void check_names(const Panel& panel) {
  base::Texts names;
  const auto add = [&](const std::string& what, const std::string& name) {
    if (name.empty()) fail(panel, "there is " + what + " without a name");
    if (std::find(names.begin(), names.end(), name) != names.end())
      fail(panel, "the name \"" + name + "\" is given twice; each edge, line and notch needs a name of its own");
    names.push_back(name);
  };
  for_each_edge(panel, [&](const Edge& edge) { add("an edge", edge.name); });
  for (const InternalLine& line : panel.lines) add("an internal line", line.name);
  for (const Notch& notch : panel.notches) add("a notch", notch.name);
}

void check_notches(const Panel& panel) {
  base::Texts edges;
  for_each_edge(panel, [&](const Edge& edge) { edges.push_back(edge.name); });
  for (const Notch& notch : panel.notches) {
    if (panel.edge(notch.edge) == nullptr)
      fail(panel, "notch \"" + notch.name + "\" lies on edge \"" + notch.edge + "\", which does not exist" +
                      base::hint(notch.edge, edges));
    if (!(notch.at >= 0.0 && notch.at <= 1.0))
      fail(panel, "notch \"" + notch.name + "\" lies at " + std::to_string(notch.at) + " of edge \"" + notch.edge +
                      "\"; allowed are 0 to 1");
  }
}

Loop reversed(const Loop& loop) {
  Loop other;
  for (auto edge = loop.rbegin(); edge != loop.rend(); ++edge) other.push_back({edge->name, edge->curve.reversed()});
  return other;
}

/// Turns a loop that runs the other way.
void turn(Panel& panel, Loop& loop, bool counter_clockwise) {
  if ((signed_area(loop) > 0.0) == counter_clockwise) return;
  for (const Edge& edge : loop)
    for (Notch& notch : panel.notches)
      if (notch.edge == edge.name) notch.at = 1.0 - notch.at;
  loop = reversed(loop);
}

}  // namespace

const Edge* Panel::edge(const std::string& wanted) const {
  const Edge* found = nullptr;
  for_each_edge(*this, [&](const Edge& edge) {
    if (edge.name == wanted) found = &edge;
  });
  return found;
}

void orient(Panel& panel) {
  turn(panel, panel.outline, true);
  for (Loop& hole : panel.holes) turn(panel, hole, false);
}

void check(const Panel& panel) {
  if (panel.outline.empty()) fail(panel, "it has no outline");
  check_names(panel);
  const double tolerance = closed * length_of(panel.outline);
  for_each_edge(panel, [&](const Edge& edge) {
    if (!(edge.curve.length() > tolerance))
      fail(panel, "edge \"" + edge.name + "\" near " + text_of(edge.curve.front()) + " has no length");
  });
  check_closed(panel, panel.outline, tolerance);
  for (const Loop& hole : panel.holes) check_closed(panel, hole, tolerance);
  check_notches(panel);
  const std::string problem = why_invalid(panel);
  if (!problem.empty()) fail(panel, problem);
}

void check_lines(const Panel& panel) {
  const std::string problem = problem_of_lines(panel);
  if (!problem.empty()) fail(panel, problem);
}

void check(const Pattern& pattern) {
  base::Texts names;
  const auto add = [&names](const std::string& what, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) != names.end())
      throw base::InputError("there are two " + what + " \"" + name + "\"; each needs a name of its own");
    names.push_back(name);
  };
  for (const Panel& panel : pattern.panels) {
    add("panels", panel.name);
    check(panel);
  }
  names.clear();
  for (const Stitch& stitch : pattern.stitches) {
    add("stitches", stitch.name);
    try {
      find_side(pattern, stitch.first);
      find_side(pattern, stitch.second);
    } catch (const base::InputError& error) {
      throw base::InputError("stitch \"" + stitch.name + "\": " + error.what());
    }
  }
}

}  // namespace toile::pattern
