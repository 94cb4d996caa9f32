#include "wrap_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::garment {
namespace {

using mesh::Vec2;

constexpr double sections_per_row = 2.0;

/// Mean pattern coordinate y of each row, which must rise.
std::vector<double> row_levels(const base::List& list, const mesh::PanelMesh& flat) {
  std::vector<double> level;
  for (int j = 0; j < flat.rows(); ++j) {
    double sum = 0.0;
    for (int i = 0; i <= flat.across; ++i) sum += flat.nodes[flat.node(i, j)].y();
    level.push_back(sum / (flat.across + 1));
    if (j > 0 && level[j] <= level[j - 1]) list.fail("type", "the rows of the pattern must rise along its y axis");
  }
  return level;
}

/// Heights that are linear in y, from the lowest node to the highest one.
void set_heights(const base::List& list, const std::vector<double>& y, std::vector<WrapPlace>& places) {
  const auto [from, to] = wrap_heights(list);
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  for (std::size_t n = 0; n < y.size(); ++n) places[n].height = from + (to - from) * (y[n] - *low) / (*high - *low);
}

/// Pattern coordinate y that each node counts as.
std::vector<double> row_heights(const base::List& list, const mesh::PanelMesh& flat) {
  constexpr double straight = 1e-9;  // of the panel's height
  const std::vector<double> level = row_levels(list, flat);
  const bool as_drawn = list.word("rows") == "as drawn";
  std::vector<double> y;
  for (int j = 0; j < flat.rows(); ++j) {
    bool curved = false;
    for (int i = 0; i <= flat.across; ++i)
      curved =
          curved || std::abs(flat.nodes[flat.node(i, j)].y() - level[j]) > straight * (level.back() - level.front());
    for (int i = 0; i <= flat.across; ++i) y.push_back(as_drawn && curved ? flat.nodes[flat.node(i, j)].y() : level[j]);
  }
  return y;
}

/// Width of the pattern from the left end of row j to each of its nodes, mm: along x if the heights follow y, else
/// along the row.
std::vector<double> row_widths(const base::List& list, const mesh::PanelMesh& flat, int j) {
  const bool as_drawn = list.word("rows") == "as drawn";
  std::vector<double> width{0.0};
  for (int i = 1; i <= flat.across; ++i) {
    const Vec2 step = flat.nodes[flat.node(i, j)] - flat.nodes[flat.node(i - 1, j)];
    width.push_back(width.back() + (as_drawn ? step.x() : step.norm()));
  }
  if (width.back() <= 0.0) list.fail("type", "the rows of the pattern must run from left to right along its x axis");
  return width;
}

using Side = std::pair<int, int>;

/// Calls work(a, b) for each side of each element.
template <class F>
void for_each_side(const mesh::PanelMesh& flat, const F& work) {
  for (const mesh::PanelPart& part : flat.parts)
    for (std::size_t k = 0; k < part.connectivity.size(); ++k) {
      const auto per = static_cast<std::size_t>(part.nodes_per_element);
      work(part.connectivity[k], part.connectivity[k % per == per - 1 ? k + 1 - per : k + 1]);
    }
}

/// Left and right end of the pattern at the height y of one of its nodes. Heights that differ by `same` (mm) are one:
/// the nodes of a straight hem have round-off.
std::pair<double, double> ends_at(const std::vector<std::pair<Vec2, Vec2>>& border, double y, double same) {
  double left = std::numeric_limits<double>::infinity(), right = -left;
  const auto reaches = [&](double x) {
    left = std::min(left, x);
    right = std::max(right, x);
  };
  for (const auto& [a, b] : border) {
    const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
    if (y < low - same || y > high + same) continue;
    if (high - low > same) {
      reaches(a.x() + std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0) * (b.x() - a.x()));
    } else {
      reaches(a.x());
      reaches(b.x());
    }
  }
  return {left, right};
}

/// Sides of one element only.
std::vector<std::pair<Vec2, Vec2>> border_of(const mesh::PanelMesh& flat) {
  std::vector<Side> sides;
  for_each_side(flat, [&sides](int a, int b) { sides.emplace_back(std::min(a, b), std::max(a, b)); });
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<Vec2, Vec2>> border;
  for (auto side = sides.begin(); side != sides.end();) {
    const auto next = std::upper_bound(side, sides.end(), *side);
    if (next - side == 1) border.emplace_back(flat.nodes[side->first], flat.nodes[side->second]);
    side = next;
  }
  return border;
}

}  // namespace

std::pair<double, double> wrap_heights(const base::List& list) {
  if (list.real("to") <= list.real("from")) list.fail("to", "must be above \"from\"");
  return {list.real("from"), list.real("to")};
}

WrapPlaces places_in_rows(const base::List& list, const mesh::PanelMesh& flat) {
  WrapPlaces places;
  places.node.resize(flat.nodes.size());
  set_heights(list, row_heights(list, flat), places.node);
  const auto [from, to] = wrap_heights(list);
  places.spacing = (to - from) / (sections_per_row * (flat.rows() - 1));
  for (int j = 0; j < flat.rows(); ++j) {
    const std::vector<double> width = row_widths(list, flat, j);
    WrapPlace* row = &places.node[flat.node(0, j)];
    const bool is_level =
        std::all_of(row, row + width.size(), [row](const WrapPlace& p) { return p.height == row->height; });
    for (std::size_t i = 0; i < width.size(); ++i) {
      row[i].width = width.back();
      row[i].fraction = width[i] / width.back();
      row[i].is_level = is_level;
      if (j > 0) places.rising.emplace_back(flat.node(static_cast<int>(i), j - 1), flat.node(static_cast<int>(i), j));
    }
  }
  return places;
}

WrapPlaces places_by_width(const base::List& list, const mesh::PanelMesh& flat) {
  if (list.word("rows") == "level")
    list.fail("rows", "\"level\" needs rows of elements: a panel of four sides with \"mesher\" = structured");
  WrapPlaces places;
  places.node.resize(flat.nodes.size());
  std::vector<double> y;
  for (const Vec2& node : flat.nodes) y.push_back(node.y());
  set_heights(list, y, places.node);
  const std::vector<std::pair<Vec2, Vec2>> border = border_of(flat);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b] : border) shortest = std::min(shortest, (b - a).norm());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const auto [from, to] = wrap_heights(list);
  places.spacing = shortest / sections_per_row * (to - from) / (*high - *low);
  constexpr double straight = 1e-9;  // of the panel's height
  for (std::size_t n = 0; n < flat.nodes.size(); ++n) {
    const auto [left, right] = ends_at(border, y[n], straight * (*high - *low));
    places.node[n].width = right - left;
    places.node[n].fraction = right > left ? (flat.nodes[n].x() - left) / (right - left) : 0.5;
  }
  for_each_side(flat, [&](int a, int b) {
    const Vec2 step = flat.nodes[b] - flat.nodes[a];
    if (step.y() > std::abs(step.x())) places.rising.emplace_back(a, b);
  });
  return places;
}

void widen(const mesh::PanelMesh& flat, WrapPlaces& places) {
  const auto [left, right] = std::minmax_element(flat.nodes.begin(), flat.nodes.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  for (std::size_t n = 0; n < flat.nodes.size(); ++n) {
    places.node[n].width = right->x() - left->x();
    places.node[n].fraction = (flat.nodes[n].x() - left->x()) / places.node[n].width;
  }
}

}  // namespace toile::garment
