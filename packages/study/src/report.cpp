#include "toile/study/report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "not_a_number.hpp"
#include "table_text.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::study {

namespace {

constexpr double percent = 100.0;
constexpr std::size_t most_plotted_problems = 24;

std::string number(double value, int digits = 5) {
  if (std::isnan(value)) return "-";
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

std::string share(double value) {
  return std::isfinite(value) ? number(percent * value, 3) + " %" : "-";
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string time_title(const Study& study) {
  return study.processor_time ? "processor time" : "wall time";
}

std::vector<std::string> axis_titles(const Study& study) {
  std::vector<std::string> titles;
  for (const Axis& axis : study.axes)
    for (const Axis::Change& change : axis.changes) titles.push_back(change.name);
  return titles;
}

std::vector<std::string> axis_labels(const Study& study, const Case& one) {
  std::vector<std::string> labels;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    for (std::size_t c = 0; c < study.axes[a].changes.size(); ++c) labels.push_back(study.label(one, a, c));
  return labels;
}

/// The settings of a case, without what makes it another problem.
std::string setting_text(const Study& study, const Case& one) {
  std::string text;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (!study.axes[a].problem) text += (text.empty() ? "" : ", ") + study.axes[a].name() + " " + study.label(one, a);
  return text.empty() ? one.name : text;
}

std::string cases_text(const Study& study, const Evaluation& e) {
  std::vector<std::vector<std::string>> table = {axis_titles(study)};
  for (const char* title : {"verdict", "unknowns", "time s"}) table[0].emplace_back(title);
  for (const Quantity& q : study.quantities)
    for (const std::string& title : {q.name, std::string("its error"), std::string("error")}) table[0].push_back(title);
  table[0].emplace_back("");
  for (std::size_t i = 0; i < e.rows.size(); ++i) {
    const Row& row = e.rows[i];
    std::vector<std::string> cells = axis_labels(study, study.cases[i]);
    cells.push_back(text_of(row.verdict));
    cells.push_back(number(row.unknowns, 9));
    cells.push_back(number(row.seconds, 3));
    for (const Measured& m : row.measured) {
      cells.push_back(number(m.value, 6));
      cells.push_back(number(m.bar, 2));
      cells.push_back(share(m.error));
    }
    cells.push_back((row.pareto ? "* " : "") + first_line(row.reason));
    table.push_back(cells);
  }
  return table_text(table);
}

std::string limit_text(const Extrapolation& limit) {
  if (!limit.trusted) return "not to be trusted: " + limit.why;
  if (std::isnan(limit.order)) return number(limit.value, 7) + ": the meshes agree";
  return number(limit.value, 7) + " +- " + number(limit.uncertainty, 2) + ", order " + number(limit.order, 3) +
         (std::isnan(limit.order_spread) ? " (of three meshes: its error is not known)"
                                         : " +- " + number(limit.order_spread, 2));
}

std::string limits_text(const Study& study, const Evaluation& e) {
  std::vector<std::vector<std::string>> table;
  for (const Series& series : e.series)
    for (std::size_t q = 0; q < series.limits.size(); ++q)
      table.push_back(
          {e.problems[series.problem], series.title, study.quantities[q].name, limit_text(series.limits[q])});
  return table.empty() ? ""
                       : "Extrapolated along \"" + study.axes[static_cast<std::size_t>(study.refine)].name() + "\"\n" +
                             table_text(table);
}

std::string cheapest_text(const Study& study, const Evaluation& e) {
  std::vector<std::vector<std::string>> table;
  for (const Cheapest& cheapest : e.cheapest) {
    std::vector<std::string> cells = {e.problems[cheapest.problem], share(cheapest.target)};
    if (cheapest.row < 0) {
      cells.emplace_back("no setting is known to reach it");
    } else {
      const auto i = static_cast<std::size_t>(cheapest.row);
      cells.push_back(setting_text(study, study.cases[i]) + ": " + number(e.rows[i].seconds, 3) + " s, error " +
                      share(e.rows[i].error));
    }
    table.push_back(cells);
  }
  return table.empty() ? "" : "Cheapest setting by " + time_title(study) + "\n" + table_text(table);
}

std::string counts_text(const Evaluation& e) {
  std::string text = std::to_string(e.rows.size()) + " cases:";
  const char* separator = " ";
  for (const Verdict verdict : {Verdict::right, Verdict::ran, Verdict::warned, Verdict::refused, Verdict::wrong,
                                Verdict::crashed, Verdict::endless}) {
    const auto count =
        std::count_if(e.rows.begin(), e.rows.end(), [verdict](const Row& r) { return r.verdict == verdict; });
    if (count == 0) continue;
    text += separator + std::to_string(count) + " " + text_of(verdict);
    separator = ", ";
  }
  return text + "\n";
}

void add(result::Table& table, const std::string& name, const std::string& unit, const std::vector<double>& values) {
  table.columns.push_back({{name, unit}, values});
}

template <class Value>
std::vector<double> column(const Evaluation& e, const Value& value) {
  std::vector<double> values;
  for (const Row& row : e.rows) values.push_back(value(row));
  return values;
}

result::Table cases_table(const Study& study, const std::vector<Outcome>& outcomes, const Evaluation& e) {
  result::Table table;
  table.row_title = "case";
  for (const std::string& title : axis_titles(study)) table.more_names.push_back({title, {}});
  table.more_names.push_back({"verdict", {}});
  table.text_title = "reason";
  std::vector<double> status, seconds, processor;
  for (std::size_t i = 0; i < e.rows.size(); ++i) {
    std::vector<std::string> labels = axis_labels(study, study.cases[i]);
    labels.push_back(text_of(e.rows[i].verdict));
    for (std::size_t c = 0; c < labels.size(); ++c) table.more_names[c].second.push_back(labels[c]);
    table.row_names.push_back(study.cases[i].name);
    table.texts.push_back(e.rows[i].reason);
    status.push_back(outcomes[i].status);
    seconds.push_back(outcomes[i].seconds);
    processor.push_back(outcomes[i].processor_seconds);
  }
  add(table, "status", "", status);
  add(table, "unknowns", "", column(e, [](const Row& r) { return r.unknowns; }));
  add(table, "peak memory", "MB", column(e, [](const Row& r) { return r.megabytes; }));
  add(table, "wall time", "s", seconds);
  add(table, "processor time", "s", processor);
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const std::string& name = study.quantities[q].name;
    add(table, name, "", column(e, [q](const Row& r) { return r.measured[q].value; }));
    add(table, name + ": its error", "", column(e, [q](const Row& r) { return r.measured[q].bar; }));
    add(table, name + ": reference", "", column(e, [q](const Row& r) { return r.measured[q].reference; }));
    add(table, name + ": error of the reference", "", column(e, [q](const Row& r) { return r.measured[q].uncertain; }));
    add(table, name + ": error", "%", column(e, [q](const Row& r) { return percent * r.measured[q].error; }));
  }
  add(table, "error", "%", column(e, [](const Row& r) { return percent * r.error; }));
  add(table, "on the Pareto front", "", column(e, [](const Row& r) { return r.pareto ? 1.0 : 0.0; }));
  return table;
}

result::Table limits_table(const Study& study, const Evaluation& e) {
  result::Table table;
  table.row_title = "quantity";
  table.more_names = {{"problem", {}}, {"setting", {}}};
  table.text_title = "why not trusted";
  std::vector<double> value, uncertainty, order, spread, trusted;
  for (const Series& series : e.series)
    for (std::size_t q = 0; q < series.limits.size(); ++q) {
      const Extrapolation& limit = series.limits[q];
      table.row_names.push_back(study.quantities[q].name);
      table.more_names[0].second.push_back(e.problems[series.problem]);
      table.more_names[1].second.push_back(series.title);
      table.texts.push_back(limit.why);
      value.push_back(limit.value);
      uncertainty.push_back(limit.uncertainty);
      order.push_back(limit.order);
      spread.push_back(limit.order_spread);
      trusted.push_back(limit.trusted ? 1.0 : 0.0);
    }
  add(table, "value", "", value);
  add(table, "its error", "", uncertainty);
  add(table, "order", "", order);
  add(table, "its error", "", spread);
  add(table, "trusted", "", trusted);
  return table;
}

result::Table cheapest_table(const Study& study, const Evaluation& e) {
  result::Table table;
  table.row_title = "problem";
  table.text_title = "setting";
  std::vector<double> target, error, seconds;
  for (const Cheapest& cheapest : e.cheapest) {
    const bool found = cheapest.row >= 0;
    const auto i = static_cast<std::size_t>(found ? cheapest.row : 0);
    table.row_names.push_back(e.problems[cheapest.problem]);
    table.texts.push_back(found ? setting_text(study, study.cases[i]) : "");
    target.push_back(percent * cheapest.target);
    error.push_back(found ? percent * e.rows[i].error : not_a_number);
    seconds.push_back(found ? e.rows[i].seconds : not_a_number);
  }
  add(table, "target", "%", target);
  add(table, "error", "%", error);
  add(table, time_title(study), "s", seconds);
  return table;
}

/// Errors of a problem over `abscissa`, a curve a setting, and the Pareto front if it is wanted.
template <class Abscissa>
result::Plot plot_of(const Study& study, const Evaluation& e, std::size_t problem, bool with_front,
                     const Abscissa& abscissa) {
  result::Plot plot;
  plot.title = study.title + (e.problems[problem].empty() ? "" : ", " + e.problems[problem]);
  plot.y_label = "error (%)";
  plot.logarithmic = plot.legend_above = true;
  const auto add_point = [&](result::Series& series, std::size_t i) {
    if (!(e.rows[i].error > 0.0) || !(abscissa(e.rows[i]) > 0.0)) return;
    series.x.push_back(abscissa(e.rows[i]));
    series.y.push_back(percent * e.rows[i].error);
  };
  for (const Series& one : e.series) {
    if (one.problem != problem) continue;
    result::Series series{one.title.empty() ? "error" : one.title, {}, {}, true, true, {}};
    for (const std::size_t i : one.rows) add_point(series, i);
    if (!series.x.empty()) plot.series.push_back(series);
  }
  if (!with_front || plot.series.empty()) return plot;
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < e.rows.size(); ++i)
    if (e.rows[i].problem == problem && e.rows[i].pareto) front.push_back(i);
  std::sort(front.begin(), front.end(),
            [&e](std::size_t a, std::size_t b) { return e.rows[a].seconds < e.rows[b].seconds; });
  result::Series series{"Pareto front", {}, {}, true, false, {}};
  for (const std::size_t i : front) add_point(series, i);
  plot.series.push_back(series);
  return plot;
}

void draw(const std::string& folder, const std::string& name, const result::Plot& plot, base::Texts& warnings) {
  if (plot.series.empty()) return;
  if (const auto warning = result::write_plot(folder, name, plot)) warnings.push_back(*warning);
}

}  // namespace

std::string report_text(const Study& study, const std::vector<Outcome>& outcomes, const Evaluation& evaluation) {
  std::string text = cases_text(study, evaluation) + limits_text(study, evaluation) + cheapest_text(study, evaluation) +
                     counts_text(evaluation);
  const auto known = std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return o.known; });
  if (known > 0) text += std::to_string(known) + " of them were known from before\n";
  return text;
}

base::Texts write_report(const Study& study, const std::vector<Outcome>& outcomes, const Evaluation& evaluation,
                         const std::string& folder) {
  result::write_csv(folder + "/study.csv", cases_table(study, outcomes, evaluation));
  result::write_csv(folder + "/limits.csv", limits_table(study, evaluation));
  result::write_csv(folder + "/cheapest.csv", cheapest_table(study, evaluation));
  result::replace_file(folder + "/report.txt", report_text(study, outcomes, evaluation),
                       "cannot write the report in '" + folder + "': ");
  base::Texts warnings;
  const std::size_t problems = evaluation.problems.size();
  if (problems > most_plotted_problems) return warnings;
  for (std::size_t problem = 0; problem < problems; ++problem) {
    const std::string ending = problems == 1 ? "" : "-" + std::to_string(problem + 1);
    result::Plot time = plot_of(study, evaluation, problem, true, [](const Row& r) { return r.seconds; });
    time.x_label = time_title(study) + " (s)";
    draw(folder, "error-time" + ending, time, warnings);
    result::Plot size = plot_of(study, evaluation, problem, false, [](const Row& r) { return r.unknowns; });
    size.x_label = "unknowns";
    draw(folder, "error-unknowns" + ending, size, warnings);
  }
  return warnings;
}

}  // namespace toile::study
