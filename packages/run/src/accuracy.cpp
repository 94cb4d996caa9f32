#include "toile/run/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>

#include "alike.hpp"
#include "toile/base/error.hpp"
#include "toile/base/units.hpp"
#include "toile/result/csv.hpp"
#include "toile/run/pressure_report.hpp"

namespace toile::run {

namespace {

std::string percent(double part) {
  std::ostringstream text;
  text.precision(2);
  text << 100.0 * part << " %";
  return text.str();
}

/// The first part is the mesh's.
Counted counted_of(const std::string& title, double pressure, const std::vector<double>& error_parts) {
  Counted counted{title, pressure, error_parts.front(), 0.0};
  for (size_t p = 1; p < error_parts.size(); ++p) counted.others = std::hypot(counted.others, error_parts[p]);
  return counted;
}

const Counted& worst(const std::vector<Counted>& pressures) {
  return *std::max_element(pressures.begin(), pressures.end(),
                           [](const Counted& a, const Counted& b) { return a.error() < b.error(); });
}

/// What the runs so far have reached.
class Reached {
 public:
  void add(Session& session, double finer, const Counted& worst) {
    const std::vector<double> row = {finer,
                                     static_cast<double>(session.scene().garment().mesh.nodes()),
                                     session.timer().elapsed(),
                                     100.0 * worst.error(),
                                     base::mpa_to_kpa(worst.pressure),
                                     base::mpa_to_kpa(worst.mesh),
                                     base::mpa_to_kpa(worst.others)};
    for (size_t c = 0; c < row.size(); ++c) table_.columns[c].values.push_back(row[c]);
    table_.texts.push_back(worst.title);
  }
  void write(const std::string& folder) const {
    if (is_first_rank()) result::write_csv(folder + "/accuracy.csv", table_);
  }
  /// As lines for the terminal.
  std::string text() const {
    std::ostringstream lines;
    lines.precision(3);
    lines << "Error and time of the runs";
    for (size_t r = 0; r < table_.texts.size(); ++r) {
      const auto value = [&](size_t column) { return table_.columns[column].values[r]; };
      lines << "\n  " << value(1) << " nodes, " << value(2) << " s: largest error " << value(3) << " %, at \""
            << table_.texts[r] << "\" (" << value(4) << " kPa; mesh " << value(5) << ", others " << value(6) << ")";
    }
    return lines.str();
  }

 private:
  result::Table table_{"",
                       {},
                       {{{"finer", ""}, {}},
                        {{"nodes", ""}, {}},
                        {{"time", "s"}, {}},
                        {{"largest error", "%"}, {}},
                        {{"pressure there", "kPa"}, {}},
                        {{"error by mesh", "kPa"}, {}},
                        {{"other errors", "kPa"}, {}}},
                       "at",
                       {}};
};

/// Of a run: on a coarse mesh a check that does not hold, or is not decided, is no end yet.
std::exception_ptr failed_check(Session& session, const std::function<void(Session&)>& run) {
  try {
    run(session);
  } catch (const base::Error& error) {
    if (error.code() != base::ExitCode::check_failed) throw;
    session.log().warn(error.what());
    return std::current_exception();
  }
  return nullptr;
}

[[noreturn]] void give_up(const std::string& why) {
  throw base::Error(base::ExitCode::check_failed, "the error that the list \"Accuracy\" allows is not reached: " + why);
}

}  // namespace

double Counted::error() const {
  return std::hypot(mesh, others) / pressure;
}

std::vector<Counted> counted(const Record& record) {
  const scene::Scene& scene = record.scene();
  std::vector<Counted> all;
  const auto wanted = [&](const std::string& name) {
    const std::vector<std::string>& at = scene.accuracy()->at;
    return std::find(at.begin(), at.end(), name) != at.end();
  };
  for (const result::LevelRow& row : record.pressure().levels)
    if (wanted(row.name) && row.reached()) all.push_back(counted_of(row.title(), row.pressure_mean, row.error_parts));
  const solve::Fields& fields = record.fields();
  const auto add = [&](const auto& points, const std::vector<PointPressure>& at) {
    for (size_t p = 0; p < points.size(); ++p)
      if (wanted(points[p].title)) all.push_back(counted_of(points[p].title, at[p].pressure, at[p].error_parts));
  };
  const scene::Output& output = scene.output();
  add(output.points, point_pressures(scene, output.points, fields));
  add(output.body_points, body_pressures(scene, output.body_points, fields, record.last()));
  all.erase(std::remove_if(all.begin(), all.end(), [](const Counted& c) { return !(c.pressure > 0.0); }), all.end());
  return all;
}

double finer_by(const std::vector<Counted>& pressures, double wanted) {
  constexpr double reserve = 1.1, least = 1.2, most = 3.0;
  double factor = least;
  for (const Counted& at : pressures) {
    if (at.error() <= wanted) continue;
    const double allowed = wanted * at.pressure;
    if (at.others >= allowed)
      give_up("at \"" + at.title + "\" the parts that no mesh changes, the body's shape above all, are " +
              percent(at.others / at.pressure) + " of the pressure alone, and " + percent(wanted) +
              " is allowed. A better scan of the body helps, or a larger \"error\"");
    factor = std::max(factor, reserve * std::sqrt(at.mesh / std::sqrt(allowed * allowed - at.others * at.others)));
  }
  return std::min(factor, most);
}

void run_to_accuracy(const std::function<std::unique_ptr<Session>(double finer)>& start,
                     const std::function<void(Session&)>& run, const std::string& folder) {
  Reached reached;
  double finer = 1.0;
  for (int runs = 1;; ++runs) {
    const std::unique_ptr<Session> session = start(finer);
    const std::exception_ptr failed = failed_check(*session, run);
    const scene::Accuracy& accuracy = *session->scene().accuracy();
    const std::vector<Counted> pressures = counted(session->record());
    if (pressures.empty()) give_up("no fabric presses at any of the places that count");
    reached.add(*session, finer, worst(pressures));
    reached.write(folder);
    session->log().info(reached.text());
    if (worst(pressures).error() <= accuracy.error) {
      if (failed != nullptr) std::rethrow_exception(failed);
      return;
    }
    const double factor = finer_by(pressures, accuracy.error);
    const double nodes = factor * factor * session->scene().garment().mesh.nodes();
    if (runs == accuracy.most_runs) give_up("after " + std::to_string(runs) + " runs (\"most runs\")");
    if (nodes > accuracy.most_nodes)
      give_up("it would take a mesh of about " + std::to_string(std::lround(nodes)) + " nodes, and " +
              std::to_string(accuracy.most_nodes) + " are allowed (\"most nodes\")");
    finer *= factor;
  }
}

}  // namespace toile::run
