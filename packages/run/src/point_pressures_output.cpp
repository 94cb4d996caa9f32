// pressure-points.csv: the pressure at the points that the scene names, in the last state.
#include <array>

#include "table_output.hpp"
#include "toile/base/units.hpp"

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
    TableOutput::write("pressure-points", table);
  }
};

}  // namespace

Output point_pressures_output() {
  return {
      {"pressure-points.csv"}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
        if (context.folder == nullptr || context.scene.surface() == nullptr || context.scene.output().points.empty())
          return nullptr;
        return std::make_unique<PointPressures>(context);
      }};
}

}  // namespace toile::run
