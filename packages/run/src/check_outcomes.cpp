#include "check_outcomes.hpp"

#include <cmath>
#include <map>
#include <sstream>

#include "compression_fault.hpp"
#include "figures.hpp"
#include "toile/base/units.hpp"
#include "toile/run/shadow.hpp"

namespace toile::run {

namespace {

std::string unit_of(const scene::Check& check) {
  if (check.sections.size() == 1 || check.quantity == "largest pressure" ||
      check.quantity == "smallest principal stress")
    return "kPa";
  return check.quantity == "largest gap" ? "mm" : "";
}

/// Pressure (kPa) of the section that a check names; NaN and the reason if there is none or more than one.
double section_pressure(const std::string& title, const PressureReport& pressure, std::string& problem) {
  const result::LevelRow* row = section(pressure, title, problem);
  return row != nullptr && row->reached() ? base::mpa_to_kpa(row->pressure_mean) : NAN;
}

/// By the word of the input.
using Values = std::map<std::string, double>;

/// What needs no level; of drape, if the scene has a drapemeter.
Values plain_values(const Record& record) {
  const Figures f = figures_of(record.fields(), record.last());
  Values values = {{"largest pressure", f.largest_pressure},   {"smallest principal stress", f.smallest_stress},
                   {"force balance", f.force_balance},         {"largest gap", f.largest_gap},
                   {"dissipation ratio", f.dissipation_ratio}, {"extrapolated elements", f.extrapolated}};
  if (!record.scene().output().drapemeter) return values;
  const DrapeReading drape = read_drape(record.scene(), record.fields().position);
  values["drape coefficient"] = drape.coefficient;
  values["folds"] = drape.folds;
  return values;
}

double value_of(const scene::Check& check, const Values& values, const PressureReport& pressure, std::string& problem) {
  if (check.sections.empty()) return values.at(check.quantity);
  const double first = section_pressure(check.sections[0], pressure, problem);
  return check.sections.size() == 1 ? first : first / section_pressure(check.sections[1], pressure, problem);
}

std::string message_of(const CheckOutcome& outcome, const std::string& problem) {
  std::ostringstream message;
  message << "check \"" << outcome.name << "\" does not hold: " << outcome.quantity;
  if (std::isnan(outcome.value))
    message << " has no value" << (problem.empty() ? ": the garment does not reach it" : ": " + problem);
  else
    message << " is " << outcome.value << (outcome.unit.empty() ? "" : " " + outcome.unit)
            << ", allowed: " << outcome.allowed;
  return message.str();
}

CheckOutcome bounds_outcome(const scene::Check& check, const Values& values, const PressureReport& pressure) {
  std::string problem;
  CheckOutcome outcome{check.name, check.quantity, value_of(check, values, pressure, problem), unit_of(check),
                       base::Range{check.lower, check.upper}.text()};
  outcome.holds = outcome.value >= check.lower && outcome.value <= check.upper;
  if (!outcome.holds) outcome.message = message_of(outcome, problem);
  return outcome;
}

CheckOutcome class_outcome(const scene::Check& check, const PressureReport& pressure) {
  std::string problem;
  const double mmhg = base::mmhg_per_kpa * section_pressure(check.sections.front(), pressure, problem);
  CheckOutcome outcome{check.name, check.quantity, mmhg, "mmHg", scene::limits_text(*check.compression)};
  outcome.message = compression_fault(check, pressure);
  outcome.holds = outcome.message.empty();
  return outcome;
}

}  // namespace

std::vector<CheckOutcome> check_outcomes(const Record& record) {
  std::vector<CheckOutcome> outcomes;
  if (record.scene().checks().empty()) return outcomes;
  const Values values = plain_values(record);
  for (const scene::Check& check : record.scene().checks())
    outcomes.push_back(check.compression ? class_outcome(check, record.pressure())
                                         : bounds_outcome(check, values, record.pressure()));
  return outcomes;
}

}  // namespace toile::run
