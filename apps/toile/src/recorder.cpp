#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "toile/base/error.hpp"
#include "toile/result/body_map.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"
#include "toile/result/pressure_lines.hpp"
#include "toile/result/replace_file.hpp"
#include "toile/result/state_file.hpp"
#include "toile/solve/output_fields.hpp"
#include "torques.hpp"

namespace toile::app {

namespace {

const std::string exodus_name = "results.exo", history_name = "history.h5", restart_name = "restart.h5",
                  start_name = "start.exo";

/// Every file that a run may write into its folder.
std::vector<std::string> result_files() {
  std::vector<std::string> names = {exodus_name,           history_name,         restart_name, start_name,
                                    "pressure-levels.csv", "pressure-curve.csv", "points.csv"};
  for (const std::string plot : {"pressure", "force-curves", "torques"})
    for (const char* ending : {".csv", ".dat", ".gp", ".svg", ".png"}) names.push_back(plot + ending);
  return names;
}

std::vector<result::FieldName> names_of(const std::vector<solve::NamedField>& fields) {
  std::vector<result::FieldName> names;
  for (const solve::NamedField& field : fields) names.push_back({field.name, field.unit});
  return names;
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
  const std::string failure = "cannot write in the folder of the results \"" + folder + "\": ";
  { const result::Replacement probe(folder + "/.writable", failure); }
  for (const std::string& name : result_files()) result::check_replaceable(folder + "/" + name, failure + name + ": ");
  distances_.resize(scene.output().distances.size());
  points_.resize(scene.output().points.size());
}

void Recorder::open_files(const solve::StepReport& report) {
  const std::vector<result::FieldName> globals = open_exodus(exodus_name, report);
  history_ = std::make_unique<result::History>(folder_ + "/" + history_name, globals);
}

std::vector<result::FieldName> Recorder::open_exodus(const std::string& file, const solve::StepReport& report) {
  const bool with_body = scene_.surface() != nullptr;
  if (with_body) body_ = scene_.surface()->triangles(scene_.output().body_size);
  result::FieldNames names;
  names.nodal = names_of(solve::nodal_fields(scene_.problem(), fields_));
  names.element = names_of(solve::element_fields(fields_));
  names.global = names_of(solve::global_fields(scene_.problem(), report));
  exodus_ = std::make_unique<result::ExodusWriter>(folder_ + "/" + file, scene_.garment().mesh,
                                                   with_body ? &body_ : nullptr, names);
  return names.global;
}

void Recorder::write_start() {
  const solve::State start = scene_.start();
  fields_ = solve::compute_fields(scene_.problem(), start);
  solve::StepReport report;
  report.seam = start.seam;
  report.balance.support.assign(scene_.problem().supports.size(), solve::Vec3::Zero());
  report.balance.torque.assign(scene_.problem().supports.size(), 0.0);
  open_exodus(start_name, report);
  write_fields(report);
  exodus_.reset();
}

/// The files of the first step took the places of older ones; the others of the older run do not belong to them.
void Recorder::remove_older() const {
  for (const std::string& name : result_files())
    if (name != exodus_name && name != history_name && name != restart_name)
      result::remove_file(folder_ + "/" + name, "cannot remove the older result \"" + folder_ + "/" + name + "\": ");
}

void Recorder::step(const solve::StepReport& report, const solve::State& state) {
  fields_ = solve::compute_fields(scene_.problem(), state);
  if (reports_.empty()) open_files(report);
  reports_.push_back(report);
  for (size_t i = 0; i < distances_.size(); ++i) {
    const scene::Distance& d = scene_.output().distances[i];
    distances_[i].push_back((fields_.position[d.second] - fields_.position[d.first]).norm());
  }
  for (size_t i = 0; i < points_.size(); ++i) {
    const int node = scene_.output().points[i].node;
    points_[i].push_back(fields_.position[node] - scene_.garment().mesh.placed[node]);
  }
  write_fields(report);
  write_restart(report, state);
  if (reports_.size() == 1) remove_older();
}

void Recorder::write_fields(const solve::StepReport& report) {
  result::StepData data;
  const mesh::Mesh& mesh = scene_.garment().mesh;
  for (size_t n = 0; n < fields_.position.size(); ++n)
    data.displacement.push_back(fields_.position[n] - mesh.placed[n]);
  for (solve::NamedField& field : solve::nodal_fields(scene_.problem(), fields_)) {
    if (field.on_body)
      data.body_nodal[field.name] = result::map_to_body(mesh, fields_.position, field.values, fields_.gap, body_);
    data.nodal[field.name] = std::move(field.values);
  }
  for (solve::NamedField& field : solve::element_fields(fields_)) data.element[field.name] = std::move(field.values);
  std::vector<double> history;
  for (const solve::NamedField& field : solve::global_fields(scene_.problem(), report)) {
    data.global[field.name] = field.values.front();
    history.push_back(field.values.front());
  }
  exodus_->write_step(report.step, data);
  if (history_ != nullptr) history_->append(history);
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
  result::write_state(folder_ + "/" + restart_name, data);
}

void Recorder::finish(base::Log& log) {
  if (reports_.empty()) return;
  const scene::Output& output = scene_.output();
  if (scene_.surface() != nullptr && (output.stations > 0 || !output.levels.empty())) write_pressure(log);
  if (!output.force_curves.empty()) write_forces(log);
  if (!output.points.empty()) write_points();
  if (any_turns(scene_.problem())) write_torques(log);
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
  const std::vector<solve::NamedField> elements = solve::element_fields(fields_);
  const result::GarmentFields garment{&scene_.garment().mesh,
                                      fields_.position,
                                      fields_.pressure,
                                      solve::named(elements, "tension_course").values,
                                      solve::named(elements, "cauchy_minor").values,
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
