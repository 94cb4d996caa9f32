// What limits the trust in the last state: levels that are not reached or open, a garment that does not press, fabric
// outside its calibrated range, nodes inside the body, contact off the smooth surface, edges that the mesh does not
// see.
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "output.hpp"

namespace toile::run {

namespace {

/// Contact lets no free node into the body, so those that are inside are held there. Empty: there are none.
std::string held_inside(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double counts = 0.01;  // mm
  double deepest = counts;
  std::string name;
  std::set<int> inside;
  if (scene.surface() == nullptr) return "";
  for (const solve::Support& support : scene.problem().supports)
    for (const int n : support.nodes) {
      if (!(fields.gap[n] < -counts)) continue;
      inside.insert(n);
      if (-fields.gap[n] <= deepest) continue;
      deepest = -fields.gap[n];
      name = support.name;
    }
  if (inside.empty()) return "";
  std::ostringstream text;
  text.precision(3);
  text << "supports hold " << inside.size() << " nodes inside the body, up to " << deepest << " mm (support \"" << name
       << "\"): the fabric steps over the body's surface beside them, and its pressure there is that of the step. "
          "The inner face counts, half a thickness inside the mid-surface: place the panel with an \"offset\", or let "
          "the support leave the direction of the body's normal free";
  return text.str();
}

/// Where the body turns so far from one node in contact to the next that no pressure between them means anything. Round
/// a circle of that curvature there would be fewer than eight elements: the pressure is a mean over much of the edge,
/// and its error is larger than what is estimated. Empty: nowhere.
std::string sharp_edges(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double most = M_PI / 4.0;
  double largest = most;
  const solve::Vec3* place = nullptr;
  int count = 0;
  for (const mesh::Block& block : scene.garment().mesh.blocks) {
    const auto corners = static_cast<std::size_t>(block.nodes_per_element);
    for (std::size_t e = 0; e < static_cast<std::size_t>(block.size()); ++e) {
      double turn = 0.0;
      for (std::size_t k = 0; k < corners; ++k) {
        const int a = block.connectivity[e * corners + k], b = block.connectivity[e * corners + (k + 1) % corners];
        if (!(fields.contact_force[a] > 0.0 && fields.contact_force[b] > 0.0)) continue;
        const double angle = std::acos(std::clamp(fields.normal[a].dot(fields.normal[b]), -1.0, 1.0));
        turn = std::max(turn, angle);
        if (angle <= largest) continue;
        largest = angle;
        place = &fields.position[a];
      }
      count += turn > most ? 1 : 0;
    }
  }
  if (place == nullptr) return "";
  std::ostringstream text;
  text.precision(3);
  text << "the body turns by up to " << largest * 180.0 / M_PI << " degrees within one element, in " << count
       << " elements by more than 45, most near (" << place->x() << ", " << place->y() << ", " << place->z()
       << ") mm: the mesh does not see such an edge, and neither the pressure there nor its error can be trusted; make "
          "the elements smaller than its radius";
  return text.str();
}

/// A garment that does not press may be right, but nobody runs a scene for it.
bool is_idle(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double nothing = 1e-7;  // MPa
  const auto presses = [](double pressure) { return pressure > nothing; };
  return scene.surface() != nullptr && std::none_of(fields.pressure.begin(), fields.pressure.end(), presses);
}

std::vector<std::string> field_warnings(const scene::Scene& scene, const solve::Fields& fields,
                                        const solve::StepReport& report) {
  std::vector<std::string> warnings;
  if (const std::string inside = held_inside(scene, fields); !inside.empty()) warnings.push_back(inside);
  if (const std::string edges = sharp_edges(scene, fields); !edges.empty()) warnings.push_back(edges);
  if (report.extrapolated > 0) {
    std::ostringstream text;
    text << "outside the calibrated range of the fabric: " << report.extrapolated << " elements, largest fibre stretch "
         << fields.largest_extrapolation << " in " << fields.extrapolated_where;
    warnings.push_back(text.str());
  }
  if (fields.isolated_contacts > 0)
    warnings.push_back(std::to_string(fields.isolated_contacts) +
                       " nodes touch the body while all their neighbours are free: the mesh is too coarse there, and "
                       "their pressure is as uncertain as it is large (field pressure_error)");
  if (fields.contacts_off_surface > 0)
    warnings.push_back("the body has no smooth surface near " + std::to_string(fields.contacts_off_surface) +
                       " nodes in contact: their pressure shows its facets");
  return warnings;
}

class FieldWarnings : public Observer {
 public:
  explicit FieldWarnings(base::Log& log) : log_(log) {}

  void end(const Record& record) override {
    const solve::Fields& fields = record.fields();
    for (const std::string& warning : record.pressure().warnings) log_.warn(warning);
    if (is_idle(record.scene(), fields))
      log_.warn("the garment presses on the body nowhere: it is wider than the body, or beside it");
    for (const std::string& warning : field_warnings(record.scene(), fields, record.last())) log_.warn(warning);
  }

 private:
  base::Log& log_;
};

}  // namespace

Output field_warnings_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<FieldWarnings>(context.log);
          }};
}

}  // namespace toile::run
