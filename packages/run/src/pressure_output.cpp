// pressure-curve.csv, pressure-levels.csv and pressure.*: the last state of a run that reached its end.
#include "table_output.hpp"
#include "toile/result/pressure_lines.hpp"

namespace toile::run {

namespace {

const std::string curve_name = "pressure-curve.csv", levels_name = "pressure-levels.csv", plot_name = "pressure";

class Pressure : public Observer {
 public:
  explicit Pressure(const OutputContext& context) : folder_(context.folder), timer_(context.timer), log_(context.log) {}

  void end(const Record& record) override {
    const PressureReport& pressure = record.pressure();
    const auto phase = timer_.phase("curves");
    const scene::Output& output = record.scene().output();
    if (output.stations > 0) write(curve_name, pressure.curve);
    if (!output.levels.empty()) write(levels_name, pressure.levels);
    draw(*folder_, plot_name, result::pressure_plot(record.scene().title(), pressure.curve, pressure.levels), log_);
  }

 private:
  void write(const std::string& name, const std::vector<result::LevelRow>& rows) {
    result::write_pressure_csv(folder_->file(name), rows, error_names());
    folder_->add(name);
  }

  std::shared_ptr<Folder> folder_;
  base::Timer& timer_;
  base::Log& log_;
};

}  // namespace

Output pressure_output() {
  std::vector<std::string> files = plot_files(plot_name);
  files.insert(files.end(), {curve_name, levels_name});
  return {files, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            const scene::Output& output = context.scene.output();
            if (context.folder == nullptr || (output.stations == 0 && output.levels.empty())) return nullptr;
            return std::make_unique<Pressure>(context);
          }};
}

}  // namespace toile::run
