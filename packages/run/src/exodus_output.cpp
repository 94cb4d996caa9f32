// results.exo: garment and body at every accepted step. A run that accepted none leaves its start, start.exo.
#include "exodus_output.hpp"

#include <algorithm>
#include <optional>

#include "output.hpp"
#include "toile/base/error.hpp"
#include "toile/result/available.hpp"
#include "toile/result/body_map.hpp"
#include "toile/result/exodus_writer.hpp"
#include "toile/result/field_name.hpp"
#include "toile/result/shown_body.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::run {

namespace {

const std::string exodus_name = "results.exo", start_name = "start.exo";

std::vector<result::FieldName> names_of(const std::vector<solve::NamedField>& fields) {
  std::vector<result::FieldName> names;
  for (const solve::NamedField& field : fields) names.push_back({field.name, field.unit});
  return names;
}

/// One file, opened for the fields of the record's state.
class Steps {
 public:
  Steps(const Record& record, const solve::StepReport& report, const std::string& path) {
    const scene::Scene& scene = record.scene();
    const bool with_body = scene.surface() != nullptr;
    if (with_body) {
      const std::optional<double>& size = scene.output().body_size;
      body_ = result::shown_body(*scene.surface(), scene.surface()->triangles(size.value_or(scene::formula_body_size)),
                                 scene.garment().mesh, size);
    }
    result::FieldNames names;
    names.nodal = names_of(solve::nodal_fields(scene.problem(), record.fields()));
    if (!body_.error.empty()) names.nodal.push_back(result::body_error_field());
    names.element = names_of(solve::element_fields(record.fields()));
    names.global = names_of(solve::global_fields(scene.problem(), report));
    writer_ =
        std::make_unique<result::ExodusWriter>(path, scene.garment().mesh, with_body ? &body_.mesh : nullptr, names);
  }

  /// After so many steps of the file that is there.
  void go_on(int steps) { writer_->go_on(steps); }

  void write(const Record& record, const solve::StepReport& report) {
    const solve::Fields& fields = record.fields();
    const solve::Problem& problem = record.scene().problem();
    result::StepData data;
    for (size_t n = 0; n < fields.position.size(); ++n)
      data.displacement.push_back(fields.position[n] - problem.mesh->placed[n]);
    const auto on_body = body_map(problem, fields, report);
    for (solve::NamedField& field : solve::nodal_fields(problem, fields)) {
      if (field.on_body && on_body) data.body_nodal[field.name] = on_body->on(field.values);
      data.nodal[field.name] = std::move(field.values);
    }
    if (!body_.error.empty()) data.body_nodal[result::body_error_field().name] = body_.error;
    for (solve::NamedField& field : solve::element_fields(fields)) data.element[field.name] = std::move(field.values);
    for (const solve::NamedField& field : solve::global_fields(problem, report))
      data.global[field.name] = field.values.front();
    writer_->write_step(report.step, data);
  }

 private:
  /// Nothing before the garment touches the body.
  std::optional<result::BodyMap> body_map(const solve::Problem& problem, const solve::Fields& fields,
                                          const solve::StepReport& report) const {
    const auto presses = [](double force) { return force > 0.0; };
    if (std::none_of(fields.contact_force.begin(), fields.contact_force.end(), presses)) return std::nullopt;
    return result::BodyMap(on_body(problem, fields, report.seam), body_.mesh);
  }

  result::ShownBody body_;
  std::unique_ptr<result::ExodusWriter> writer_;
};

class Exodus : public Observer {
 public:
  explicit Exodus(std::shared_ptr<Folder> folder) : folder_(std::move(folder)) {}

  void start(const Record& record) override {
    if (record.reports().empty()) return;
    steps_ = std::make_unique<Steps>(record, record.last(), folder_->file(exodus_name));
    steps_->go_on(static_cast<int>(record.reports().size()));
    folder_->add(exodus_name);
  }

  void step(const Record& record) override {
    if (steps_ == nullptr) steps_ = std::make_unique<Steps>(record, record.last(), folder_->file(exodus_name));
    steps_->write(record, record.last());
    folder_->add(exodus_name);
  }

  std::string failure(const Record& record) override {
    if (!record.reports().empty()) return " is the last one in " + folder_->file(exodus_name);
    try {
      write_start(record, *folder_);
    } catch (const base::Error& error) {
      return std::string(", and the start is not written either: ") + error.what();
    }
    return "; the start is in " + folder_->file(start_name);
  }

 private:
  std::shared_ptr<Folder> folder_;
  std::unique_ptr<Steps> steps_;
};

}  // namespace

void write_start(const Record& record, const Folder& folder) {
  const solve::Problem& problem = record.scene().problem();
  solve::StepReport report;
  report.seam = record.state().seam;
  report.balance.support.assign(problem.supports.size(), solve::Vec3::Zero());
  report.balance.torque.assign(problem.supports.size(), 0.0);
  Steps(record, report, folder.file(start_name)).write(record, report);
}

Output exodus_output() {
  return {{exodus_name, start_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || !result::files_available()) return nullptr;
            return std::make_unique<Exodus>(context.folder);
          }};
}

}  // namespace toile::run
