#include "toile/scene/start_report.hpp"

#include <algorithm>
#include <optional>

#include "held_seams.hpp"
#include "start_fabric.hpp"
#include "start_seams.hpp"
#include "start_text.hpp"
#include "start_warnings.hpp"
#include "toile/base/units.hpp"
#include "toile/mesh/quality.hpp"

namespace toile::scene {

namespace {

using Texts = std::vector<std::string>;

void append(Texts& all, const Texts& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::string range(const Extremes& e) {
  const std::string smallest = short_number(e.smallest), largest = short_number(e.largest);
  return smallest == largest ? smallest : smallest + " to " + largest;
}

std::string line(const PanelStart& panel) {
  std::string text = "panel \"" + panel.name + "\": ";
  if (panel.placed_is_stress_free)
    text += "free of stress as it is placed";
  else
    text += "stretch " + range(panel.wale) + " along the wale, " + range(panel.course) + " along the course";
  if (panel.round) text += "; round the body, seams closed, " + range(*panel.round);
  return text;
}

std::string line(const garment::Seam& seam, const SeamStart& start) {
  return "seam \"" + seam.name + "\": " + seam.first + " to " + seam.second + ", " + short_number(start.mean_gap) +
         " mm apart on average, at most " + short_number(start.largest_gap) + " (from the other end " +
         short_number(start.other_gap) + ")";
}

/// Size of the mesh, and its worst elements in the flat pattern.
std::string mesh_line(const mesh::Mesh& mesh) {
  int triangles = 0;
  for (const mesh::Block& block : mesh.blocks)
    if (block.nodes_per_element == 3) triangles += block.size();
  const int quadrilaterals = mesh.elements() - triangles;
  std::string elements;
  if (quadrilaterals > 0) elements = std::to_string(quadrilaterals) + " quadrilaterals";
  if (triangles > 0) elements += (elements.empty() ? "" : ", ") + std::to_string(triangles) + " triangles";
  mesh::Quality worst;
  std::string panel;
  double aspect = 1.0, jacobian = 1.0;
  for (size_t p = 0; p < mesh.panels.size(); ++p) {
    const mesh::Quality quality = quality_of(mesh, static_cast<int>(p));
    aspect = std::max(aspect, quality.largest_aspect);
    jacobian = std::min(jacobian, quality.smallest_jacobian);
    if (!panel.empty() && quality.smallest_angle >= worst.smallest_angle) continue;
    worst = quality;
    panel = mesh.panels[p].name;
  }
  return "mesh: " + std::to_string(mesh.nodes()) + " nodes, " + elements + "; smallest angle " +
         short_number(worst.smallest_angle) + " degrees, in panel \"" + panel + "\" at (" +
         short_number(worst.worst.x()) + ", " + short_number(worst.worst.y()) +
         ") mm of its pattern; longest side of an element at most " + short_number(aspect) +
         " times its shortest, smallest Jacobian at least " + short_number(jacobian) + " of the largest";
}

/// What the placed garment does to the body: depth and estimated pressure.
Texts body_lines(const std::vector<PanelStart>& panels, bool open) {
  const auto deepest =
      std::max_element(panels.begin(), panels.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; });
  Texts lines;
  if (deepest->inside > 0)
    lines.push_back("inside the body: at most " + short_number(deepest->depth) + " mm, at " +
                    place_text(deepest->deepest) + " of panel \"" + deepest->name + "\"");
  else
    lines.push_back("inside the body: no node");
  std::optional<double> high;
  for (const PanelStart& panel : panels)
    if (panel.high_pressure) high = std::max(high.value_or(0.0), *panel.high_pressure);
  if (high && *high > 0.0)
    lines.push_back("pressure of the fabric as it is placed" + std::string(open ? ", seams open" : "") +
                    ": nine tenths below " + short_number(base::mpa_to_kpa(*high)) + " kPa (" +
                    short_number(base::kpa_to_mmhg(base::mpa_to_kpa(*high))) + " mmHg), by Laplace");
  return lines;
}

}  // namespace

StartReport look_at_start(const Scene& scene, const base::List& list, const solve::Fields& fields) {
  const std::vector<PanelStart> panels = look_at_panels(scene, fields);
  const std::vector<SeamStart> seams = look_at_seams(scene);
  const bool open = !seams.empty() && scene.start().seam < 1.0;
  StartReport report;
  for (const PanelStart& panel : panels) {
    report.lines.push_back(line(panel));
    append(report.warnings, stretch_warnings(panel));
    append(report.warnings, depth_warnings(panel));
  }
  for (size_t s = 0; s < seams.size(); ++s) report.lines.push_back(line(scene.garment().seams[s], seams[s]));
  report.errors = seam_errors(scene, list, seams);
  if (report.errors.empty()) report.errors = held_seam_errors(scene, list);
  for (size_t s = 0; s < seams.size() && report.errors.empty(); ++s)
    append(report.warnings, seam_warnings(scene.garment().seams[s], seams[s]));
  if (scene.surface() != nullptr) append(report.lines, body_lines(panels, open));
  report.lines.push_back(mesh_line(scene.garment().mesh));
  append(report.warnings, forgotten_seam_warnings(scene));
  if (report.errors.empty()) append(report.warnings, held_seam_warnings(scene));
  append(report.warnings, crossing_warnings(scene, fields));
  append(report.warnings, scene.body().warnings);
  append(report.warnings, scale_warnings(scene.body(), panels));
  append(report.warnings, size_warnings(list, panels));
  append(report.warnings, level_warnings(scene));
  append(report.warnings, place_warnings(list, scene.garment().mesh));
  append(report.warnings, fit_warnings(scene));
  append(report.warnings, weight_warnings(list));
  append(report.warnings, beyond_warnings(scene));
  append(report.warnings, girth_warnings(panels));
  append(report.warnings, pressure_warnings(panels));
  append(report.warnings, loose_warnings(loose_parts(scene, fields), !open));
  return report;
}

}  // namespace toile::scene
