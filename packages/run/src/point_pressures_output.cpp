// pressure-points.csv: the pressure at the points that the scene names, in the last state.
#include <array>
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
    for (const scene::Point& point : record.scene().output().points) {
      const auto n = static_cast<size_t>(point.node);
      const solve::Vec3& x = fields.position[n];
      const std::array<double, 6> row = {
          x[0],         x[1], x[2], base::mpa_to_kpa(fields.pressure[n]), base::mpa_to_kpa(fields.pressure_error[n]),
          fields.gap[n]};
      table.row_names.push_back(point.title);
      for (size_t c = 0; c < row.size(); ++c) table.columns[c].values.push_back(row[c]);
    }
    const std::vector<scene::BodyPoint>& points = record.scene().output().body_points;
    const std::vector<BodyPressure> pressures = body_pressures(record.scene(), fields, record.last());
    for (size_t p = 0; p < points.size(); ++p) {
      const solve::Vec3& x = points[p].place;
      const std::array<double, 6> row = {x[0],
                                         x[1],
                                         x[2],
                                         base::mpa_to_kpa(pressures[p].pressure),
                                         base::mpa_to_kpa(pressures[p].error),
                                         pressures[p].gap.value_or(std::numeric_limits<double>::quiet_NaN())};
      table.row_names.push_back(points[p].title);
      for (size_t c = 0; c < row.size(); ++c) table.columns[c].values.push_back(row[c]);
    }
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
