// pressure-points.csv: the pressure at the points that the scene names, in the last state.
#include <limits>

#include "table_output.hpp"
#include "toile/base/units.hpp"
#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

class PointPressures : public TableOutput {
  using TableOutput::TableOutput;

  void write(const Record& record) override {
    const solve::Fields& fields = record.fields();
    result::Table table{"point",
                        {},
                        {{{"x", "mm"}, {}},
                         {{"y", "mm"}, {}},
                         {{"z", "mm"}, {}},
                         {{"pressure", "kPa"}, {}},
                         {{"its error", "kPa"}, {}},
                         {{"gap", "mm"}, {}}}};
    for (const std::string& name : error_names()) table.columns.push_back({{"its part by " + name, "kPa"}, {}});
    const auto add = [&](const std::string& title, const solve::Vec3& x, const PointPressure& at) {
      table.row_names.push_back(title);
      std::vector<double> row = {x[0],
                                 x[1],
                                 x[2],
                                 base::mpa_to_kpa(at.pressure),
                                 base::mpa_to_kpa(at.error),
                                 at.gap.value_or(std::numeric_limits<double>::quiet_NaN())};
      for (const double part : at.error_parts) row.push_back(base::mpa_to_kpa(part));
      for (size_t c = 0; c < row.size(); ++c) table.columns[c].values.push_back(row[c]);
    };
    const scene::Output& output = record.scene().output();
    const auto at = point_pressures(record.scene(), output.points, fields);
    for (size_t p = 0; p < at.size(); ++p) add(output.points[p].title, fields.position[output.points[p].node], at[p]);
    const auto on_body = body_pressures(record.scene(), output.body_points, fields, record.last());
    for (size_t p = 0; p < on_body.size(); ++p)
      add(output.body_points[p].title, output.body_points[p].place, on_body[p]);
    TableOutput::write("pressure-points", table);
  }
};

}  // namespace

Output point_pressures_output() {
  return {{"pressure-points.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            const scene::Output& output = context.scene.output();
            if (context.folder == nullptr || context.scene.surface() == nullptr) return nullptr;
            if (output.points.empty() && output.body_points.empty()) return nullptr;
            return std::make_unique<PointPressures>(context);
          }};
}

}  // namespace toile::run
