// reactions.csv: forces on the garment by component: of the body, of each support, of loads.
#include <functional>

#include "step_table.hpp"
#include "table_output.hpp"

namespace toile::run {

namespace {

using Vector = std::function<solve::Vec3(const solve::StepReport&)>;

void add_force(result::Table& table, const std::string& name, const std::vector<solve::StepReport>& reports,
               const Vector& force) {
  for (Eigen::Index d = 0; d < 3; ++d) {
    result::Column column{{name + ": " + "xyz"[d], "N"}, {}};
    for (const solve::StepReport& r : reports) column.values.push_back(force(r)[d]);
    table.columns.push_back(std::move(column));
  }
}

class Reactions : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    const solve::Problem& problem = record.scene().problem();
    const std::vector<solve::StepReport>& reports = record.reports();
    result::Table table = step_table(reports);
    if (problem.surface != nullptr)
      add_force(table, "body", reports, [](const solve::StepReport& r) { return r.balance.contact; });
    for (size_t s = 0; s < problem.supports.size(); ++s)
      add_force(table, "support " + problem.supports[s].name, reports,
                [s](const solve::StepReport& r) { return r.balance.support[s]; });
    if (!problem.loads.empty() || !problem.pressures.empty())
      add_force(table, "loads", reports, [](const solve::StepReport& r) { return r.balance.load; });
    TableOutput::write("reactions", table);
  }
};

}  // namespace

Output reactions_output() {
  return {{"reactions.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr) return nullptr;
            return std::make_unique<Reactions>(context);
          }};
}

}  // namespace toile::run
