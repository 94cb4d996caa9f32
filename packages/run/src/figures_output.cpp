// figures.csv: what a run came to and what it cost, one figure a row, for programs that compare runs.
#include "figures.hpp"
#include "table_output.hpp"
#include "toile/base/memory.hpp"

namespace toile::run {

namespace {

class FiguresOutput : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    if (record.reports().empty()) return;
    const Figures f = figures_of(record.fields(), record.last());
    const solve::StepReport& last = record.last();
    const solve::SolveStatistics& work = record.statistics();
    const mesh::Mesh& mesh = record.scene().garment().mesh;
    result::Table table{"figure", {}, {{{"value", ""}, {}}}, "unit", {}};
    const auto add = [&table](const std::string& name, double value, const std::string& unit = "") {
      table.row_names.push_back(name);
      table.columns[0].values.push_back(value);
      table.texts.push_back(unit);
    };
    add("nodes", static_cast<double>(mesh.nodes()));
    add("elements", static_cast<double>(mesh.elements()));
    add("unknowns", work.unknowns);
    add("contact multipliers", work.contact_nodes);
    if (record.scene().surface() != nullptr) {
      add("largest pressure", f.largest_pressure, "kPa");
      add("smallest pressure", f.smallest_pressure, "kPa");
      add("largest gap", f.largest_gap, "mm");
    }
    add("smallest principal stress", f.smallest_stress, "kPa");
    add("force balance", f.force_balance);
    add("strain energy", last.energy.strain, "N mm");
    add("dissipation ratio", f.dissipation_ratio);
    add("extrapolated elements", f.extrapolated);
    add("relative residual", last.accuracy.residual);
    add("negative pivots", last.negative_pivots);
    if (last.condition > 0.0) add("condition number", last.condition);
    add("steps", work.steps);
    add("cut-backs", work.cut_backs);
    add("Newton iterations", work.newton_iterations);
    add("linear iterations", work.linear_iterations);
    add("factorisations", work.factorisations);
    add("wall time", last.seconds, "s");
    for (const std::string name : {"fields", "restart"}) add("time of " + name, seconds_of(name), "s");
    add("peak memory", base::peak_memory(), "MB");
    TableOutput::write("figures", table);
  }

 private:
  /// Of all phases of this name, wherever they are.
  double seconds_of(const std::string& name) const {
    double seconds = 0.0;
    for (const base::Timer::Phase& phase : timer().phases())
      if (phase.name == name) seconds += phase.seconds;
    return seconds;
  }
};

}  // namespace

Output figures_output() {
  return {{"figures.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr) return nullptr;
            return std::make_unique<FiguresOutput>(context);
          }};
}

}  // namespace toile::run
