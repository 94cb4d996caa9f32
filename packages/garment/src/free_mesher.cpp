#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

#include "mesher.hpp"
#include "toile/base/error.hpp"
#include "toile/mesh/free_mesh.hpp"
#include "toile/mesh/quality.hpp"
#include "toile/pattern/lines.hpp"

namespace toile::garment {
namespace {

using mesh::Vec2;

/// A node lies where the tangent of an edge turns by more than this.
constexpr double corner = 0.2;  // radians
/// Of an edge's length: how near the end of a line must be to lie on it.
constexpr double on_edge = 1e-4;

base::Spec free_spec() {
  base::Spec finer("finer",
                   "A place where elements are smaller: \"at edge\" or \"at point\". Edges near it get shorter sides "
                   "as well, and so "
                   "does what is sewn to them.");
  finer.word("at edge", "Name of an edge or line of this panel.", std::string())
      .reals("at point", "mm", "Place x, y in the pattern.", base::Reals{})
      .real("size", "mm", "Length of the sides of elements there.", base::required, base::Range::positive())
      .real("distance", "mm", "Over which the size grows to that of the panel.", base::required,
            base::Range::positive());
  base::Spec sizes("Sizes", "Where the mesh is finer than elsewhere.");
  sizes.entries(finer);
  base::Spec spec("free", "Elements of one size in an outline of any shape, with holes and lines.");
  spec.real("element size", "mm", "Length of the sides of elements.", base::required, base::Range::positive())
      .real("smallest angle", "deg", "A mesh with a smaller angle in an element is refused.", 10.0,
            base::Range::between(0.0, 60.0))
      .list(sizes);
  return spec;
}

bool is_edge(const base::List& finer) {
  return !finer.word("at edge").empty();
}

std::vector<base::List> finer_places(const base::List& panel) {
  return panel.has_list("Sizes") ? panel.list("Sizes").entries() : std::vector<base::List>();
}

/// Edges and lines by name.
std::map<std::string, const pattern::Curve*> curves_of(const Cut& cut) {
  std::map<std::string, const pattern::Curve*> all;
  for (const pattern::Edge& edge : cut.panel.outline) all[edge.name] = &edge.curve;
  for (const pattern::Loop& hole : cut.panel.holes)
    for (const pattern::Edge& edge : hole) all[edge.name] = &edge.curve;
  for (const pattern::InternalLine& line : cut.panel.lines) all[line.name] = &line.curve;
  return all;
}

/// Where the ends of lines lie on an edge.
Fractions line_ends(const Cut& cut, const std::string& name, const pattern::Curve& edge) {
  Fractions all;
  for (const pattern::InternalLine& line : cut.panel.lines)
    for (const Vec2& end : {line.curve.front(), line.curve.back()}) {
      const double at = pattern::nearest(edge, end);
      if (line.name != name && (edge.at(at) - end).norm() <= on_edge * edge.length()) all.push_back(at);
    }
  return all;
}

std::vector<mesh::Refinement> refinements_of(const base::List& panel, const Cut& cut) {
  std::vector<mesh::Refinement> all;
  const std::map<std::string, const pattern::Curve*> curves = curves_of(cut);
  for (const base::List& place : finer_places(panel)) {
    mesh::Refinement finer{{}, place.real("size"), place.real("distance")};
    if (is_edge(place)) {
      const pattern::Curve& curve = *curves.at(place.word("at edge"));
      const int count = std::max(1, static_cast<int>(std::ceil(curve.length() / finer.size)));
      for (int k = 0; k <= count; ++k) finer.points.push_back(curve.at(static_cast<double>(k) / count));
    } else {
      const base::Reals& at = place.reals("at point");
      if (at.size() != 2) place.fail("at point", "needs two numbers, x and y");
      finer.points.emplace_back(at[0], at[1]);
    }
    all.push_back(std::move(finer));
  }
  return all;
}

/// Length of sides that refinements leave at a point, of the panel's own `size`, mm.
double size_at(const Vec2& point, double size, const std::vector<mesh::Refinement>& refinements) {
  double least = size;
  for (const mesh::Refinement& finer : refinements) {
    const double held = std::min(finer.size, 0.5 * finer.distance);  // around a point, as the mesher does
    double nearest = finer.distance;
    for (const Vec2& centre : finer.points) nearest = std::min(nearest, (centre - point).norm());
    const double part = std::max(0.0, nearest - held) / (finer.distance - held);
    least = std::min(least, finer.size + (size - finer.size) * part);
  }
  return least;
}

std::vector<SeededEdge> free_edges(const base::List& panel, const Cut& cut) {
  try {
    pattern::check_lines(cut.along_outline());
  } catch (const base::InputError& error) {
    panel.fail("mesher", error.what());
  }
  const std::map<std::string, const pattern::Curve*> curves = curves_of(cut);
  std::map<std::string, double> finer;
  for (const base::List& place : finer_places(panel)) {
    if (is_edge(place) == place.given("at point")) place.fail("at edge", "give either an edge or a point");
    if (!is_edge(place)) continue;
    base::Texts valid;
    for (const auto& [name, curve] : curves) valid.push_back(name);
    if (curves.count(place.word("at edge")) == 0)
      place.fail("at edge", "the panel has no edge or line \"" + place.word("at edge") + "\"" +
                                base::hint(place.word("at edge"), valid));
    finer[place.word("at edge")] = place.real("size");
  }
  const std::vector<mesh::Refinement> refinements = refinements_of(panel, cut);
  std::vector<SeededEdge> all;
  for (const auto& [name, curve] : curves) {
    SeededEdge edge{name, curve->length(), panel.real("element size"), curve->corners(corner), {}};
    if (!refinements.empty())
      edge.finer = [line = *curve, size = edge.size, refinements](double at) {
        return size_at(line.at(at), size, refinements);
      };
    if (finer.count(name) > 0) edge.size = finer[name];
    const Fractions ends = line_ends(cut, name, *curve);
    edge.kept.insert(edge.kept.end(), ends.begin(), ends.end());
    for (const pattern::Notch& notch : cut.panel.notches)
      if (notch.edge == name) edge.kept.push_back(notch.at);
    all.push_back(std::move(edge));
  }
  return all;
}

/// Marks, each at its node.
std::vector<mesh::Notch> notches_of(const Cut& cut, const std::map<std::string, Fractions>& seeds,
                                    const std::map<std::string, std::vector<int>>& edges) {
  std::vector<mesh::Notch> all;
  for (const pattern::Notch& notch : cut.panel.notches) {
    const Fractions& at = seeds.at(notch.edge);
    const auto by_distance = [&notch](double a, double b) { return std::abs(a - notch.at) < std::abs(b - notch.at); };
    const auto nearest = std::min_element(at.begin(), at.end(), by_distance);
    all.push_back({notch.name, notch.edge, edges.at(notch.edge)[static_cast<std::size_t>(nearest - at.begin())]});
  }
  return all;
}

/// The area with the nodes of its edges and lines.
class Area {
 public:
  Area(const Cut& cut, const std::map<std::string, Fractions>& seeds) : cut_(cut), seeds_(seeds) {
    add_loop(cut.panel.outline);
    for (const pattern::Loop& hole : cut.panel.holes) add_loop(hole);
    for (const pattern::InternalLine& line : cut.panel.lines) add_line(line);
  }

  mesh::FreeMeshInput input;
  std::map<std::string, std::vector<int>> edges;  ///< nodes in the direction in which places are counted

 private:
  int add(const Vec2& point) {
    input.points.push_back(point);
    return static_cast<int>(input.points.size()) - 1;
  }
  /// Neighbouring edges share their corner.
  void add_loop(const pattern::Loop& loop) {
    std::vector<int> nodes;
    std::vector<std::pair<std::size_t, std::size_t>> range;  // [edge] of nodes
    for (const pattern::Edge& edge : loop) {
      const bool backwards = cut_.backwards.count(edge.name) > 0;
      const Fractions& at = seeds_.at(edge.name);
      const std::size_t first = nodes.size();
      for (std::size_t k = 0; k + 1 < at.size(); ++k)
        nodes.push_back(add(edge.curve.at(backwards ? at[at.size() - 1 - k] : at[k])));
      range.emplace_back(first, nodes.size());
    }
    for (std::size_t e = 0; e < loop.size(); ++e) {
      std::vector<int> line(nodes.begin() + static_cast<std::ptrdiff_t>(range[e].first),
                            nodes.begin() + static_cast<std::ptrdiff_t>(range[e].second));
      line.push_back(nodes[range[e].second % nodes.size()]);
      if (cut_.backwards.count(loop[e].name) > 0) std::reverse(line.begin(), line.end());
      edges[loop[e].name] = std::move(line);
    }
    input.loops.push_back(std::move(nodes));
  }
  /// A line takes the nodes of edges and other lines where it starts, ends or is met.
  void add_line(const pattern::InternalLine& line) {
    const double near = on_edge * line.curve.length();
    std::vector<int> nodes;
    for (const double at : seeds_.at(line.name)) {
      const Vec2 point = line.curve.at(at);
      const auto there = std::find_if(input.points.begin(), input.points.end(),
                                      [&](const Vec2& other) { return (other - point).norm() <= near; });
      nodes.push_back(there == input.points.end() ? add(point) : static_cast<int>(there - input.points.begin()));
    }
    edges[line.name] = nodes;
    input.lines.push_back(std::move(nodes));
  }

  const Cut& cut_;
  const std::map<std::string, Fractions>& seeds_;
};

void check_quality(const base::List& panel, const mesh::PanelMesh& mesh) {
  const mesh::Quality quality = mesh::quality_of(mesh);
  if (quality.smallest_jacobian > 0.0 && quality.smallest_angle >= panel.real("smallest angle")) return;
  std::ostringstream text;
  text << "the mesh of panel \"" << panel.name() << "\" has an angle of " << quality.smallest_angle
       << " degrees in an element near (" << quality.worst.x() << ", " << quality.worst.y()
       << ") mm of its pattern; allowed is at least \"smallest angle\" = " << panel.real("smallest angle")
       << ". Smaller elements there (list \"Sizes\"), or a smaller \"element size\", make it better";
  panel.fail("element size", text.str());
}

/// Elements of the panel's size that its outline holds, without what is finer.
void check_number(const base::List& panel, const mesh::FreeMeshInput& input) {
  double twice = 0.0;
  for (const std::vector<int>& loop : input.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec2& a = input.points[static_cast<std::size_t>(loop[k])];
      const Vec2& b = input.points[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
      twice += a.x() * b.y() - a.y() * b.x();
    }
  const double count = 0.5 * std::abs(twice) / (input.size * input.size);
  if (count <= most_elements) return;
  std::ostringstream text;
  text << "makes about " << count << " elements of the panel; allowed are at most " << most_elements;
  panel.fail("element size", text.str());
}

/// Two nodes of the outline at one place: a slit (a ring that is cut open and closed again), which Gmsh does not take.
void check_slits(const base::List& panel, const Area& area) {
  const auto edge_of = [&area](int node) {
    for (const auto& [name, nodes] : area.edges)
      if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) return "\"" + name + "\"";
    return std::string("the outline");
  };
  const std::vector<Vec2>& points = area.input.points;
  std::vector<int> order;
  for (const std::vector<int>& loop : area.input.loops) order.insert(order.end(), loop.begin(), loop.end());
  std::sort(order.begin(), order.end(), [&points](int a, int b) { return points[a].x() < points[b].x(); });
  const double near = 1e-6 * area.input.size;
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t m = k + 1; m < order.size(); ++m) {
      const Vec2 &a = points[order[k]], &b = points[order[m]];
      if (b.x() - a.x() > near) break;
      if ((b - a).norm() > near) continue;
      const auto [first, second] = std::minmax({edge_of(order[k]), edge_of(order[m])});
      std::ostringstream text;
      text << std::fixed << std::setprecision(3) << "\"free\" takes no panel whose edges lie on each other, as "
           << first << " and " << second << " do near (" << a.x() << ", " << a.y()
           << ") mm: use \"structured\", or leave a gap between them";
      panel.fail("mesher", text.str());
    }
}

mesh::PanelMesh mesh_area(const base::List& panel, const Cut& cut, const std::map<std::string, Fractions>& seeds) {
  Area area(cut, seeds);
  area.input.size = panel.real("element size");
  area.input.triangles = panel.word("elements") == "triangle";
  check_number(panel, area.input);
  check_slits(panel, area);
  area.input.refinements = refinements_of(panel, cut);
  mesh::FreeMesh made;
  try {
    made = mesh::mesh_freely(area.input);
  } catch (const base::InputError& error) {
    panel.fail("element size", error.what());
  }
  mesh::PanelMesh mesh;
  mesh.nodes = std::move(made.nodes);
  mesh.edges = std::move(area.edges);
  mesh.notches = notches_of(cut, seeds, mesh.edges);
  const auto add_part = [&mesh](const auto& elements, int nodes) {
    if (elements.empty()) return;
    mesh::PanelPart part{"", nodes, {}};
    for (const auto& element : elements)
      part.connectivity.insert(part.connectivity.end(), element.begin(), element.end());
    mesh.parts.push_back(std::move(part));
  };
  add_part(made.quadrilaterals, 4);
  add_part(made.triangles, 3);
  check_quality(panel, mesh);
  return mesh;
}

}  // namespace

Mesher free_mesher() {
  return {free_spec(), free_edges, mesh_area};
}

}  // namespace toile::garment
