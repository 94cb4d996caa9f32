// toile compare: measured pressures beside those of a run, each with its scatter or error.
#include <Tpetra_Core.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

#include "body_input.hpp"
#include "commands.hpp"
#include "measured.hpp"
#include "toile/base/error.hpp"
#include "toile/base/units.hpp"
#include "toile/base/with_error.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"

namespace toile::app {
namespace {

const std::string compared_name = "pressure-compared";

struct CompareArguments {
  std::string results;   ///< folder of a run
  std::string measured;  ///< CSV file
  std::string output;    ///< folder; empty: that of the run
};

/// What is said of one place, in the words of the table.
const std::string yes = "yes", no = "no", not_decided = "not decided";

/// Two lists of pressures at the same places.
class Comparison {
 public:
  Comparison(const MeasuredPlaces& measured, const Pressures& computed) : measured_(measured), computed_(computed) {}

  std::size_t size() const { return computed_.values.size(); }
  double deviation(std::size_t i) const { return computed_.values[i] - measured_.pressures.values[i]; }
  /// Whether the two bars have a common point. A computed value that is no larger than its error would agree with
  /// nothing pressing as well: then it is not decided, unless its error is within the scatter of the measured one.
  const std::string& within(std::size_t i) const {
    const double error = computed_.errors[i];
    if (std::abs(deviation(i)) > measured_.pressures.errors[i] + error) return no;
    return error > std::max(measured_.pressures.errors[i], 0.0) && error >= computed_.values[i] ? not_decided : yes;
  }
  /// Names of the places of which this is said, with commas.
  std::string places(const std::string& said) const {
    std::string names;
    for (std::size_t i = 0; i < size(); ++i)
      if (within(i) == said) names += (names.empty() ? "" : ", ") + computed_.names[i];
    return names;
  }

  result::Table table() const {
    result::Table table{"name", computed_.names, {}, "within both", {}};
    for (std::size_t k = 0; k < 3 && !measured_.positions.empty(); ++k) {
      table.columns.push_back({{std::string(1, "xyz"[k]), "mm"}, {}});
      for (const auto& position : measured_.positions) table.columns.back().values.push_back(position[k]);
    }
    const auto add = [&table](const std::string& title, const std::vector<double>& values) {
      table.columns.push_back({{title, "kPa"}, values});
    };
    add("measured", measured_.pressures.values);
    add("its scatter", measured_.pressures.errors);
    add("computed", computed_.values);
    add("its error", computed_.errors);
    add("deviation", {});
    for (std::size_t i = 0; i < size(); ++i) {
      table.columns.back().values.push_back(deviation(i));
      table.texts.push_back(within(i));
    }
    return table;
  }

  /// For the terminal.
  std::string text() const {
    std::vector<std::vector<std::string>> rows = {
        {"place", "measured [kPa]", "computed [kPa]", "deviation [kPa]", "[mmHg]", "[%]", "within both"}};
    const auto bar = [](const Pressures& pressures, std::size_t i) {
      return base::with_error(pressures.values[i], pressures.errors[i], 3);
    };
    double sum = 0.0;
    std::size_t largest = 0;
    std::map<std::string, int> count;
    for (std::size_t i = 0; i < size(); ++i) {
      const double d = deviation(i), m = measured_.pressures.values[i];
      rows.push_back({computed_.names[i], bar(measured_.pressures, i), bar(computed_, i), decimals(d, 3),
                      decimals(base::kpa_to_mmhg(d), 2), m > 0.0 ? decimals(100.0 * d / m, 1) : "", within(i)});
      ++count[within(i)];
      sum += d;
      if (std::abs(d) > std::abs(deviation(largest))) largest = i;
    }
    const auto both_units = [](double kpa) {
      return decimals(kpa, 3) + " kPa, " + decimals(base::kpa_to_mmhg(kpa), 2) + " mmHg";
    };
    std::string counted;
    for (const std::string& said : {yes, no, not_decided})
      counted += (counted.empty() ? "" : ", ") + std::to_string(count[said]) + " " + said;
    return text_table(rows) + "within both        " + counted + "\nmean deviation     " +
           both_units(sum / static_cast<double>(size())) + "\nlargest deviation  " + both_units(deviation(largest)) +
           ", at " + computed_.names[largest] + "\n";
  }

  result::Plot plot() const {
    result::Plot plot;
    plot.title = "Measured and computed pressure";
    plot.x_label = "place";
    plot.y_label = "pressure (kPa)";
    plot.second_axis = result::SecondAxis{"pressure (mmHg)", base::mmhg_per_kpa};
    plot.y_from_zero = true;
    plot.legend_above = true;
    // Side by side, so that bars do not hide each other.
    plot.series = {series("measured, with its scatter", measured_.pressures, -0.05),
                   series("computed, with its error", computed_, 0.05)};
    plot.series.back().labels = computed_.names;
    return plot;
  }

 private:
  static result::Series series(const std::string& title, const Pressures& pressures, double shift) {
    result::Series series;
    series.title = title;
    series.line = false;
    series.markers = true;
    series.y = pressures.values;
    series.errors = pressures.errors;
    for (std::size_t i = 0; i < pressures.values.size(); ++i) series.x.push_back(static_cast<double>(i + 1) + shift);
    return series;
  }

  const MeasuredPlaces& measured_;
  const Pressures& computed_;
};

int compare(const CompareArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError("compare runs on one rank; start it without mpirun");
  const MeasuredPlaces measured = read_measured(arguments.measured);
  const Pressures computed = computed_at(measured, arguments.results);
  const Comparison comparison(measured, computed);
  const std::string folder = arguments.output.empty() ? arguments.results : arguments.output;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw base::InputError("cannot make the folder '" + folder + "': " + error.message());
  std::cout << comparison.text();
  for (const Pressures* of : {&measured.pressures, &computed})
    for (const std::string& note : of->notes) std::cout << "note: " << note << "\n";
  std::cout << std::flush;
  result::write_csv(folder + "/" + compared_name + ".csv", comparison.table());
  if (const auto warning = result::write_plot(folder, compared_name, comparison.plot()))
    std::cerr << "toile: warning: " << *warning << std::endl;
  std::string faults;
  if (const std::string outside = comparison.places(no); !outside.empty())
    faults = "measured and computed pressure differ by more than scatter and error together: " + outside;
  if (const std::string open = comparison.places(not_decided); !open.empty())
    faults += (faults.empty() ? "" : "; ") +
              ("not decided, since the computed pressure is no larger than its error: " + open);
  if (faults.empty()) return static_cast<int>(base::ExitCode::success);
  throw base::Error(base::ExitCode::check_failed, faults);
}

}  // namespace

void add_compare(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = program.add_subcommand("compare", "Measured pressures beside those of a run");
  command->add_option("results", arguments->results, "Folder of the run")->required()->type_name("DIR");
  command
      ->add_option("measured", arguments->measured,
                   "CSV file with the columns name, pressure and scatter, each [kPa] or [mmHg]; the names are levels "
                   "or points of the scene. Further columns x [mm], y [mm], z [mm] make each row a place on the body, "
                   "and its name is then of your choice")
      ->required()
      ->type_name("FILE");
  add_output_option(command, arguments->output, "Folder of table and plot (default: that of the run)");
  command->callback([arguments, &chosen] { chosen = [arguments] { return compare(*arguments); }; });
}

}  // namespace toile::app
