#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tables.hpp"
#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
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
  std::vector<std::string> names = {exodus_name,  history_name,          restart_name,
                                    start_name,   "pressure-levels.csv", "pressure-curve.csv",
                                    "points.csv", "distances.csv",       "reactions.csv"};
  for (const std::string plot : {"pressure", "force-curves", "torques"})
    for (const char* ending : {".csv", ".dat", ".gp", ".svg", ".png"}) names.push_back(plot + ending);
  return names;
}

std::vector<result::FieldName> names_of(const std::vector<solve::NamedField>& fields) {
  std::vector<result::FieldName> names;
  for (const solve::NamedField& field : fields) names.push_back({field.name, field.unit});
  return names;
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
  if (result::files_available()) written_ = {exodus_name, history_name, restart_name};
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

std::optional<result::BodyMap> Recorder::body_map(const solve::StepReport& report) const {
  const auto presses = [](double force) { return force > 0.0; };
  if (std::none_of(fields_.contact_force.begin(), fields_.contact_force.end(), presses)) return std::nullopt;
  return result::BodyMap(
      {&scene_.garment().mesh, fields_.position, tied_nodes(scene_.problem(), report), fields_.gap, fields_.normal},
      body_);
}

void Recorder::write_fields(const solve::StepReport& report) {
  result::StepData data;
  const mesh::Mesh& mesh = scene_.garment().mesh;
  for (size_t n = 0; n < fields_.position.size(); ++n)
    data.displacement.push_back(fields_.position[n] - mesh.placed[n]);
  const auto on_body = body_map(report);
  for (solve::NamedField& field : solve::nodal_fields(scene_.problem(), fields_)) {
    if (field.on_body && on_body) data.body_nodal[field.name] = on_body->map(field.values);
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

void Recorder::write_histories(base::Log& log) {
  if (reports_.empty()) return;
  const scene::Output& output = scene_.output();
  write("reactions", reaction_table(scene_.problem(), reports_));
  if (!output.points.empty()) write("points", point_table(output, reports_, points_));
  if (!output.distances.empty()) write("distances", distance_table(output, reports_, distances_));
  if (!output.force_curves.empty()) {
    write("force-curves", force_table(scene_, reports_, distances_));
    draw("force-curves", force_plot(scene_, reports_), log);
  }
  if (any_turns(scene_.problem())) {
    const result::Table table = torque_table(scene_.problem(), reports_);
    write("torques", table);
    draw("torques", torque_plot(scene_.title(), table), log);
  }
}

void Recorder::write_pressure(const PressureReport& pressure, base::Log& log) {
  const scene::Output& output = scene_.output();
  if (output.stations > 0) {
    result::write_pressure_csv(folder_ + "/pressure-curve.csv", pressure.curve);
    written_.push_back("pressure-curve.csv");
  }
  if (!output.levels.empty()) {
    result::write_pressure_csv(folder_ + "/pressure-levels.csv", pressure.levels);
    written_.push_back("pressure-levels.csv");
  }
  if (output.stations > 0 || !output.levels.empty())
    draw("pressure", result::pressure_plot(scene_.title(), pressure.curve, pressure.levels), log);
}

void Recorder::write(const std::string& name, const result::Table& table) {
  constexpr int exact = 17;  // digits
  result::write_csv(folder_ + "/" + name + ".csv", table, exact);
  written_.push_back(name + ".csv");
}

void Recorder::draw(const std::string& name, const result::Plot& plot, base::Log& log) {
  const auto warning = result::write_plot(folder_, name, plot);
  if (warning) log.warn(*warning);
  written_.push_back(warning ? name + ".dat" : name + ".png");
}

}  // namespace toile::app
