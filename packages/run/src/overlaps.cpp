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

/// Panels of which each shares the skin with each other without being told to.
struct Untold {
  std::vector<int> panels;  ///< ascending
  double share = 0.0;       ///< the largest of a panel that lies over or under another of them
  int of = 0;               ///< that panel
};

std::vector<Untold> untold_pairs(const FabricOnBody& fabric, const std::vector<std::vector<int>>& beneath) {
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
      if (std::max(of_a, of_b) > counts) all.push_back({{a, b}, std::max(of_a, of_b), of_a > of_b ? a : b});
    }
  return all;
}

/// Pairs of one group are told together: of four layers there are six.
std::vector<Untold> untold(const FabricOnBody& fabric, const std::vector<std::vector<int>>& beneath) {
  std::vector<Untold> groups;
  std::vector<Untold> pairs = untold_pairs(fabric, beneath);
  const auto is_pair = [all = pairs](int a, int b) {
    const std::vector<int> panels = {std::min(a, b), std::max(a, b)};
    return std::any_of(all.begin(), all.end(), [&](const Untold& pair) { return pair.panels == panels; });
  };
  while (!pairs.empty()) {
    Untold group = pairs.front();
    for (int panel = 0; panel < static_cast<int>(beneath.size()); ++panel)
      if (std::all_of(group.panels.begin(), group.panels.end(), [&](int other) { return is_pair(panel, other); }))
        group.panels.push_back(panel);
    std::sort(group.panels.begin(), group.panels.end());
    const auto is_in_group = [&group](const Untold& pair) {
      return std::includes(group.panels.begin(), group.panels.end(), pair.panels.begin(), pair.panels.end());
    };
    for (const Untold& pair : pairs)
      if (is_in_group(pair) && pair.share > group.share) {
        group.share = pair.share;
        group.of = pair.of;
      }
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_in_group), pairs.end());
    groups.push_back(group);
  }
  return groups;
}

/// "panels "a", "b" and "c" lie over each other on up to 40 % of "b""
std::string text_of(const Untold& group, const FabricOnBody& fabric) {
  std::string names;
  for (const int panel : group.panels)
    names += (names.empty() ? "" : panel == group.panels.back() ? " and " : ", ") + fabric.name(panel);
  return "panels " + names + " lie over each other on " + (group.panels.size() > 2 ? "up to " : "") +
         rounded_percent(group.share) + " of " + fabric.name(group.of);
}

/// What to write.
std::string remedy(const Untold& group, const FabricOnBody& fabric) {
  const std::string first = fabric.name(group.panels[0]), second = fabric.name(group.panels[1]);
  if (group.panels.size() > 2) return "Let each but the innermost name in its \"over\" the one beneath it";
  return "Let the outer one name the inner one in its \"over\": " + second + " names " + first + ", or " + first +
         " names " + second;
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
  for (const Untold& group : untold(fabric, beneath))
    texts.push_back(text_of(group, fabric) +
                    (group.panels.size() > 2
                         ? ", and all lie on the body itself: the outer ones press too little, the more so the "
                           "thicker those beneath them are. "
                         : ", and both lie on the body itself: the outer one presses too little, the more so the "
                           "thicker the inner one is. ") +
                    remedy(group, fabric));
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
  const FabricOnBody fabric(garment, is_near);
  for (const Untold& group : untold(fabric, told(scene)))
    texts.push_back(text_of(group, fabric) + " where they start. If they stay there, the outer " +
                    (group.panels.size() > 2 ? "ones" : "one") + " will press too little. " + remedy(group, fabric));
  return texts;
}

}  // namespace toile::run
