#include "toile/run/pressure_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "toile/result/body_map.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::run {

namespace {

result::Axis axis_of(const scene::Output& output) {
  result::Axis axis{output.axis_point, output.axis_direction};
  if (!output.bent_axis) return axis;
  axis.length = output.bent_axis->length();
  axis.bent = [&bent = *output.bent_axis](double height) {
    const mesh::BentAxis::Place place = bent.at(height);
    return result::AxisPlace{place.point, place.direction};
  };
  return axis;
}

/// The plane of symmetry in which a support holds its nodes: its normal, x, y or z, and where it is along it, mm. A
/// section goes on in the mirror image only if the plane runs along the limb: a hem that is held at its height is none.
std::optional<std::pair<int, double>> mirror_plane(const scene::Scene& scene, const solve::Support& support) {
  constexpr double flat = 1e-6;  // mm; of the sine of an angle
  const solve::Problem& problem = scene.problem();
  if (std::count(support.held.begin(), support.held.end(), true) != 1 || support.nodes.size() < 2) return std::nullopt;
  if (!support.axes.empty() || support.turn || support.displacement != solve::Vec3::Zero()) return std::nullopt;
  const auto normal = std::find(support.held.begin(), support.held.end(), true) - support.held.begin();
  const scene::Output& output = scene.output();
  if (output.bent_axis || std::abs(output.axis_direction.normalized()[normal]) > flat) return std::nullopt;
  const double place = problem.mesh->placed[support.nodes.front()][normal];
  const bool in_plane = std::all_of(support.nodes.begin(), support.nodes.end(),
                                    [&](int n) { return std::abs(problem.mesh->placed[n][normal] - place) <= flat; });
  if (!in_plane) return std::nullopt;
  return std::pair(static_cast<int>(normal), std::round(place / flat) * flat);
}

/// Of a garment that lies on one side of a plane of symmetry: places and normals beyond it, seen in the plane.
class MirrorImages {
 public:
  explicit MirrorImages(const scene::Scene& scene) {
    constexpr double on_plane = 1e-3;  // mm
    for (const solve::Support& support : scene.problem().supports) {
      const auto plane = mirror_plane(scene, support);
      if (!plane) continue;
      double least = HUGE_VAL, most = -HUGE_VAL;
      for (const solve::Vec3& node : scene.problem().mesh->placed) {
        least = std::min(least, node[plane->first] - plane->second);
        most = std::max(most, node[plane->first] - plane->second);
      }
      if (least >= -on_plane) planes_.push_back({plane->first, plane->second, 1.0});
      if (most <= on_plane) planes_.push_back({plane->first, plane->second, -1.0});
    }
  }
  void bring_back(solve::Vec3& place, solve::Vec3& normal) const {
    for (const Plane& plane : planes_) {
      const double off = place[plane.axis] - plane.at;
      if (off * plane.side >= 0.0) continue;
      place[plane.axis] = plane.at - off;
      normal[plane.axis] = -normal[plane.axis];
    }
  }

 private:
  struct Plane {
    int axis;
    double at, side;  ///< mm; 1: the garment lies above
  };
  std::vector<Plane> planes_;
};

/// With its error: `parts` is [solve::error_parts()][place] MPa.
PointPressure with_parts(PointPressure at, const std::vector<std::vector<double>>& parts, std::size_t place) {
  for (const std::vector<double>& part : parts) at.error_parts.push_back(part[place]);
  at.error = std::sqrt(std::inner_product(at.error_parts.begin(), at.error_parts.end(), at.error_parts.begin(), 0.0));
  return at;
}

/// Which of solve::error_parts() is the mesh's.
size_t mesh_part() {
  const auto& parts = solve::error_parts();
  return std::find_if(parts.begin(), parts.end(),
                      [](const solve::ErrorPart& part) { return part.values == &solve::PressureErrors::mesh; }) -
         parts.begin();
}

/// [solve::error_parts()][node] MPa. Whether fabric touches is known within an element: a node that is free may press
/// like the neighbour that presses most.
std::vector<std::vector<double>> parts_of_points(const scene::Scene& scene, const solve::Fields& fields) {
  std::vector<double> mesh = fields.errors.mesh;
  for (const mesh::Block& block : scene.problem().mesh->blocks) {
    const int per = block.nodes_per_element;
    for (auto node = block.connectivity.begin(); node != block.connectivity.end(); node += per) {
      double most = 0.0;
      std::for_each(node, node + per, [&](int n) { most = std::max(most, fields.pressure[n]); });
      std::for_each(node, node + per, [&](int n) {
        if (!(fields.pressure[n] > 0.0)) mesh[n] = std::max(mesh[n], most);
      });
    }
  }
  std::vector<std::vector<double>> parts;
  for (const solve::ErrorPart& part : solve::error_parts()) parts.push_back(fields.errors.*part.values);
  parts[mesh_part()] = std::move(mesh);
  return parts;
}

}  // namespace

std::vector<std::string> error_names() {
  std::vector<std::string> names;
  for (const solve::ErrorPart& part : solve::error_parts()) names.emplace_back(part.name);
  return names;
}

std::vector<int> mirror_planes(const scene::Scene& scene) {
  const solve::Problem& problem = scene.problem();
  std::vector<int> plane(static_cast<size_t>(problem.mesh->nodes()), -1);
  std::map<std::pair<int, double>, int> number;
  for (const solve::Support& support : problem.supports)
    if (const auto found = mirror_plane(scene, support)) {
      const int k = number.try_emplace(*found, static_cast<int>(number.size())).first->second;
      for (const int n : support.nodes) plane[n] = k;
    }
  return plane;
}

std::vector<int> tied_nodes(const solve::Problem& problem, double seam) {
  std::vector<int> tied(static_cast<size_t>(problem.mesh->nodes()));
  std::iota(tied.begin(), tied.end(), 0);
  if (seam != 1.0) return tied;
  for (const std::vector<int>& cluster : problem.clusters)
    for (const int n : cluster) tied[n] = cluster.front();
  return tied;
}

result::GarmentOnBody on_body(const solve::Problem& problem, const solve::Fields& fields, double seam) {
  std::vector<double> distance = fields.gap;
  for (size_t n = 0; n < distance.size(); ++n) distance[n] += fields.offset[n];
  return {problem.mesh, fields.position, tied_nodes(problem, seam), distance, fields.normal};
}

std::vector<bool> elements_at_supports(const scene::Scene& scene) {
  const solve::Problem& problem = scene.problem();
  std::vector<bool> held(static_cast<size_t>(problem.mesh->nodes()), false), at_support;
  for (const solve::Support& support : problem.supports)
    if (!mirror_plane(scene, support))
      for (const int n : support.nodes) held[n] = true;
  for (const mesh::Block& block : problem.mesh->blocks) {
    const int per = block.nodes_per_element;
    for (auto node = block.connectivity.begin(); node != block.connectivity.end(); node += per) {
      const auto count = std::count_if(node, node + per, [&](int n) { return held[n]; });
      at_support.push_back(count > 0 && count < per);
    }
  }
  return at_support;
}

const result::LevelRow* section(const PressureReport& pressure, const std::string& title, std::string& problem) {
  std::string titles;
  for (const result::LevelRow& row : pressure.levels) {
    if (row.title() == title) return &row;
    if (row.name != title) continue;
    titles += (titles.empty() ? "" : ", ") + row.title();
  }
  problem = titles.empty() ? "no section is named \"" + title + "\""
                           : "level \"" + title + "\" has the sections " + titles + "; name one of them";
  return nullptr;
}

std::vector<PointPressure> point_pressures(const scene::Scene& scene, const std::vector<scene::Point>& at,
                                           const solve::Fields& fields) {
  if (at.empty()) return {};
  const std::vector<std::vector<double>> parts = parts_of_points(scene, fields);
  std::vector<PointPressure> all;
  for (const scene::Point& point : at)
    all.push_back(with_parts({fields.pressure[point.node], 0.0, {}, fields.gap[point.node]}, parts, point.node));
  return all;
}

std::vector<PointPressure> body_pressures(const scene::Scene& scene, const std::vector<scene::BodyPoint>& at,
                                          const solve::Fields& fields, const solve::StepReport& report) {
  std::vector<solve::Vec3> places, normals;
  const MirrorImages images(scene);
  for (const scene::BodyPoint& point : at) {
    places.push_back(point.place);
    normals.push_back(point.normal);
    images.bring_back(places.back(), normals.back());
  }
  if (places.empty()) return {};
  const result::BodyMap map(on_body(scene.problem(), fields, report.seam), places, normals);
  const std::vector<double> pressure = map.on(fields.pressure), beside = map.beside(fields.pressure),
                            gap = map.over(fields.gap);
  std::vector<std::vector<double>> parts;
  for (const std::vector<double>& part : parts_of_points(scene, fields)) parts.push_back(map.on(part));
  std::vector<PointPressure> all;
  for (size_t p = 0; p < places.size(); ++p) {
    parts[mesh_part()][p] = std::hypot(parts[mesh_part()][p], beside[p]);
    all.push_back(with_parts({pressure[p], 0.0, {}, std::nullopt}, parts, p));
    if (map.layers()[p] > 0) all.back().gap = (gap[p] + map.excess()[p]) / map.layers()[p];
  }
  return all;
}

PressureReport pressure_report(const scene::Scene& scene, const solve::Fields& fields,
                               const solve::StepReport& report) {
  const scene::Output& output = scene.output();
  PressureReport found;
  if (scene.surface() == nullptr || (output.stations == 0 && output.levels.empty())) return found;
  result::GarmentFields garment{&scene.garment().mesh,
                                fields.position,
                                tied_nodes(scene.problem(), report.seam),
                                fields.pressure,
                                {},
                                fields.tension,
                                solve::named(solve::element_fields(fields), "cauchy_minor").values,
                                elements_at_supports(scene),
                                mirror_planes(scene)};
  for (const solve::ErrorPart& part : solve::error_parts()) {
    const bool of_body = part.values == &solve::PressureErrors::body;
    garment.pressure_errors.push_back({part.name, of_body ? fields.body_change : fields.errors.*part.values});
  }
  const result::Axis axis = axis_of(output);
  std::vector<result::Level> levels;
  for (const scene::Level& level : output.levels) levels.push_back({level.name, level.height});
  found.levels = result::levels(garment, axis, levels);
  found.warnings = result::level_warnings(garment, axis, found.levels);
  if (output.stations > 0) found.curve = result::pressure_curve(garment, axis, output.stations);
  if (output.stations > 0 && found.curve.empty())
    found.warnings.emplace_back("pressure-curve.csv is empty: at no height does the garment close round the body");
  return found;
}

}  // namespace toile::run
