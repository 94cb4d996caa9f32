#include "toile/identify/fit.hpp"

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/base/log.hpp"
#include "toile/base/progress.hpp"
#include "toile/base/timer.hpp"
#include "toile/identify/calibrated_range.hpp"
#include "toile/identify/report.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::app {

namespace {

/// What the command line says of a fit.
struct IdentifyArguments {
  std::string file;         ///< XML file
  std::string output = "";  ///< folder of the results; empty: that of the file, or results/<name of the file>
  bool quiet = false;
  bool allow_plugins = false;               ///< the file may load programs
  bool describe = false, markdown = false;  ///< the input reference of a fit instead
};

using identify::Curve;
using identify::CurveReport;

const std::string fit_reference_title =
    "# Input reference of a fit\n\n"
    "What `toile identify` reads: `<ParameterList name=\"fit\">` with the lists below; see [identify](identify.md). "
    "This page is what `toile identify --describe --markdown` prints.\n\n";

/// Progress every twentieth of each phase, and at least every 10 s if there is any.
class Progress {
 public:
  Progress(base::Log& log, const base::Timer& timer) : log_(log), timer_(timer) {}
  void operator()(const identify::FitStatus& state) {
    const bool is_new = state.phase != phase_;
    if (is_new) {
      phase_ = state.phase;
      begin_ = end_;
    }
    end_ = timer_.elapsed();
    if (!is_new && state.part < next_ && state.part < 1.0 && end_ < reported_ + longest_silence) return;
    next_ = state.part + 0.05;
    reported_ = end_;
    std::ostringstream line;
    line.precision(3);
    line << phase_ << ": " << 100.0 * state.part << " %, chi^2 " << state.chi_squared << ", "
         << base::duration_text(end_) << " elapsed, about "
         << base::duration_text((end_ - begin_) * (1.0 - state.part) / state.part) << " left of it";
    log_.info(line.str());
  }

 private:
  static constexpr double longest_silence = 10.0;  ///< s

  base::Log& log_;
  const base::Timer& timer_;
  std::string phase_;
  double begin_ = 0.0, end_ = 0.0;  ///< of the current phase: its start, its last news
  double next_ = 0.0, reported_ = 0.0;
};

std::string folder_of(const IdentifyArguments& arguments, const base::List& list) {
  if (!arguments.output.empty()) return arguments.output;
  if (list.has_list("Output") && !list.list("Output").word("folder").empty()) return list.list("Output").word("folder");
  return "results/" + std::filesystem::path(arguments.file).stem().string();
}

void write_text(const std::string& path, const std::string& text) {
  result::replace_file(path, text, "cannot write " + path + ": ");
}

/// All curves, one below the other.
result::Table curve_table(const std::vector<Curve>& curves, const std::vector<CurveReport>& reports) {
  result::Table table;
  table.row_title = "curve";
  table.columns = {{{"stretch", "-"}, {}}, {{"data", "MPa"}, {}}, {{"noise", "MPa"}, {}}, {{"fit", "MPa"}, {}}};
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (std::size_t i = 0; i < curves[c].stretch.size(); ++i) {
      table.row_names.push_back(curves[c].name);
      const double row[] = {curves[c].stretch[i], curves[c].stress[i], curves[c].deviation[i], reports[c].stress[i]};
      for (std::size_t k = 0; k < 4; ++k) table.columns[k].values.push_back(row[k]);
    }
  return table;
}

result::Table residual_table(const std::vector<CurveReport>& reports) {
  result::Table table;
  table.row_title = "curve";
  table.columns = {{{"fitted", ""}, {}},
                   {{"rms", "MPa"}, {}},
                   {{"rms over that of the data", ""}, {}},
                   {{"largest", "MPa"}, {}},
                   {{"at stretch", ""}, {}},
                   {{"largest over largest stress", ""}, {}},
                   {{"at the end, relative", ""}, {}},
                   {{"missing points", ""}, {}},
                   {{"elements across", ""}, {}},
                   {{"mesh error over largest stress", ""}, {}},
                   {{"homogeneous at the end, relative", ""}, {}}};
  for (const CurveReport& r : reports) {
    table.row_names.push_back(r.name);
    // A homogeneous state has no mesh and errs by none.
    const identify::StripReport strip = r.strip.value_or(identify::StripReport{0, 0, 0.0, 0.0});
    const double row[] = {r.fitted ? 1.0 : 0.0, r.rms,
                          r.relative,           r.largest,
                          r.largest_at,         r.largest_relative,
                          r.end_relative,       double(r.missing),
                          double(strip.across), strip.mesh_error,
                          strip.homogeneous};
    for (std::size_t k = 0; k < table.columns.size(); ++k) table.columns[k].values.push_back(row[k]);
  }
  return table;
}

result::Table parameter_table(const identify::FitProblem& problem, const std::vector<double>& params,
                              const identify::ParameterStatistics& statistics) {
  result::Table table;
  table.row_title = "parameter";
  table.columns = {{{"value", ""}, {}}, {{"standard deviation", ""}, {}}, {{"lower", ""}, {}}, {{"upper", ""}, {}}};
  for (std::size_t k = 0; k < problem.free().size(); ++k) {
    const identify::FreeParameter& p = problem.free()[k];
    const material::ParamInfo& info = problem.law().info[p.index];
    table.row_names.push_back(std::string(info.name) + (*info.unit ? std::string(" [") + info.unit + "]" : ""));
    const double row[] = {params[p.index], statistics.deviation[k], p.lower, p.upper};
    for (std::size_t c = 0; c < 4; ++c) table.columns[c].values.push_back(row[c]);
  }
  return table;
}

/// `matrix` [n][n] over the free parameters.
result::Table matrix_table(const identify::FitProblem& problem, const std::vector<double>& matrix) {
  result::Table table;
  table.row_title = "parameter";
  const std::size_t n = problem.free().size();
  for (std::size_t a = 0; a < n; ++a) {
    const std::string name = problem.law().info[problem.free()[a].index].name;
    table.row_names.push_back(name);
    table.columns.push_back({{name, ""}, {matrix.begin() + a * n, matrix.begin() + (a + 1) * n}});
  }
  return table;
}

result::Plot curve_plot(const std::string& title, const std::vector<Curve>& curves,
                        const std::vector<CurveReport>& reports) {
  result::Plot plot;
  plot.title = title;
  plot.x_label = "stretch";
  plot.y_label = "nominal stress (MPa)";
  plot.legend_above = true;
  double largest = 0.0;
  for (const Curve& curve : curves)
    largest = std::max(largest, *std::max_element(curve.stress.begin(), curve.stress.end()));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    result::Series data = {curves[c].name, curves[c].stretch, curves[c].stress, false, true, {}};
    result::Series fit = {curves[c].name + (reports[c].fitted ? ", fit" : ", prediction"),
                          curves[c].stretch,
                          reports[c].stress,
                          true,
                          false,
                          {}};
    // A prediction that leaves the data far behind would hide all the others.
    for (double& y : fit.y)
      if (std::abs(y) > 2.0 * largest) y = std::numeric_limits<double>::quiet_NaN();
    data.colour = fit.colour = static_cast<int>(c) + 1;
    plot.series.push_back(data);
    plot.series.push_back(fit);
  }
  return plot;
}

int identify(const IdentifyArguments& arguments) {
  if (Tpetra::getDefaultComm()->getRank() != 0) return static_cast<int>(base::ExitCode::success);
  base::Log log(std::cout, std::cerr, arguments.quiet);
  base::Timer timer;
  const material::Laws laws = material::read_laws(arguments.file, "fit", arguments.allow_plugins);
  const base::List list = base::read_xml(arguments.file, identify::fit_spec(laws));
  const identify::FitProblem problem(list, laws);
  const std::string folder = folder_of(arguments, list);
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw base::InputError("cannot create the folder " + folder + ": " + failure.message());

  log.info(list.word("title") + "\n" + std::to_string(problem.free().size()) + " free parameters of material \"" +
           problem.law().name + "\", " + std::to_string(problem.curves().size()) + " curves, results in " + folder);
  const identify::FitResult result =
      identify::fit(problem, identify::Algorithm(list.list("Algorithm")), Progress(log, timer));
  const std::vector<CurveReport> reports = identify::curve_reports(problem, result.params);
  const identify::ParameterStatistics statistics = identify::parameter_statistics(problem, result);
  const identify::CalibratedRange range = identify::calibrated_range(problem, result.params);
  const std::string report = identify::report_text(problem, result, reports, statistics) + identify::range_text(range);

  const material::FitLimits limits = identify::fit_limits(problem, statistics, range);
  const std::string material = identify::material_xml(problem, range.params, limits);
  write_text(folder + "/material.xml", material);
  write_text(folder + "/include.xml", identify::include_xml(problem, range.params, list, folder, limits));
  write_text(folder + "/report.txt", report);
  result::write_csv(folder + "/curves.csv", curve_table(problem.curves(), reports));
  result::write_csv(folder + "/residuals.csv", residual_table(reports));
  result::write_csv(folder + "/parameters.csv", parameter_table(problem, result.params, statistics));
  result::write_csv(folder + "/covariance.csv", matrix_table(problem, statistics.covariance));
  result::write_csv(folder + "/correlation.csv", matrix_table(problem, statistics.correlation));
  const auto warning = result::write_plot(folder, "curves", curve_plot(list.word("title"), problem.curves(), reports));
  if (warning) log.warn(*warning);
  log.info(report + material);
  if (material::find(problem.law().name) == nullptr)
    log.info("A scene needs the law of this material too: let it include " + folder + "/include.xml, which holds both");
  if (!result.falls.empty())
    throw base::Error(base::ExitCode::check_failed,
                      "\"keep tangent positive\" does not hold: the stress falls to that of " + result.falls);
  return static_cast<int>(base::ExitCode::success);
}

/// With the plug-ins and formulas of a fit file, if one is given.
int describe_fit(const IdentifyArguments& arguments) {
  const base::Spec spec = identify::fit_spec(
      arguments.file.empty() ? material::Laws() : material::read_laws(arguments.file, "fit", arguments.allow_plugins));
  if (Tpetra::getDefaultComm()->getRank() == 0)
    std::cout << (arguments.markdown ? fit_reference_title + base::describe_markdown(spec) : base::describe_text(spec))
              << std::flush;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_identify(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<IdentifyArguments>();
  CLI::App* identify = program.add_subcommand("identify", "Fit the parameters of a material to tests of the fabric");
  CLI::Option* file = identify->add_option("fit", arguments->file, "XML file of the fit");
  add_output_option(identify, arguments->output, "Folder of the results (default: results/<name of the file>)");
  identify->add_flag("--quiet", arguments->quiet, "Print errors and warnings only");
  add_plugins_flag(identify, arguments->allow_plugins);
  CLI::Option* describing = identify->add_flag("--describe", arguments->describe,
                                               "Print every parameter of a fit file (of this one: its own laws too)");
  identify->add_flag("--markdown", arguments->markdown, "With --describe: as Markdown")->needs(describing);
  identify->callback([arguments, file, &chosen] {
    if (!arguments->describe && file->count() == 0) throw CLI::RequiredError("fit");
    chosen = [arguments] { return arguments->describe ? describe_fit(*arguments) : app::identify(*arguments); };
  });
}

}  // namespace toile::app
