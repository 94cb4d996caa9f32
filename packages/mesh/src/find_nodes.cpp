#include "toile/mesh/find_nodes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::mesh {
namespace {

struct Corner {
  const char* name;
  const char* edge;
  bool at_end;
};
constexpr std::array<Corner, 4> corners{{{".bottom-left", ".bottom", false},
                                         {".bottom-right", ".bottom", true},
                                         {".top-left", ".top", false},
                                         {".top-right", ".top", true}}};

const std::vector<int>* edge_of(const Mesh& mesh, const std::string& name) {
  const auto found = mesh.edges.find(name);
  return found == mesh.edges.end() ? nullptr : &found->second;
}

const MeshedPanel* panel_of(const Mesh& mesh, const std::string& name) {
  const auto found = std::find_if(mesh.panels.begin(), mesh.panels.end(),
                                  [&name](const MeshedPanel& panel) { return panel.name == name; });
  return found == mesh.panels.end() ? nullptr : &*found;
}

std::optional<int> corner_of(const Mesh& mesh, const std::string& name) {
  const std::string panel = name.substr(0, name.rfind('.'));
  for (const Corner& corner : corners) {
    if (name != panel + corner.name) continue;
    if (const auto* edge = edge_of(mesh, panel + corner.edge)) return corner.at_end ? edge->back() : edge->front();
  }
  return std::nullopt;
}

std::vector<int> nodes_of(const MeshedPanel& panel) {
  std::vector<int> nodes(static_cast<std::size_t>(panel.nodes));
  std::iota(nodes.begin(), nodes.end(), panel.first);
  return nodes;
}

FoundNodes failed(const std::string& problem) {
  return {{}, problem};
}

FoundNodes unknown(const Mesh& mesh, const std::string& name) {
  base::Texts valid;
  for (const MeshedPanel& panel : mesh.panels) valid.push_back(panel.name);
  for (const auto& [edge, nodes] : mesh.edges) valid.push_back(edge);
  std::string all;
  for (const std::string& one : valid) all += (all.empty() ? "" : ", ") + one;
  for (const MeshedPanel& panel : mesh.panels) {
    for (const Corner& corner : corners)
      if (corner_of(mesh, panel.name + corner.name)) valid.push_back(panel.name + corner.name);
  }
  const std::string near = base::nearest_name(name, valid);
  return failed(
      "no edge or panel is named \"" + name + "\"" + (near.empty() ? "." : "; did you mean \"" + near + "\"?") +
      " Valid here: " + all +
      "; the corners of a panel, <panel>.bottom-left, .bottom-right, .top-right and .top-left; one node on an "
      "edge, for instance <panel>.left@0.5, or in a panel, <panel>@0.5,0.5 (relative) or <panel>@(12.5,40) (mm of its "
      "pattern)");
}

/// Finite numbers separated by commas or, as in a list whose words commas separate, by blanks; none if the text is
/// something else.
std::vector<double> read_numbers(const std::string& text) {
  std::vector<double> numbers;
  const char* next = text.data();
  const char* const end = next + text.size();
  const auto skip_blanks = [&] {
    while (next != end && *next == ' ') ++next;
  };
  while (true) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(next, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    numbers.push_back(value);
    next = stop;
    if (next == end) return numbers;
    skip_blanks();
    if (*next != ',' && next == stop) return {};
    if (*next == ',') ++next;
    skip_blanks();
  }
}

std::vector<double> read_fractions(const std::string& text) {
  std::vector<double> numbers = read_numbers(text);
  const auto is_outside = [](double value) { return !(value >= 0.0 && value <= 1.0); };
  if (std::any_of(numbers.begin(), numbers.end(), is_outside)) numbers.clear();
  return numbers;
}

/// Which of some increasing arc lengths is nearest to one.
std::size_t nearest(const std::vector<double>& arc, double wanted) {
  // A hair's breadth of preference for the first one makes a tie independent of rounding.
  const double hair = 1e-9 * arc.back();
  std::size_t best = 0;
  for (std::size_t k = 1; k < arc.size(); ++k) {
    if (std::abs(arc[k] - wanted) < std::abs(arc[best] - wanted) - hair) best = k;
  }
  return best;
}

/// Node of an edge that is nearest to a relative arc length, and how far off it is.
FoundNodes nearest_on(const Mesh& mesh, const std::vector<int>& edge, double fraction) {
  const std::vector<double> arc = arc_lengths(mesh, edge);
  const std::size_t best = nearest(arc, fraction * arc.back());
  return {{edge[best]}, "", std::abs(arc[best] - fraction * arc.back())};
}

FoundNodes place_on_edge(const Mesh& mesh, const std::string& name, const std::vector<int>& edge,
                         const std::vector<double>& place) {
  if (place.size() == 1) return nearest_on(mesh, edge, place[0]);
  return failed("\"" + name + "\" must have one number from 0 to 1 after the @, the relative length along the edge");
}

FoundNodes place_in_panel(const Mesh& mesh, const std::string& name, const std::string& panel,
                          const std::vector<double>& place) {
  if (place.size() != 2) {
    return failed("\"" + name +
                  "\" must have two numbers from 0 to 1 after the @, separated by a comma or a blank: the relative "
                  "place from left to right and from bottom to top");
  }
  const auto* bottom = edge_of(mesh, panel + ".bottom");
  const auto* left = edge_of(mesh, panel + ".left");
  if (panel_of(mesh, panel)->across == 0)
    return failed("panel \"" + panel + "\" has no rows and columns of elements; a point of its pattern is \"" + panel +
                  "@(12.5,40)\"");
  // Rows are numbered one after another (see Grid).
  const FoundNodes row = nearest_on(mesh, *left, place[1]), column = nearest_on(mesh, *bottom, place[0]);
  return {{row.nodes.front() + column.nodes.front() - bottom->front()}, "", std::max(row.off, column.off)};
}

FoundNodes find_place(const Mesh& mesh, const std::string& name, const std::string& set,
                      const std::vector<double>& place) {
  if (const auto* edge = edge_of(mesh, set)) return place_on_edge(mesh, name, *edge, place);
  if (panel_of(mesh, set) != nullptr) return place_in_panel(mesh, name, set, place);
  if (corner_of(mesh, set)) return failed("\"" + set + "\" is one node, so \"@\" and a place cannot follow");
  return unknown(mesh, set);
}

/// Length of the longest side of the panel's elements in the pattern, mm.
double longest_side(const Mesh& mesh, const MeshedPanel& panel) {
  double longest = 0.0;
  for (const Block& block : mesh.blocks) {
    if (&mesh.panel_of(block) != &panel) continue;
    const std::size_t per = static_cast<std::size_t>(block.nodes_per_element);
    for (std::size_t k = 0; k < block.connectivity.size(); ++k) {
      const std::size_t next = k % per == per - 1 ? k + 1 - per : k + 1;
      const Vec2 side = mesh.pattern[block.connectivity[next]] - mesh.pattern[block.connectivity[k]];
      longest = std::max(longest, side.norm());
    }
  }
  return longest;
}

/// The node nearest to a point of the pattern, "(x y)" in mm.
FoundNodes find_point(const Mesh& mesh, const std::string& name, const std::string& set, const std::string& place) {
  const MeshedPanel* panel = panel_of(mesh, set);
  if (panel == nullptr) return unknown(mesh, set);
  const std::vector<double> numbers = read_numbers(place.substr(1, place.size() - 2));
  if (numbers.size() != 2)
    return failed("\"" + name + "\" must have the x and y of a point of the pattern in mm between the brackets");
  const Vec2 wanted(numbers[0], numbers[1]);
  int nearest = panel->first;
  for (const int node : nodes_of(*panel))
    if ((mesh.pattern[node] - wanted).norm() < (mesh.pattern[nearest] - wanted).norm()) nearest = node;
  const Vec2& found = mesh.pattern[nearest];
  if ((found - wanted).norm() <= longest_side(mesh, *panel)) return {{nearest}, ""};
  std::ostringstream text;
  text << "\"" << name << "\" lies outside of the pattern of panel \"" << set << "\": its nearest node is at ("
       << found.x() << ", " << found.y() << ") mm";
  return failed(text.str());
}

/// A panel's edges through its nodes, with its notches.
pattern::Panel edges_of(const Mesh& mesh, const MeshedPanel& panel) {
  pattern::Panel edges;
  edges.name = panel.name;
  for (const auto& [name, nodes] : mesh.edges) {
    if (name.compare(0, panel.name.size() + 1, panel.name + ".") != 0) continue;
    std::vector<Vec2> points;
    for (const int node : nodes) points.push_back(mesh.pattern[node]);
    edges.outline.push_back({name.substr(panel.name.size() + 1), pattern::Curve::polyline(points)});
  }
  for (const Notch& notch : panel.notches) {
    const std::vector<int>& nodes = mesh.edges.at(panel.name + "." + notch.edge);
    const std::vector<double> arc = arc_lengths(mesh, nodes);
    const auto at = std::find(nodes.begin(), nodes.end(), notch.node) - nodes.begin();
    edges.notches.push_back({notch.name, notch.edge, arc[static_cast<std::size_t>(at)] / arc.back()});
  }
  return edges;
}

bool is_part(const std::string& name) {
  return !name.empty() && name.back() == ']' && name.find('[') != std::string::npos;
}

/// A part of an edge, "front.armhole[notch1:end]".
struct Part {
  const std::vector<int>* edge = nullptr;
  double from = 0.0, to = 0.0;  ///< arc lengths in the pattern, mm
};

/// Throws base::InputError if there is no such part.
Part part_of(const Mesh& mesh, const MeshedPanel& panel, const std::string& name) {
  const pattern::Panel edges = edges_of(mesh, panel);
  const pattern::EdgePart part = pattern::find_part(edges, name.substr(panel.name.size() + 1));
  const std::vector<int>& nodes = mesh.edges.at(panel.name + "." + part.edge->name);
  const double length = arc_lengths(mesh, nodes).back();
  return {&nodes, part.from * length, part.to * length};
}

FoundNodes find_part(const Mesh& mesh, const std::string& name) {
  const MeshedPanel* panel = panel_of(mesh, name.substr(0, name.find('.')));
  if (panel == nullptr) return unknown(mesh, name.substr(0, name.find('[')));
  try {
    const Part part = part_of(mesh, *panel, name);
    const std::vector<double> arc = arc_lengths(mesh, *part.edge);
    const std::size_t first = nearest(arc, part.from), last = nearest(arc, part.to);
    if (last < first + 1) return failed("\"" + name + "\" is shorter than the side of an element");
    const auto begin = part.edge->begin();
    return {std::vector<int>(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last + 1)),
            "", std::max(std::abs(arc[first] - part.from), std::abs(arc[last] - part.to))};
  } catch (const base::InputError& error) {
    return failed(error.what());
  }
}

}  // namespace

FoundNodes find_nodes(const Mesh& mesh, const std::string& name) {
  if (const auto* edge = edge_of(mesh, name)) return {*edge, ""};
  if (const MeshedPanel* panel = panel_of(mesh, name)) return {nodes_of(*panel), ""};
  if (const auto corner = corner_of(mesh, name)) return {{*corner}, ""};
  if (is_part(name)) return find_part(mesh, name);
  const std::size_t at = name.rfind('@');
  if (at == std::string::npos) return unknown(mesh, name);
  const std::string place = name.substr(at + 1);
  if (place.size() > 1 && place.front() == '(' && place.back() == ')')
    return find_point(mesh, name, name.substr(0, at), place);
  return find_place(mesh, name, name.substr(0, at), read_fractions(place));
}

EdgeLengths edge_lengths(const Mesh& mesh, const std::string& name) {
  const Part part = is_part(name) ? part_of(mesh, *panel_of(mesh, name.substr(0, name.find('.'))), name)
                                  : Part{edge_of(mesh, name), 0.0, HUGE_VAL};
  const std::vector<double> arc = arc_lengths(mesh, *part.edge);
  EdgeLengths result{*part.edge, std::vector<double>(arc.size(), 0.0)};
  for (std::size_t k = 0; k + 1 < arc.size(); ++k) {
    const double from = std::max(arc[k], part.from), to = std::min(arc[k + 1], part.to);
    if (!(to > from)) continue;
    const double of_second = (0.5 * (from + to) - arc[k]) / (arc[k + 1] - arc[k]);  // shape function at the middle
    result.lengths[k] += (to - from) * (1.0 - of_second);
    result.lengths[k + 1] += (to - from) * of_second;
  }
  return result;
}

EdgePlace edge_place(const Mesh& mesh, const std::vector<int>& edge, double fraction) {
  const std::vector<double> arc = arc_lengths(mesh, edge);
  const double wanted = fraction * arc.back();
  const auto after = std::upper_bound(arc.begin() + 1, arc.end() - 1, wanted) - arc.begin();
  const auto k = static_cast<std::size_t>(after);
  return {edge[k - 1], edge[k], (wanted - arc[k - 1]) / (arc[k] - arc[k - 1])};
}

}  // namespace toile::mesh
