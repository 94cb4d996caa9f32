// run.json: what is told of a run beside its numbers, for who reads its results later.
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "check_outcomes.hpp"
#include "output.hpp"
#include "toile/criteria/paths.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::run {

namespace {

using Json = nlohmann::ordered_json;

const std::string record_name = "run.json";
/// Written on demand, of this record and what lies beside it: the page of an older run goes with that run's files.
const std::string page_name = "report.html";

/// How a run stands.
enum class End { not_yet, reached, failed };

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// Nominal tension over the stretch of a strip that may contract, as far as the fabric has a state.
Json pulled(const criteria::Fabric& fabric, const criteria::Path& path, double thickness) {
  constexpr double most = 2.5, step = 0.025;
  Json stretches = Json::array(), tensions = Json::array();
  criteria::Strain guess = {1.0, 1.0, 0.0};
  for (int i = 0; 1.0 + i * step <= most; ++i) {
    const double stretch = 1.0 + i * step;
    const auto state = criteria::state_on(fabric, path, stretch, guess);
    if (!state) break;
    guess = state->C;
    stretches.push_back(stretch);
    tensions.push_back(thickness * stretch * state->S[path.wale ? 0 : 1]);
  }
  return {{"title", path.name}, {"stretch", stretches}, {"tension", tensions}};
}

/// Of each fabric; a graduated one at the middle of its panel.
Json fabrics_of(const solve::Problem& problem) {
  Json fabrics = Json::array();
  std::set<std::string> told;
  for (const solve::BlockModel& model : problem.models) {
    const material::Material& material = *model.material;
    if (!told.insert(material.name()).second) continue;
    const criteria::Fabric fabric{material.name(), &material.law(), material.params_at(0.5)};
    Json curves = Json::array();
    for (const criteria::Path& path : criteria::paths())
      if (path.free) curves.push_back(pulled(fabric, path, material.thickness()));
    fabrics.push_back({{"name", material.name()},
                       {"thickness", material.thickness()},
                       {"graduated", material.graduated()},
                       {"compression", material.response().compression()},
                       {"curves", curves}});
  }
  return fabrics;
}

Json panels_of(const scene::Scene& scene) {
  Json panels = Json::array();
  const mesh::Mesh& mesh = scene.garment().mesh;
  for (size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    panels.push_back({{"name", block.name},
                      {"elements", block.size()},
                      {"nodes per element", block.nodes_per_element},
                      {"fabric", block.material},
                      {"shell", scene.problem().models[b].is_shell()}});
  }
  return panels;
}

Json checks_of(const Record& record) {
  Json checks = Json::array();
  for (const CheckOutcome& outcome : check_outcomes(record))
    checks.push_back({{"name", outcome.name},
                      {"quantity", outcome.quantity},
                      {"value", number(outcome.value)},
                      {"unit", outcome.unit},
                      {"allowed", outcome.allowed},
                      {"holds", outcome.holds},
                      {"message", outcome.message}});
  return checks;
}

class RunRecord : public Observer {
 public:
  explicit RunRecord(const OutputContext& context) : folder_(context.folder), log_(context.log) {}

  void start(const Record& record) override {
    if (!record.reports().empty()) write(record, End::not_yet);
  }
  void step(const Record& record) override {
    if (record.reports().size() == 1) write(record, End::not_yet);
  }
  void end(const Record& record) override { write(record, End::reached); }
  std::string failure(const Record& record) override {
    if (!record.reports().empty()) write(record, End::failed);
    return {};
  }

 private:
  void write(const Record& record, End end) {
    const scene::Scene& scene = record.scene();
    const char* const words[] = {"not yet", "reached", "failed"};
    Json all = {{"format", "toile run 1"},
                {"title", scene.title()},
                {"end", words[static_cast<int>(end)]},
                {"failure", record.failure()},
                {"steps", record.reports().size()},
                {"warnings", log_.warnings()},
                {"notes", record.notes()},
                {"checks", end == End::not_yet ? Json::array() : checks_of(record)},
                {"nodes", scene.garment().mesh.nodes()},
                {"unknowns", record.statistics().unknowns},
                {"body", scene.surface() != nullptr ? scene.surface()->summary() : std::string()},
                {"used", scene.used()},
                {"left out", scene.left_out()},
                {"panels", panels_of(scene)},
                {"fabrics", fabrics_of(scene.problem())},
                {"scene", record.fingerprint().values}};
    result::replace_file(folder_->file(record_name),
                         all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
                         "cannot write the record of the run '" + folder_->file(record_name) + "': ");
    folder_->add(record_name);
  }

  std::shared_ptr<Folder> folder_;
  base::Log& log_;
};

}  // namespace

Output run_record_output() {
  return {{record_name, page_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr) return nullptr;
            return std::make_unique<RunRecord>(context);
          }};
}

}  // namespace toile::run
