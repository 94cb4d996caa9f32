// distances.csv: distances between the points that the scene names.
#include "step_table.hpp"
#include "table_output.hpp"

namespace toile::run {

namespace {

class Distances : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    result::Table table = step_table(record.reports());
    add_distances(table, record);
    TableOutput::write("distances", table);
  }
};

}  // namespace

Output distances_output() {
  return {{"distances.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || context.scene.output().distances.empty()) return nullptr;
            return std::make_unique<Distances>(context);
          }};
}

}  // namespace toile::run
