#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "toile/base/error.hpp"
#include "toile/base/units.hpp"
#include "toile/result/body_map.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"
#include "toile/result/pressure_lines.hpp"
#include "toile/result/state_file.hpp"
#include "torques.hpp"

namespace toile::app {

namespace {

/// Units of solve::element_field_names(problem), in their order.
const std::vector<std::string> element_units = {"",     "",     "",    "",   "MPa", "MPa", "MPa", "MPa", "MPa",
                                                "N/mm", "N/mm", "MPa", "mm", "",    "",    "",    "",    ""};

std::vector<result::FieldName> global_names(const solve::Problem& problem) {
  std::vector<result::FieldName> names = {{"load", ""},
                                          {"seam_closing", ""},
                                          {"strain_energy", "N mm"},
                                          {"dissipated_energy", "N mm"},
                                          {"dissipation_ratio", ""},
                                          {"iterations", ""},
                                          {"cut_backs", ""},
                                          {"residual", ""},
                                          {"undamped_residual", ""},
                                          {"largest_gap", "mm"},
                                          {"negative_pivots", ""},
                                          {"critical_point", ""},
                                          {"undamped", ""},
                                          {"wall_time", "s"}};
  const std::vector<result::FieldName> of_supports = torque_names(problem);
  names.insert(names.end(), of_supports.begin(), of_supports.end());
  return names;
}

std::vector<double> global_values(const solve::Problem& problem, const solve::StepReport& r) {
  std::vector<double> values = {r.load,
                                r.seam,
                                r.strain_energy,
                                r.dissipated,
                                r.dissipation_ratio,
                                static_cast<double>(r.iterations),
                                static_cast<double>(r.cut_backs),
                                r.residual,
                                r.undamped_residual,
                                r.gap,
                                static_cast<double>(r.negative_pivots),
                                static_cast<double>(r.critical),
                                r.undamped ? 1.0 : 0.0,
                                r.seconds};
  const std::vector<double> of_supports = torques(problem, r);
  values.insert(values.end(), of_supports.begin(), of_supports.end());
  return values;
}

result::FieldNames field_names(const solve::Problem& problem, bool with_body) {
  result::FieldNames names;
  if (with_body)
    names.nodal = {{"pressure", "kPa"}, {"gap", "mm"}, {"normal_x", ""}, {"normal_y", ""}, {"normal_z", ""}};
  names.nodal.push_back({"area", "mm^2"});
  const std::vector<std::string> element_names = solve::element_field_names(problem);
  for (size_t i = 0; i < element_names.size(); ++i) names.element.push_back({element_names[i], element_units[i]});
  names.global = global_names(problem);
  return names;
}

std::vector<double> concatenate(const solve::Fields& fields, size_t field) {
  std::vector<double> all;
  for (const auto& block : fields.element)
    all.insert(all.end(), block[field].values.begin(), block[field].values.end());
  return all;
}

std::vector<double> element_field(const solve::Fields& fields, const std::string& name) {
  const auto& block = fields.element.at(0);
  const auto field = std::find_if(block.begin(), block.end(), [&](const auto& f) { return f.name == name; });
  return concatenate(fields, static_cast<size_t>(field - block.begin()));
}

/// [element] true where some nodes are held by a support and others are not.
std::vector<bool> elements_at_supports(const scene::Scene& scene) {
  const mesh::Mesh& mesh = scene.garment().mesh;
  std::vector<bool> held(static_cast<size_t>(mesh.nodes()), false), at_support;
  for (const solve::Support& support : scene.problem().supports)
    for (const int n : support.nodes) held[n] = true;
  for (const mesh::Block& block : mesh.blocks) {
    const int per = block.nodes_per_element;
    for (auto node = block.connectivity.begin(); node != block.connectivity.end(); node += per) {
      const auto count = std::count_if(node, node + per, [&](int n) { return held[n]; });
      at_support.push_back(count > 0 && count < per);
    }
  }
  return at_support;
}

}  // namespace

Recorder::Recorder(const scene::Scene& scene, const std::string& folder) : scene_(scene), folder_(folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw base::InputError("cannot make the folder of the results \"" + folder + "\": " + problem.message());
  const std::string probe = folder + "/.writable";
  if (!std::ofstream(probe)) throw base::InputError("cannot write in the folder of the results \"" + folder + "\"");
  std::filesystem::remove(probe);
  distances_.resize(scene.output().distances.size());
  points_.resize(scene.output().points.size());
}

void Recorder::open_files() {
  for (const char* file :
       {"start.exo", "results.exo", "history.h5", "restart.h5", "pressure-levels.csv", "pressure-curve.csv", "points.csv"})
    std::filesystem::remove(folder_ + "/" + file);
  for (const std::string plot : {"pressure", "force-curves", "torques"})
    for (const char* ending : {".csv", ".dat", ".gp", ".svg", ".png"})
      std::filesystem::remove(folder_ + "/" + plot + ending);
  open_exodus("results.exo");
  history_ = std::make_unique<result::History>(folder_ + "/history.h5", global_names(scene_.problem()));
}

void Recorder::open_exodus(const std::string& file) {
  const bool with_body = scene_.surface() != nullptr;
  if (with_body) body_ = scene_.surface()->triangles(scene_.output().body_size);
  exodus_ =
      std::make_unique<result::ExodusWriter>(folder_ + "/" + file, scene_.garment().mesh, with_body ? &body_ : nullptr,
                                             field_names(scene_.problem(), with_body));
}

void Recorder::write_start() {
  solve::StepReport report;
  report.balance.support.assign(scene_.problem().supports.size(), solve::Vec3::Zero());
  report.balance.torque.assign(scene_.problem().supports.size(), 0.0);
  const solve::State start = scene_.start();
  report.seam = start.seam;
  fields_ = solve::compute_fields(scene_.problem(), start);
  open_exodus("start.exo");
  write_exodus(report);
  exodus_.reset();
}

void Recorder::step(const solve::StepReport& report, const solve::State& state) {
  if (reports_.empty()) open_files();
  fields_ = solve::compute_fields(scene_.problem(), state);
  reports_.push_back(report);
  for (size_t i = 0; i < distances_.size(); ++i) {
    const scene::Distance& d = scene_.output().distances[i];
    distances_[i].push_back((fields_.position[d.second] - fields_.position[d.first]).norm());
  }
  for (size_t i = 0; i < points_.size(); ++i) {
    const int node = scene_.output().points[i].node;
    points_[i].push_back(fields_.position[node] - scene_.garment().mesh.placed[node]);
  }
  write_exodus(report);
  history_->append(global_values(scene_.problem(), report));
  write_restart(report, state);
}

void Recorder::write_exodus(const solve::StepReport& report) {
  result::StepData data;
  const size_t nodes = fields_.position.size();
  for (size_t n = 0; n < nodes; ++n) data.displacement.push_back(fields_.position[n] - scene_.garment().mesh.placed[n]);
  data.nodal["area"] = fields_.area;
  if (scene_.surface() != nullptr) {
    std::vector<double> kpa(nodes);
    std::transform(fields_.pressure.begin(), fields_.pressure.end(), kpa.begin(), base::mpa_to_kpa);
    data.nodal["gap"] = fields_.gap;
    for (size_t d = 0; d < 3; ++d) {
      std::vector<double>& component = data.nodal[std::string("normal_") + "xyz"[d]];
      for (size_t n = 0; n < nodes; ++n) component.push_back(fields_.normal[n][static_cast<Eigen::Index>(d)]);
    }
    data.body_nodal["pressure"] = result::map_to_body(scene_.garment().mesh, fields_.position, kpa, fields_.gap, body_);
    data.nodal["pressure"] = std::move(kpa);
  }
  for (size_t f = 0; f < fields_.element.at(0).size(); ++f)
    data.element[fields_.element[0][f].name] = concatenate(fields_, f);
  const std::vector<double> globals = global_values(scene_.problem(), report);
  const std::vector<result::FieldName> names = global_names(scene_.problem());
  for (size_t g = 0; g < globals.size(); ++g) data.global[names[g].name] = globals[g];
  exodus_->write_step(report.step, data);
}

void Recorder::write_restart(const solve::StepReport& report, const solve::State& state) const {
  result::StateData data;
  std::vector<double>& position = data.reals["position"];
  for (const solve::Vec3& p : state.position) position.insert(position.end(), p.data(), p.data() + 3);
  data.reals["contact_force"] = state.contact_force;
  data.reals["offset"] = state.offset;
  if (!state.frame.empty()) {
    for (const solve::Frame& frame : state.frame)
      data.reals["director_frame"].insert(data.reals["director_frame"].end(), frame.data(), frame.data() + 9);
    for (const auto& rotation : state.rotation)
      data.reals["rotation"].insert(data.reals["rotation"].end(), rotation.begin(), rotation.end());
  }
  data.reals["seam_load_parameter"] = {state.seam, state.load, report.parameter};
  data.integers["step"] = {report.step};
  data.metadata["stage"] = report.stage;
  data.metadata["title"] = scene_.title();
  result::write_state(folder_ + "/restart.h5", data);
}

void Recorder::finish(base::Log& log) {
  if (reports_.empty()) return;
  const scene::Output& output = scene_.output();
  if (scene_.surface() != nullptr && (output.stations > 0 || !output.levels.empty())) write_pressure(log);
  if (!output.force_curves.empty()) write_forces(log);
  if (!output.points.empty()) write_points();
  if (!torque_names(scene_.problem()).empty()) write_torques(log);
}

void Recorder::write_torques(base::Log& log) const {
  const result::Table table = torque_table(scene_.problem(), reports_);
  result::write_csv(folder_ + "/torques.csv", table);
  if (const auto warning = result::write_plot(folder_, "torques", torque_plot(scene_.title(), table)))
    log.warn(*warning);
}

void Recorder::write_points() const {
  result::Table table;
  table.columns = {{{"step", ""}, {}}, {{"load", ""}, {}}};
  for (const solve::StepReport& r : reports_) {
    table.columns[0].values.push_back(r.step);
    table.columns[1].values.push_back(r.load);
  }
  for (size_t i = 0; i < points_.size(); ++i)
    for (Eigen::Index d = 0; d < 3; ++d) {
      std::vector<double> values;
      for (const solve::Vec3& u : points_[i]) values.push_back(u[d]);
      table.columns.push_back({{scene_.output().points[i].title + ": displacement " + "xyz"[d], "mm"}, values});
    }
  result::write_csv(folder_ + "/points.csv", table);
}

void Recorder::write_pressure(base::Log& log) const {
  const scene::Output& output = scene_.output();
  const result::GarmentFields garment{&scene_.garment().mesh,
                                      fields_.position,
                                      fields_.pressure,
                                      element_field(fields_, "tension_course"),
                                      element_field(fields_, "cauchy_minor"),
                                      elements_at_supports(scene_)};
  const result::Axis axis{output.axis_point, output.axis_direction};
  std::vector<result::LevelRow> curve, rows;
  if (output.stations > 0) {
    curve = result::pressure_curve(garment, axis, output.stations);
    result::write_pressure_csv(folder_ + "/pressure-curve.csv", curve);
  }
  if (!output.levels.empty()) {
    std::vector<result::Level> levels;
    for (const scene::Level& level : output.levels) levels.push_back({level.name, level.height});
    rows = result::levels(garment, axis, levels);
    result::write_pressure_csv(folder_ + "/pressure-levels.csv", rows);
  }
  const result::Plot plot = result::pressure_plot(scene_.title(), curve, rows);
  if (const auto warning = result::write_plot(folder_, "pressure", plot)) log.warn(*warning);
}

void Recorder::write_forces(base::Log& log) const {
  const scene::Output& output = scene_.output();
  result::Table table;
  result::Plot plot;
  plot.title = scene_.title();
  plot.x_label = "stretch";
  plot.y_label = "force (N)";
  result::Column step{{"step", ""}, {}}, load{{"load", ""}, {}};
  for (const solve::StepReport& r : reports_) {
    step.values.push_back(r.step);
    load.values.push_back(r.load);
  }
  table.columns = {step, load};
  for (const scene::ForceCurve& curve : output.force_curves) {
    const solve::Support& support = scene_.problem().supports[curve.support];
    const solve::Vec3& move = support.displacement;
    result::Series series;
    series.title = curve.title;
    for (const solve::StepReport& r : reports_) {
      series.x.push_back(1.0 + support.path.share(r.load) * move.norm() / curve.length);
      series.y.push_back(move.norm() > 0.0 ? r.balance.support[curve.support].dot(move) / move.norm() : 0.0);
    }
    table.columns.push_back({{curve.title + ": stretch", ""}, series.x});
    table.columns.push_back({{curve.title + ": force", "N"}, series.y});
    plot.series.push_back(series);
  }
  for (size_t i = 0; i < distances_.size(); ++i)
    table.columns.push_back({{output.distances[i].title, "mm"}, distances_[i]});
  result::write_csv(folder_ + "/force-curves.csv", table);
  if (const auto warning = result::write_plot(folder_, "force-curves", plot)) log.warn(*warning);
}

}  // namespace toile::app
