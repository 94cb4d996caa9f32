#include "check_outcomes.hpp"

#include <cmath>
#include <iomanip>
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

/// A result that the mesh cannot give is none.
CheckOutcome unseen_outcome(const Pierced& pierced) {
  CheckOutcome outcome{"the elements see the body", "what the body sticks out of elements", pierced.share, "sides",
                       "at most 0.5"};
  std::ostringstream text;
  text.precision(3);
  if (pierced.share > Pierced::most)
    text << "the elements do not see the body: between their nodes it sticks out of them by "
         << (pierced.share < 1.0 ? "" : "more than ") << pierced.height << " mm at (" << pierced.where.x() << ", "
         << pierced.where.y() << ", " << pierced.where.z() << ") mm, " << std::fixed << std::setprecision(2)
         << pierced.share
         << " times their side, and at most 0.5 is allowed. What the fabric presses there, and what it carries, is not "
            "known. Smaller elements help (\"finer\", or a list \"Sizes\" with \"mesher\" = \"free\") until they are "
            "half as large as the radius of the tip or edge. Where it is sharp fabric is stretched without limit, and "
            "no mesh is fine enough: round it";
  else
    text << "the garment presses on the body nowhere, and " << pierced.passed
         << " of its elements lie beyond the body, seen from where they were placed: it went through between their "
            "nodes, or slid or was led round it. Is a seam forgotten? If not, give the panel smaller elements "
            "(\"finer\") and the stage smaller steps (\"first step\")";
  outcome.message = text.str();
  return outcome;
}

/// What is said of a class where fabric is stretched beyond what its tests reached; empty: hardly any is.
std::string extrapolated_fault(const Record& record) {
  constexpr double few = 0.02;
  const int elements = record.scene().garment().mesh.elements(), extrapolated = record.last().extrapolated;
  if (extrapolated <= few * elements) return "";
  return "is not decided: " + std::to_string(extrapolated) + " of " + std::to_string(elements) +
         " elements are outside the calibrated range of their fabric, and no error tells how wrong their pressure is. "
         "Is the pattern too narrow for the body?";
}

CheckOutcome class_outcome(const scene::Check& check, const Record& record) {
  const PressureReport& pressure = record.pressure();
  std::string problem;
  const double mmhg = base::mmhg_per_kpa * section_pressure(check.sections.front(), pressure, problem);
  CheckOutcome outcome{check.name, check.quantity, mmhg, "mmHg", scene::limits_text(*check.compression)};
  outcome.message = compression_fault(check, pressure);
  if (const std::string fault = extrapolated_fault(record); outcome.message.empty() && !fault.empty())
    outcome.message = "check \"" + check.name + "\" " + fault;
  outcome.holds = outcome.message.empty();
  return outcome;
}

}  // namespace

std::vector<CheckOutcome> check_outcomes(const Record& record) {
  std::vector<CheckOutcome> outcomes;
  if (record.pierced().unseen()) outcomes.push_back(unseen_outcome(record.pierced()));
  if (record.scene().checks().empty()) return outcomes;
  const Values values = plain_values(record);
  for (const scene::Check& check : record.scene().checks())
    outcomes.push_back(check.compression ? class_outcome(check, record)
                                         : bounds_outcome(check, values, record.pressure()));
  return outcomes;
}

}  // namespace toile::run
