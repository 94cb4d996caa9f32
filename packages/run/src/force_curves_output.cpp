// force-curves.*: stretch and force of each force curve, and the distances beside them.
#include "step_table.hpp"
#include "table_output.hpp"

namespace toile::run {

namespace {

const std::string force_curves_name = "force-curves";

result::Series force_series(const scene::ForceCurve& curve, const Record& record) {
  const solve::Support& support = record.scene().problem().supports[curve.support];
  const solve::Vec3 move = support.motion(0);
  result::Series series;
  series.title = curve.title;
  for (const solve::StepReport& r : record.reports()) {
    series.x.push_back(1.0 + support.path.share(r.load) * move.norm() / curve.length);
    series.y.push_back(move.norm() > 0.0 ? r.balance.support[curve.support].dot(move) / move.norm() : 0.0);
  }
  return series;
}

class ForceCurves : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    result::Table table = step_table(record.reports());
    result::Plot plot;
    plot.title = record.scene().title();
    plot.x_label = "stretch";
    plot.y_label = "force (N)";
    for (const scene::ForceCurve& curve : record.scene().output().force_curves) {
      plot.series.push_back(force_series(curve, record));
      table.columns.push_back({{curve.title + ": stretch", ""}, plot.series.back().x});
      table.columns.push_back({{curve.title + ": force", "N"}, plot.series.back().y});
    }
    add_distances(table, record);
    TableOutput::write(force_curves_name, table);
    draw(force_curves_name, plot);
  }
};

}  // namespace

Output force_curves_output() {
  return {plot_files(force_curves_name), [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || context.scene.output().force_curves.empty()) return nullptr;
            return std::make_unique<ForceCurves>(context);
          }};
}

}  // namespace toile::run
