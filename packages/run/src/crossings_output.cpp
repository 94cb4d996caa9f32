// Warns of fabric that passes through fabric at the end of each stage; crossings.csv: where it does in the last state.
#include "table_output.hpp"
#include "toile/crossing/crossings.hpp"

namespace toile::run {

namespace {

const std::string table_name = "crossings";

class CrossingWarnings : public Observer {
 public:
  explicit CrossingWarnings(base::Log& log) : log_(log) {}

  void end_stage(const Record& record, const solve::StageOptions& stage) override {
    tell(record, "at the end of stage \"" + stage.name + "\"");
  }
  std::string failure(const Record& record) override {
    if (!record.reports().empty()) tell(record, "in the last converged state");
    return {};
  }

 private:
  void tell(const Record& record, const std::string& when) {
    const crossing::Crossings& found = record.fields().crossings;
    if (found.panels.empty()) return;
    log_.warn(when + " fabric passes through fabric: " + text_of(found, *record.scene().problem().mesh) +
              ". Fabric is in contact with the body only, so what is told of these places is not what a garment does "
              "(field \"crossing\" shows them). Place the panels apart, or give the garment more room there");
  }

  base::Log& log_;
};

class CrossingTable : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    const std::vector<crossing::PanelCrossing>& found = record.fields().crossings.panels;
    const mesh::Mesh& mesh = *record.scene().problem().mesh;
    result::Table table{"panel", {}, {}, "other panel", {}};
    for (const crossing::PanelCrossing& c : found) {
      table.row_names.push_back(mesh.panels[static_cast<size_t>(c.first)].name);
      table.texts.push_back(mesh.panels[static_cast<size_t>(c.second)].name);
    }
    const auto column = [&](const char* name, const char* unit, const auto& value) {
      std::vector<double> values;
      for (const crossing::PanelCrossing& c : found) values.push_back(value(c));
      table.columns.push_back({{name, unit}, values});
    };
    column("pairs of elements", "", [](const auto& c) { return static_cast<double>(c.pairs); });
    column("length", "mm", [](const auto& c) { return c.length; });
    column("depth", "mm", [](const auto& c) { return c.depth; });
    for (Eigen::Index d = 0; d < 3; ++d)
      column(std::string(1, "xyz"[d]).c_str(), "mm", [d](const auto& c) { return c.place[d]; });
    TableOutput::write(table_name, table);
  }
};

}  // namespace

Output crossing_warnings_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (!context.scene.problem().crossings) return nullptr;
            return std::make_unique<CrossingWarnings>(context.log);
          }};
}

Output crossings_output() {
  return {{table_name + ".csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || !context.scene.problem().crossings) return nullptr;
            return std::make_unique<CrossingTable>(context);
          }};
}

}  // namespace toile::run
