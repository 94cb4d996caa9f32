#include "toile/mesh/zones.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <numeric>
#include <set>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::mesh {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;

using Side = std::pair<int, int>;

Side side(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// All elements of a panel, one part after another.
struct Element {
  const int* nodes;
  int corners;
};

std::vector<Element> elements_of(const PanelMesh& panel) {
  std::vector<Element> all;
  for (const PanelPart& part : panel.parts)
    for (std::size_t k = 0; k < part.connectivity.size(); k += static_cast<std::size_t>(part.nodes_per_element))
      all.push_back({&part.connectivity[k], part.nodes_per_element});
  return all;
}

bool contains(const PanelMesh& panel, const Element& element, const Vec2& point) {
  for (int k = 0; k < element.corners; ++k) {
    const Vec2& a = panel.nodes[static_cast<std::size_t>(element.nodes[k])];
    const Vec2 along = panel.nodes[static_cast<std::size_t>(element.nodes[(k + 1) % element.corners])] - a;
    const Vec2 to = point - a;
    if (along.x() * to.y() - along.y() * to.x() < 0.0) return false;
  }
  return true;
}

/// [element] Number of the area that it belongs to, between lines.
std::vector<std::size_t> areas_of(const std::vector<Element>& elements, const std::vector<std::vector<int>>& lines) {
  std::set<Side> border;
  for (const std::vector<int>& line : lines)
    for (std::size_t k = 1; k < line.size(); ++k) border.insert(side(line[k - 1], line[k]));
  std::vector<int> rank(elements.size(), 0);
  std::vector<std::size_t> parent(elements.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  boost::disjoint_sets<int*, std::size_t*> sets(rank.data(), parent.data());
  std::map<Side, std::size_t> first;
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (int k = 0; k < elements[e].corners; ++k) {
      const Side s = side(elements[e].nodes[k], elements[e].nodes[(k + 1) % elements[e].corners]);
      if (border.count(s) > 0) continue;
      const auto [other, is_new] = first.try_emplace(s, e);
      if (!is_new) sets.union_set(other->second, e);
    }
  std::vector<std::size_t> area;
  for (std::size_t e = 0; e < elements.size(); ++e) area.push_back(sets.find_set(e));
  return area;
}

Vec2 centre(const PanelMesh& panel, const Element& element) {
  Vec2 sum = Vec2::Zero();
  for (int k = 0; k < element.corners; ++k) sum += panel.nodes[static_cast<std::size_t>(element.nodes[k])];
  return sum / element.corners;
}

/// Puts elements into a zone, none of them into two.
class Zones {
 public:
  explicit Zones(std::size_t elements) : name_(elements) {}

  template <class F>
  void add(const std::string& name, const F& holds) {
    bool any = false;
    for (std::size_t e = 0; e < name_.size(); ++e) {
      if (!holds(e)) continue;
      if (!name_[e].empty())
        throw base::InputError("the zones \"" + name_[e] + "\" and \"" + name +
                               "\" lie in one area: lines or borders must divide the panel between them, from edge to "
                               "edge");
      name_[e] = name;
      any = true;
    }
    if (!any)
      throw base::InputError("zone \"" + name +
                             "\" is narrower than the elements of the panel: it holds the centre of none of them");
  }
  const std::string& of(std::size_t element) const { return name_[element]; }

 private:
  std::vector<std::string> name_;
};

void add_borders(Zones& zones, const PanelMesh& panel, const std::vector<Element>& elements,
                 const std::map<std::string, std::vector<Vec2>>& borders) {
  for (const auto& [name, corners] : borders) {
    bg::model::ring<Point> ring;
    for (const Vec2& corner : corners) ring.emplace_back(corner.x(), corner.y());
    bg::correct(ring);
    zones.add(name, [&, &inside = ring](std::size_t e) {
      const Vec2 p = centre(panel, elements[e]);
      return bg::within(Point(p.x(), p.y()), inside);
    });
  }
}

void add_points(Zones& zones, const PanelMesh& panel, const std::vector<Element>& elements,
                const std::vector<std::vector<int>>& lines, const std::map<std::string, Vec2>& points) {
  if (points.empty()) return;
  const std::vector<std::size_t> area = areas_of(elements, lines);
  for (const auto& [name, point] : points) {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&, at = point](const Element& element) { return contains(panel, element, at); });
    if (found == elements.end()) {
      std::ostringstream text;
      text << "the point (" << point.x() << ", " << point.y() << ") mm of zone \"" << name
           << "\" lies outside of the panel's pattern";
      throw base::InputError(text.str());
    }
    const std::size_t wanted = area[static_cast<std::size_t>(found - elements.begin())];
    zones.add(name, [&](std::size_t e) { return area[e] == wanted; });
  }
}

}  // namespace

void divide_into_zones(PanelMesh& panel, const std::vector<std::vector<int>>& lines, const ZonePlaces& places) {
  if (places.points.empty() && places.borders.empty()) return;
  const std::vector<Element> elements = elements_of(panel);
  Zones zones(elements.size());
  add_borders(zones, panel, elements, places.borders);
  add_points(zones, panel, elements, lines, places.points);
  std::map<std::pair<std::string, int>, PanelPart> parts;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    PanelPart& part = parts[{zones.of(e), -elements[e].corners}];  // quadrilaterals first
    part.zone = zones.of(e);
    part.nodes_per_element = elements[e].corners;
    part.connectivity.insert(part.connectivity.end(), elements[e].nodes, elements[e].nodes + elements[e].corners);
  }
  std::vector<PanelPart> divided;
  for (auto& [key, part] : parts) divided.push_back(std::move(part));
  panel.parts = std::move(divided);
}

}  // namespace toile::mesh
