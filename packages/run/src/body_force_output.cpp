// body-force.csv: force of the body on the garment in the last state, with its error.
#include "output.hpp"
#include "table_output.hpp"

namespace toile::run {

namespace {

class BodyForce : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    if (record.reports().empty()) return;
    const solve::Vec3 force = solve::contact_resultant(record.fields());
    const solve::Vec3 error = solve::contact_resultant_error(record.fields());
    result::Table table{"component", {"x", "y", "z"}, {{{"force", "N"}, {}}, {{"its error", "N"}, {}}}, "", {}};
    table.columns[0].values.assign(force.begin(), force.end());
    table.columns[1].values.assign(error.begin(), error.end());
    TableOutput::write("body-force", table);
  }
};

}  // namespace

Output body_force_output() {
  return {{"body-force.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || context.scene.surface() == nullptr) return nullptr;
            return std::make_unique<BodyForce>(context);
          }};
}

}  // namespace toile::run
