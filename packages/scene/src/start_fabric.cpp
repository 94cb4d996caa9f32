#include "start_fabric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "toile/solve/connected_parts.hpp"

namespace toile::scene {

namespace {

using solve::Vec3;

/// Of one value an element.
Extremes extremes(const std::vector<Deformation>& elements, const std::vector<double>& values) {
  Extremes e;
  e.smallest = std::numeric_limits<double>::infinity();
  e.largest = -e.smallest;
  for (size_t i = 0; i < values.size(); ++i) {
    e.mean += values[i] / static_cast<double>(values.size());
    if (values[i] < e.smallest) {
      e.smallest = values[i];
      e.at_smallest = elements[i].centre;
    }
    if (values[i] > e.largest) {
      e.largest = values[i];
      e.at_largest = elements[i].centre;
    }
  }
  return e;
}

template <class F>
Extremes extremes_of(const std::vector<Deformation>& elements, const F& value) {
  std::vector<double> values;
  for (const Deformation& d : elements) values.push_back(value(d));
  return extremes(elements, values);
}

/// [panel] how much longer the ring of panels becomes that are sewn side to side when its seams close; 0: no such ring.
std::vector<double> closing(const Scene& scene, const std::vector<Vec3>& position) {
  const mesh::Mesh& mesh = scene.garment().mesh;
  std::vector<double> gap(mesh.panels.size(), 0.0), width(mesh.panels.size(), 0.0);
  std::vector<int> sides(mesh.panels.size(), 0);
  const auto panel_index = [&](const std::string& edge) {
    const std::string name = panel_of_edge(edge);
    return static_cast<size_t>(std::find_if(mesh.panels.begin(), mesh.panels.end(),
                                            [&](const mesh::MeshedPanel& p) { return p.name == name; }) -
                               mesh.panels.begin());
  };
  for (const garment::Seam& seam : scene.garment().seams) {
    if (!is_side(seam.first) || !is_side(seam.second)) continue;
    double mean = 0.0;
    for (const auto& [a, b] : seam.pairs)
      mean += (position[a] - position[b]).norm() / static_cast<double>(seam.pairs.size());
    for (const size_t panel : {panel_index(seam.first), panel_index(seam.second)}) {
      gap[panel] += 0.5 * mean;
      ++sides[panel];
    }
  }
  for (size_t p = 0; p < mesh.panels.size(); ++p)
    for (const char* hem : {".bottom", ".top"}) {
      const auto edge = mesh.edges.find(mesh.panels[p].name + hem);
      if (edge != mesh.edges.end()) width[p] += 0.5 * length_of_line(edge->second, position);
    }
  double all_gaps = 0.0, all_widths = 0.0;
  for (size_t p = 0; p < gap.size(); ++p)
    if (sides[p] > 1) {
      all_gaps += gap[p];
      all_widths += width[p];
    }
  std::vector<double> factor(gap.size(), 0.0);
  for (size_t p = 0; p < gap.size(); ++p)
    if (sides[p] > 1 && all_widths > 0.0) factor[p] = 1.0 + all_gaps / all_widths;
  return factor;
}

/// The body as one panel sees it.
struct BodyAtPanel {
  std::vector<body::SurfacePoint> centre;  ///< [element]
  std::vector<double> corner_gap;          ///< [element] mm, mean of its nodes
};

BodyAtPanel body_at(const body::Surface& surface, const mesh::Block& block, const std::vector<Deformation>& elements,
                    const std::vector<double>& gap) {
  BodyAtPanel body;
  for (const Deformation& d : elements) body.centre.push_back(surface.closest(d.centre));
  const size_t per = static_cast<size_t>(block.nodes_per_element);
  body.corner_gap.assign(elements.size(), 0.0);
  for (size_t i = 0; i < block.connectivity.size(); ++i)
    body.corner_gap[i / per] += gap[block.connectivity[i]] / static_cast<double>(per);
  return body;
}

/// [element] stretch across the panel, from side to side, once its seams are closed and it lies on the body. A chord on
/// a circle is shorter than its arc by a third of its height over the radius.
std::vector<double> stretches_round(const std::vector<Deformation>& elements, const BodyAtPanel& body, double closing) {
  std::vector<double> all;
  for (size_t e = 0; e < elements.size(); ++e) {
    const Vec3 across = elements[e].along(0.0);
    const double stretch = closing * across.norm();
    const body::SurfacePoint& p = body.centre[e];
    const Vec3 direction = across.normalized();
    const double off = (2.0 * body.corner_gap[e] + p.gap) / 3.0;
    all.push_back(p.found ? stretch * std::max(0.0, 1.0 - off * direction.dot(p.hessian * direction)) : stretch);
  }
  return all;
}

const std::vector<double>& values_of(const solve::Fields& fields, size_t block, const std::string& name) {
  const auto& all = fields.element[block];
  return std::find_if(all.begin(), all.end(), [&](const auto& field) { return field.name == name; })->values;
}

/// Laplace's pressure of the tensions along wale and course on the body's curvature; none where no element lies near.
std::optional<double> high_pressure(const std::vector<Deformation>& elements, const BodyAtPanel& body,
                                    const std::vector<double>& wale, const std::vector<double>& course) {
  constexpr double near = 5.0;  // mm
  constexpr double most = 0.9;
  std::vector<double> all;
  for (size_t e = 0; e < elements.size(); ++e) {
    const body::SurfacePoint& p = body.centre[e];
    if (!p.found || std::abs(p.gap) > near || !std::isfinite(wale[e]) || !std::isfinite(course[e])) continue;
    const Vec3 w = elements[e].wale().normalized(), c = elements[e].course().normalized();
    all.push_back(wale[e] * w.dot(p.hessian * w) + course[e] * c.dot(p.hessian * c));
  }
  if (all.empty()) return std::nullopt;
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(most * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

void add_depth(const mesh::Block& block, const std::vector<Vec3>& position, const std::vector<double>& gap,
               PanelStart& panel) {
  constexpr double counts = 1e-3;  // mm
  const std::set<int> nodes(block.connectivity.begin(), block.connectivity.end());
  for (const int n : nodes) {
    if (-gap[n] <= counts) continue;
    ++panel.inside;
    if (-gap[n] <= panel.depth) continue;
    panel.depth = -gap[n];
    panel.deepest = position[n];
  }
}

/// [node] mm, from the body.
std::vector<double> gaps(const solve::Fields& fields) {
  std::vector<double> gap = fields.gap;
  for (size_t n = 0; n < gap.size(); ++n) gap[n] += fields.offset[n];
  return gap;
}

}  // namespace

std::vector<PanelStart> look_at_panels(const Scene& scene, const solve::Fields& fields) {
  const solve::Problem& problem = scene.problem();
  const mesh::Mesh& mesh = *problem.mesh;
  const std::vector<Vec3>& position = fields.position;
  const std::vector<double> closed = closing(scene, position);
  const std::vector<double> gap = gaps(fields);
  std::vector<PanelStart> panels;
  for (size_t b = 0; b < mesh.blocks.size(); ++b) {
    const std::vector<Deformation> elements = deformations(mesh, mesh.blocks[b], position);
    PanelStart panel;
    panel.name = mesh.blocks[b].name;
    panel.placed_is_stress_free = problem.models[b].is_shell() && problem.models[b].shell.placed_reference;
    panel.wale = extremes_of(elements, [](const Deformation& d) { return d.wale().norm(); });
    panel.course = extremes_of(elements, [](const Deformation& d) { return d.course().norm(); });
    panel.major = extremes_of(elements, [](const Deformation& d) { return d.principal().first; });
    panel.minor = extremes_of(elements, [](const Deformation& d) { return d.principal().second; });
    panel.size = mean_side(mesh.blocks[b], position);
    if (problem.surface != nullptr) {
      const BodyAtPanel body = body_at(*problem.surface, mesh.blocks[b], elements, gap);
      add_depth(mesh.blocks[b], position, gap, panel);
      panel.high_pressure =
          high_pressure(elements, body, values_of(fields, b, "tension_wale"), values_of(fields, b, "tension_course"));
      const double ring = closed[static_cast<size_t>(mesh.blocks[b].panel)];
      if (ring > 0.0 && !panel.placed_is_stress_free)
        panel.round = extremes(elements, stretches_round(elements, body, ring));
    }
    panels.push_back(panel);
  }
  return panels;
}

std::vector<LoosePart> loose_parts(const Scene& scene, const solve::Fields& fields) {
  constexpr double touching = 1.0;  // mm
  const solve::Problem& problem = scene.problem();
  const std::vector<double> gap = gaps(fields);
  std::vector<bool> held(gap.size(), false);
  for (const solve::Support& support : problem.supports)
    for (const int n : support.nodes) held[n] = held[n] || support.held[0] || support.held[1] || support.held[2];
  std::vector<std::string> panel_of(gap.size());
  for (const mesh::MeshedPanel& panel : problem.mesh->panels)
    std::fill_n(panel_of.begin() + panel.first, panel.nodes, panel.name);
  std::vector<LoosePart> loose;
  for (const std::vector<int>& part : solve::connected_parts(problem)) {
    LoosePart found;
    found.gap = std::numeric_limits<double>::infinity();
    std::set<std::string> panels;
    bool is_held = false;
    for (const int c : part)
      for (const int n : problem.clusters[c]) {
        panels.insert(panel_of[n]);
        is_held = is_held || held[n];
        if (problem.surface != nullptr) found.gap = std::min(found.gap, gap[n]);
      }
    if (is_held || found.gap <= touching) continue;
    for (const std::string& name : panels) found.panels += (found.panels.empty() ? "\"" : ", \"") + name + "\"";
    loose.push_back(found);
  }
  return loose;
}

}  // namespace toile::scene
