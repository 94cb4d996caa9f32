#include "toile/base/progress.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace toile::base {

std::optional<double> time_left(const ProgressPoint& point) {
  const double done = (point.stage_number - 1 + point.parameter) / point.stages;
  if (done <= 0.0) return std::nullopt;
  return point.seconds * (1.0 - done) / done;
}

std::string duration_text(double seconds) {
  std::ostringstream out;
  const long whole = std::lround(seconds);
  if (whole < 60) {
    out << std::fixed << std::setprecision(1) << seconds << " s";
  } else if (whole < 3600) {
    out << whole / 60 << " min " << std::setw(2) << std::setfill('0') << whole % 60 << " s";
  } else {
    const long minutes = std::lround(seconds / 60.0);
    out << minutes / 60 << " h " << std::setw(2) << std::setfill('0') << minutes % 60 << " min";
  }
  return out.str();
}

std::string progress_line(const ProgressPoint& point) {
  std::ostringstream out;
  out << '[' << point.stage_number << '/' << point.stages << "] " << point.stage << ": step " << point.step << ", "
      << std::fixed << std::setprecision(1) << 100.0 * point.parameter
      << (point.final_state ? " % (final state), load " : " %, load ") << std::setprecision(4) << point.load << ", "
      << point.iterations << " iterations, " << duration_text(point.seconds) << " elapsed";
  if (const auto left = time_left(point)) out << ", about " << duration_text(*left) << " left";
  return out.str();
}

}  // namespace toile::base
