#include "step_table.hpp"

namespace toile::run {

result::Table step_table(const std::vector<solve::StepReport>& reports) {
  result::Table table;
  table.columns = {{{"step", ""}, {}}, {{"load", ""}, {}}};
  for (const solve::StepReport& r : reports) {
    table.columns[0].values.push_back(r.step);
    table.columns[1].values.push_back(r.load);
  }
  return table;
}

void add_distances(result::Table& table, const Record& record) {
  for (size_t i = 0; i < record.distances().size(); ++i)
    table.columns.push_back({{record.scene().output().distances[i].title, "mm"}, record.distances()[i]});
}

}  // namespace toile::run
