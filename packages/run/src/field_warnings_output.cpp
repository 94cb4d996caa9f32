// What limits the trust in the last state: levels that are not reached or open, a garment that does not press, fabric
// outside its calibrated range, nodes inside the body, elements that it goes through, contact off the smooth surface.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

#include "output.hpp"
#include "toile/solve/output_fields.hpp"

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

/// Elements that are large beside the body's radius: what the recovery compares is wrong alike there, and the told
/// error too small (a sleeve of 8 elements round a cylinder: 0.7 times the true one, of 4: 0.08 times). Empty: there
/// are few, and none on an edge that the mesh does not see at all (1 mm radius, elements of 1 mm: 0.15 times).
std::string too_large_elements(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double too_much = 40.0 * M_PI / 180.0, few = 0.02;  // of the elements in contact
  constexpr double edge = 60.0 * M_PI / 180.0;
  int large = 0, touching = 0;
  double most = 0.0;
  solve::Vec3 where = solve::Vec3::Zero();
  for (const mesh::Block& block : scene.problem().mesh->blocks) {
    const auto nodes = static_cast<size_t>(block.nodes_per_element);
    for (size_t first = 0; first < block.connectivity.size(); first += nodes) {
      const int* node = &block.connectivity[first];
      if (!std::all_of(node, node + nodes,
                       [&](int n) { return fields.pressure[n] > 0.0 || fields.contact_force[n] > 0.0; }))
        continue;
      double turn = 0.0;
      for (size_t i = 0; i < nodes; ++i)
        turn = std::max(
            turn, std::acos(std::clamp(fields.normal[node[i]].dot(fields.normal[node[(i + 1) % nodes]]), -1.0, 1.0)));
      ++touching;
      if (turn > too_much) ++large;
      if (turn <= most) continue;
      most = turn;
      where = fields.position[node[0]];
    }
  }
  if (large == 0 || (large < few * touching && most <= edge)) return "";
  std::ostringstream text;
  text.precision(3);
  text << "the elements are too large for the body: within " << large << " of " << touching
       << " in contact it turns by more than 40 degrees, up to " << most * 180.0 / M_PI << " at (" << where.x() << ", "
       << where.y() << ", " << where.z()
       << ") mm. Their pressures are too low, and the told errors may be too small; \"finer\" = "
       << std::ceil(2.0 * most / too_much) / 2.0 << " at least";
  return text.str();
}

/// Fabrics that are stretched along a yarn beyond the tests that they were fitted to.
std::vector<std::string> beyond_tests(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double counts = 0.01;  // of stretch
  struct Direction {
    const char* name;
    double material::FitLimits::*tested;
  };
  std::vector<std::string> warnings;
  for (const Direction& direction :
       {Direction{"wale", &material::FitLimits::wale}, Direction{"course", &material::FitLimits::course}})
    for (size_t b = 0; b < fields.element.size(); ++b) {
      const material::Material& fabric = *scene.problem().models[b].material;
      const double tested = fabric.fit_limits().*direction.tested;
      const std::vector<double>& stretch =
          solve::named(fields.element[b], std::string("stretch_") + direction.name).values;
      const double largest = stretch.empty() ? 0.0 : *std::max_element(stretch.begin(), stretch.end());
      if (tested == 0.0 || largest <= tested + counts) continue;
      std::ostringstream text;
      text.precision(3);
      text << "panel \"" << scene.problem().mesh->blocks[b].name << "\" is stretched along the " << direction.name
           << " to " << largest << ", and the tests that its fabric \"" << fabric.name() << "\" was fitted to reach "
           << tested << " there: its pressures are extrapolated";
      warnings.push_back(text.str());
    }
  return warnings;
}

std::string pierced_text(const Pierced& pierced) {
  std::ostringstream text;
  text.precision(3);
  text << "the body goes through " << pierced.elements << " elements between their nodes and sticks out of them by "
       << (pierced.share < 1.0 ? "" : "more than ") << pierced.height << " mm at (" << pierced.where.x() << ", "
       << pierced.where.y() << ", " << pierced.where.z() << ") mm, " << std::fixed << std::setprecision(2)
       << pierced.share
       << " times their side: they are too large for its tip or edge there, on which the fabric presses as if there "
          "were none. Pressures near it are wrong, whatever their told error";
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
  if (const std::string large = too_large_elements(scene, fields); !large.empty()) warnings.push_back(large);
  if (report.extrapolated > 0) {
    std::ostringstream text;
    text << "outside the calibrated range of the fabric: " << report.extrapolated << " elements, largest fibre stretch "
         << fields.largest_extrapolation << " in " << fields.extrapolated_where;
    warnings.push_back(text.str());
  }
  for (const std::string& beyond : beyond_tests(scene, fields)) warnings.push_back(beyond);
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
    if (is_idle(record.scene(), fields) && record.pierced().passed == 0)
      log_.warn("the garment presses on the body nowhere: it is wider than the body, or beside it");
    for (const std::string& warning : field_warnings(record.scene(), fields, record.last())) log_.warn(warning);
    if (record.pierced().elements > 0) log_.warn(pierced_text(record.pierced()));
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
