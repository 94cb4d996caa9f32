// The scene's checks: one that does not hold ends the run with its exit status.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "compression_fault.hpp"
#include "figures.hpp"
#include "output.hpp"
#include "toile/base/error.hpp"
#include "toile/base/units.hpp"

namespace toile::run {

namespace {

std::string unit_of(const scene::Check& check) {
  if (check.sections.size() == 1 || check.quantity == "largest pressure" ||
      check.quantity == "smallest principal stress")
    return " kPa";
  return check.quantity == "largest gap" ? " mm" : "";
}

/// Pressure (kPa) of the section that a check names; NaN and the reason if there is none or more than one.
double section_pressure(const std::string& title, const PressureReport& pressure, std::string& problem) {
  const result::LevelRow* row = section(pressure, title, problem);
  return row != nullptr && row->reached() ? base::mpa_to_kpa(row->pressure_mean) : NAN;
}

double value_of(const scene::Check& check, const Figures& f, const PressureReport& pressure, std::string& problem) {
  if (check.sections.empty()) {
    const std::map<std::string, double> values = {
        {"largest pressure", f.largest_pressure},   {"smallest principal stress", f.smallest_stress},
        {"force balance", f.force_balance},         {"largest gap", f.largest_gap},
        {"dissipation ratio", f.dissipation_ratio}, {"extrapolated elements", f.extrapolated}};
    return values.at(check.quantity);
  }
  const double first = section_pressure(check.sections[0], pressure, problem);
  return check.sections.size() == 1 ? first : first / section_pressure(check.sections[1], pressure, problem);
}

/// One message for each check that does not hold, or whose quantity does not exist.
std::vector<std::string> failed_checks(const scene::Scene& scene, const Figures& figures,
                                       const PressureReport& pressure) {
  std::vector<std::string> failed;
  for (const scene::Check& check : scene.checks()) {
    std::string problem;
    if (check.compression) {
      const std::string fault = compression_fault(check, pressure);
      if (!fault.empty()) failed.push_back(fault);
      continue;
    }
    const double value = value_of(check, figures, pressure, problem);
    if (value >= check.lower && value <= check.upper) continue;
    std::ostringstream message;
    message << "check \"" << check.name << "\" does not hold: " << check.quantity;
    if (std::isnan(value))
      message << " has no value" << (problem.empty() ? ": the garment does not reach it" : ": " + problem);
    else
      message << " is " << value << unit_of(check) << ", allowed: " << base::Range{check.lower, check.upper}.text();
    failed.push_back(message.str());
  }
  return failed;
}

class Checks : public Observer {
 public:
  void end(const Record& record) override {
    const Figures figures = figures_of(record.fields(), record.last());
    std::string all;
    for (const std::string& failed : failed_checks(record.scene(), figures, record.pressure()))
      all += (all.empty() ? "" : "\n") + failed;
    if (!all.empty()) throw base::Error(base::ExitCode::check_failed, all);
  }
};

}  // namespace

Output checks_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.scene.checks().empty()) return nullptr;
            return std::make_unique<Checks>();
          }};
}

}  // namespace toile::run
