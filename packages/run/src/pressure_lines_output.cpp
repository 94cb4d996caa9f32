// pressure-lines.csv and its picture: the pressure along lines on the body, in the last state.
#include <limits>

#include "table_output.hpp"
#include "toile/base/units.hpp"
#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

const std::string lines_name = "pressure-lines";

/// kPa against mm, with the error as a band.
result::Series curve(const scene::PressureLine& line, const std::vector<PointPressure>& pressures) {
  result::Series series;
  series.title = line.title;
  series.x = line.lengths;
  for (const PointPressure& at : pressures) {
    series.y.push_back(base::mpa_to_kpa(at.pressure));
    series.errors.push_back(base::mpa_to_kpa(at.error));
  }
  return series;
}

class PressureLines : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    result::Table table{"line",
                        {},
                        {{{"arc length", "mm"}, {}},
                         {{"x", "mm"}, {}},
                         {{"y", "mm"}, {}},
                         {{"z", "mm"}, {}},
                         {{"pressure", "kPa"}, {}},
                         {{"pressure", "mmHg"}, {}},
                         {{"its error", "kPa"}, {}},
                         {{"its error", "mmHg"}, {}},
                         {{"gap", "mm"}, {}}}};
    result::Plot plot;
    plot.title = record.scene().title();
    plot.x_label = "arc length along the line (mm)";
    plot.y_label = "pressure (kPa), band: its error";
    plot.second_axis = result::SecondAxis{"pressure (mmHg)", base::mmhg_per_kpa};
    plot.y_from_zero = true;
    plot.legend_above = true;
    for (const scene::PressureLine& line : record.scene().output().lines) {
      const auto pressures = body_pressures(record.scene(), line.places, record.fields(), record.last());
      for (size_t s = 0; s < pressures.size(); ++s) {
        const PointPressure& at = pressures[s];
        const solve::Vec3& x = line.places[s].place;
        table.row_names.push_back(line.title);
        const double row[] = {line.lengths[s],
                              x[0],
                              x[1],
                              x[2],
                              base::mpa_to_kpa(at.pressure),
                              base::mpa_to_mmhg(at.pressure),
                              base::mpa_to_kpa(at.error),
                              base::mpa_to_mmhg(at.error),
                              at.gap.value_or(std::numeric_limits<double>::quiet_NaN())};
        for (size_t c = 0; c < table.columns.size(); ++c) table.columns[c].values.push_back(row[c]);
      }
      plot.series.push_back(curve(line, pressures));
    }
    TableOutput::write(lines_name, table);
    draw(lines_name, plot);
  }
};

}  // namespace

Output pressure_lines_output() {
  return {plot_files(lines_name), [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || context.scene.output().lines.empty()) return nullptr;
            return std::make_unique<PressureLines>(context);
          }};
}

}  // namespace toile::run
