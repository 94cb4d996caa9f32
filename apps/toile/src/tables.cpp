#include "tables.hpp"

#include <functional>

namespace toile::app {

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

void add_distances(result::Table& table, const scene::Output& output,
                   const std::vector<std::vector<double>>& distances) {
  for (size_t i = 0; i < distances.size(); ++i)
    table.columns.push_back({{output.distances[i].title, "mm"}, distances[i]});
}

result::Series force_series(const scene::ForceCurve& curve, const solve::Problem& problem,
                            const std::vector<solve::StepReport>& reports) {
  const solve::Support& support = problem.supports[curve.support];
  const solve::Vec3 move = support.motion(0);
  result::Series series;
  series.title = curve.title;
  for (const solve::StepReport& r : reports) {
    series.x.push_back(1.0 + support.path.share(r.load) * move.norm() / curve.length);
    series.y.push_back(move.norm() > 0.0 ? r.balance.support[curve.support].dot(move) / move.norm() : 0.0);
  }
  return series;
}

}  // namespace

result::Table step_table(const std::vector<solve::StepReport>& reports) {
  result::Table table;
  table.columns = {{{"step", ""}, {}}, {{"load", ""}, {}}};
  for (const solve::StepReport& r : reports) {
    table.columns[0].values.push_back(r.step);
    table.columns[1].values.push_back(r.load);
  }
  return table;
}

result::Table reaction_table(const solve::Problem& problem, const std::vector<solve::StepReport>& reports) {
  result::Table table = step_table(reports);
  if (problem.surface != nullptr)
    add_force(table, "body", reports, [](const solve::StepReport& r) { return r.balance.contact; });
  for (size_t s = 0; s < problem.supports.size(); ++s)
    add_force(table, "support " + problem.supports[s].name, reports,
              [s](const solve::StepReport& r) { return r.balance.support[s]; });
  if (!problem.loads.empty() || !problem.pressures.empty())
    add_force(table, "loads", reports, [](const solve::StepReport& r) { return r.balance.load; });
  return table;
}

result::Table point_table(const scene::Output& output, const std::vector<solve::StepReport>& reports,
                          const std::vector<std::vector<solve::Vec3>>& displacement) {
  result::Table table = step_table(reports);
  for (size_t i = 0; i < displacement.size(); ++i)
    for (Eigen::Index d = 0; d < 3; ++d) {
      std::vector<double> values;
      for (const solve::Vec3& u : displacement[i]) values.push_back(u[d]);
      table.columns.push_back({{output.points[i].title + ": displacement " + "xyz"[d], "mm"}, values});
    }
  return table;
}

result::Table distance_table(const scene::Output& output, const std::vector<solve::StepReport>& reports,
                             const std::vector<std::vector<double>>& distances) {
  result::Table table = step_table(reports);
  add_distances(table, output, distances);
  return table;
}

result::Table force_table(const scene::Scene& scene, const std::vector<solve::StepReport>& reports,
                          const std::vector<std::vector<double>>& distances) {
  result::Table table = step_table(reports);
  for (const scene::ForceCurve& curve : scene.output().force_curves) {
    const result::Series series = force_series(curve, scene.problem(), reports);
    table.columns.push_back({{curve.title + ": stretch", ""}, series.x});
    table.columns.push_back({{curve.title + ": force", "N"}, series.y});
  }
  add_distances(table, scene.output(), distances);
  return table;
}

result::Plot force_plot(const scene::Scene& scene, const std::vector<solve::StepReport>& reports) {
  result::Plot plot;
  plot.title = scene.title();
  plot.x_label = "stretch";
  plot.y_label = "force (N)";
  for (const scene::ForceCurve& curve : scene.output().force_curves)
    plot.series.push_back(force_series(curve, scene.problem(), reports));
  return plot;
}

}  // namespace toile::app
