#include "compression_fault.hpp"

#include <iomanip>
#include <sstream>

#include "toile/base/units.hpp"

namespace toile::run {

std::string compression_fault(const scene::Check& check, const PressureReport& pressure) {
  std::string problem;
  const result::LevelRow* row = section(pressure, check.sections.front(), problem);
  const std::string name = "check \"" + check.name + "\" ", level = "level " + check.sections.front();
  if (row == nullptr) return name + "does not hold: " + problem;
  if (!row->reached()) return name + "does not hold: the garment does not reach " + level;
  const double value = base::mpa_to_mmhg(row->pressure_mean), error = base::mpa_to_mmhg(row->pressure_error);
  const scene::Verdict verdict = scene::verdict(*check.compression, value, error);
  if (verdict == scene::Verdict::pass) return {};
  std::ostringstream message;
  message.precision(4);
  message << name << (verdict == scene::Verdict::fail ? "does not hold: " : "is not decided within the error: ")
          << "pressure at " << level << " is " << value << " +- " << std::setprecision(2) << error << " mmHg ("
          << scene::class_text(check.compression->standard, value) << "), asked for is "
          << scene::limits_text(*check.compression);
  if (verdict == scene::Verdict::undecided) message << "; " << scene::what_decides(*check.compression, value, error);
  return message.str();
}

}  // namespace toile::run
