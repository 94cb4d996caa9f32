// points.csv: displacements of the points that the scene names.
#include "step_table.hpp"
#include "table_output.hpp"

namespace toile::run {

namespace {

class Points : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    result::Table table = step_table(record.reports());
    for (size_t i = 0; i < record.points().size(); ++i)
      for (Eigen::Index d = 0; d < 3; ++d) {
        std::vector<double> values;
        for (const solve::Vec3& u : record.points()[i]) values.push_back(u[d]);
        const std::string& title = record.scene().output().points[i].title;
        table.columns.push_back({{title + ": displacement " + "xyz"[d], "mm"}, values});
      }
    TableOutput::write("points", table);
  }
};

}  // namespace

Output points_output() {
  return {{"points.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || context.scene.output().points.empty()) return nullptr;
            return std::make_unique<Points>(context);
          }};
}

}  // namespace toile::run
