#include "overlaps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

using solve::Vec3;

/// The middle of an element all of whose nodes touch.
struct Place {
  int panel = 0;
  double area = 0.0;            ///< mm^2
  Vec3 on_body = Vec3::Zero();  ///< mm
  Vec3 normal = Vec3::Zero();
};

/// [node] whether it touches the body.
std::vector<bool> touching_nodes(const solve::Fields& fields) {
  std::vector<bool> touches;
  for (size_t n = 0; n < fields.position.size(); ++n)
    touches.push_back(fields.pressure[n] > 0.0 || fields.contact_force[n] > 0.0);
  return touches;
}

/// The elements in contact, and the area of all elements of each panel.
struct Places {
  std::vector<Place> touching;
  std::vector<double> area;  ///< [panel] mm^2
};

Places places(const result::GarmentOnBody& garment, const std::vector<bool>& touches) {
  const std::vector<Vec3>& position = garment.position;
  Places all;
  all.area.assign(garment.mesh->panels.size(), 0.0);
  for (const mesh::Block& block : garment.mesh->blocks) {
    const auto per = static_cast<size_t>(block.nodes_per_element);
    for (size_t first = 0; first < block.connectivity.size(); first += per) {
      const int* node = &block.connectivity[first];
      Place place;
      place.panel = block.panel;
      const Vec3 across = position[node[2]] - position[node[0]];
      place.area = 0.5 * across.cross(position[node[per - 1]] - position[node[1]]).norm();
      all.area[block.panel] += place.area;
      if (!std::all_of(node, node + per, [&](int n) { return touches[n]; })) continue;
      for (size_t i = 0; i < per; ++i) {
        const int n = node[i];
        place.on_body += (position[n] - garment.distance[n] * garment.normal[n]) / per;
        place.normal += garment.normal[n];
      }
      place.normal.normalize();
      all.touching.push_back(place);
    }
  }
  return all;
}

/// What lies over the body where the fabric touches it.
class FabricOnBody {
 public:
  FabricOnBody(const result::GarmentOnBody& garment, const std::vector<bool>& touches)
      : mesh_(*garment.mesh), all_(places(garment, touches)) {
    std::vector<Vec3> points, normals;
    for (const Place& place : all_.touching) {
      points.push_back(place.on_body);
      normals.push_back(place.normal);
    }
    const result::BodyMap map(garment, points, normals);
    for (const mesh::MeshedPanel& panel : mesh_.panels) {
      std::vector<double> touch(touches.size(), 0.0);
      for (int n = panel.first; n < panel.first + panel.nodes; ++n) touch[n] = touches[n] ? 1.0 : 0.0;
      over_.push_back(map.over(touch));
    }
  }

  std::string name(int panel) const { return "\"" + mesh_.panels[panel].name + "\""; }
  double area(int panel) const { return all_.area[panel]; }

  /// Area of a panel where it touches and one of the others does, mm^2.
  double area_with(int panel, const std::vector<int>& others) const {
    double area = 0.0;
    for (size_t i = 0; i < all_.touching.size(); ++i)
      if (all_.touching[i].panel == panel && is_there(panel, i) &&
          std::any_of(others.begin(), others.end(), [&](int other) { return is_there(other, i); }))
        area += all_.touching[i].area;
    return area;
  }

 private:
  /// Fabric beside a seam lies once over a place, whichever of the two panels it is.
  bool is_there(int panel, size_t place) const { return over_[panel][place] > 0.5; }

  const mesh::Mesh& mesh_;
  Places all_;
  std::vector<std::vector<double>> over_;  ///< [panel][place] 1 where it touches
};

std::string rounded_percent(double share) {
  return std::to_string(std::lround(100.0 * share)) + " %";
}

/// Two panels that share the skin without being told to.
struct Untold {
  std::string text;    ///< "panels "a" and "b" lie over each other on 40 % of "a""
  std::string remedy;  ///< what to write
};

std::vector<Untold> untold(const FabricOnBody& fabric, const std::vector<std::vector<int>>& beneath) {
  constexpr double counts = 0.05;  // less are folds beside seams
  const auto is_beneath = [&](int a, int b) {
    return std::find(beneath[b].begin(), beneath[b].end(), a) != beneath[b].end();
  };
  std::vector<Untold> all;
  const int panels = static_cast<int>(beneath.size());
  for (int a = 0; a < panels; ++a)
    for (int b = a + 1; b < panels; ++b) {
      if (is_beneath(a, b) || is_beneath(b, a)) continue;
      const double of_a = fabric.area_with(a, {b}) / fabric.area(a), of_b = fabric.area_with(b, {a}) / fabric.area(b);
      const double most = std::max(of_a, of_b);
      if (most <= counts) continue;
      const std::string first = fabric.name(a), second = fabric.name(b);
      all.push_back({"panels " + first + " and " + second + " lie over each other on " + rounded_percent(most) +
                         " of " + (of_a > of_b ? first : second),
                     "Let the outer one name the inner one in its \"over\": " + second + " names " + first + ", or " +
                         first + " names " + second});
    }
  return all;
}

/// Empty: none.
std::string beside(const FabricOnBody& fabric, int panel, const std::vector<int>& beneath) {
  constexpr double most_of_it = 0.8;  // what is missing are rows at an edge
  const double touching = fabric.area_with(panel, {panel});
  const double covered = fabric.area_with(panel, beneath);
  if (covered >= most_of_it * touching) return "";
  return "panel " + fabric.name(panel) + " lies over what its \"over\" names on only " +
         rounded_percent(covered / touching) +
         " of the area where it presses, and is lifted off the body by that everywhere. Divide it where what lies "
         "beneath it ends";
}

bool may_overlap(const scene::Scene& scene) {
  return scene.surface() != nullptr && scene.problem().mesh->panels.size() > 1;
}

/// [panel] what it names in "over".
std::vector<std::vector<int>> told(const scene::Scene& scene) {
  std::vector<std::vector<int>> beneath = scene.problem().beneath;
  beneath.resize(scene.problem().mesh->panels.size());
  return beneath;
}

}  // namespace

std::vector<std::string> overlap_faults(const scene::Scene& scene, const solve::Fields& fields,
                                        const solve::StepReport& report) {
  std::vector<std::string> texts;
  if (!may_overlap(scene)) return texts;
  const std::vector<std::vector<int>> beneath = told(scene);
  const FabricOnBody fabric(on_body(scene.problem(), fields, report.seam), touching_nodes(fields));
  for (const Untold& pair : untold(fabric, beneath))
    texts.push_back(pair.text +
                    ", and both lie on the body itself: the outer one presses too little, the more so the thicker the "
                    "inner one is. " +
                    pair.remedy);
  for (size_t panel = 0; panel < beneath.size(); ++panel)
    if (!beneath[panel].empty()) texts.push_back(beside(fabric, static_cast<int>(panel), beneath[panel]));
  texts.erase(std::remove(texts.begin(), texts.end(), ""), texts.end());
  return texts;
}

std::vector<std::string> overlaps_of_start(const scene::Scene& scene, const solve::Fields& fields) {
  constexpr double near = 5.0;  // mm
  std::vector<std::string> texts;
  if (!may_overlap(scene)) return texts;
  result::GarmentOnBody garment = on_body(scene.problem(), fields, scene.start().seam);
  std::vector<bool> is_near;
  for (double& distance : garment.distance) {
    is_near.push_back(std::abs(distance) <= near);
    distance = std::min(distance, near);  // what hangs further off is not looked for
  }
  for (const Untold& pair : untold(FabricOnBody(garment, is_near), told(scene)))
    texts.push_back(pair.text + " where they start. If they stay there, the outer one will press too little. " +
                    pair.remedy);
  return texts;
}

}  // namespace toile::run
