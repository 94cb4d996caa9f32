#include "toile/base/progress.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace toile::base {

void PathClock::start(double seconds) {
  falls_ = false;
  parameter_ = {0.0};
  seconds_ = {seconds};
}

void PathClock::advance(double parameter, double seconds) {
  falls_ = parameter < parameter_.back();
  if (parameter > parameter_.back()) {
    parameter_.push_back(parameter);
    seconds_.push_back(seconds);
  } else if (parameter_.size() == 1) {  // the first equilibrium is no step
    seconds_.back() = seconds;
  }
}

double PathClock::seconds_at(double parameter) const {
  const auto next = std::upper_bound(parameter_.begin() + 1, parameter_.end() - 1, parameter) - parameter_.begin();
  const auto k = static_cast<std::size_t>(next);
  const double share = (parameter - parameter_[k - 1]) / (parameter_[k] - parameter_[k - 1]);
  return seconds_[k - 1] + share * (seconds_[k] - seconds_[k - 1]);
}

// [step] s per unit of the parameter.
std::vector<double> PathClock::paces() const {
  std::vector<double> all;
  for (std::size_t k = 1; k < parameter_.size(); ++k)
    all.push_back((seconds_[k] - seconds_[k - 1]) / (parameter_[k] - parameter_[k - 1]));
  return all;
}

// The cost grows along a line or an exponential, one cannot tell which: the geometric mean of both. Where it falls, as
// the steps grow, it is taken to stay.
double PathClock::by_growth() const {
  constexpr double most_growth = 2.5;  // of the cost's logarithm, over the way that is left
  constexpr double no_growth = 1e-6;
  const double way = std::max(0.0, 1.0 - parameter_.back()), half = 0.5 * parameter_.back();
  const double middle = seconds_at(half);
  const double before = (middle - seconds_.front()) / half, now = (seconds_.back() - middle) / half;
  if (before <= 0.0 || way <= 0.0 || std::log(now / before) * way <= no_growth * half) return way * now;
  // The costs hold at a quarter and at three quarters of the way so far.
  const double line = way * (now + (now - before) / half * 0.5 * (half + way));
  const double growth = std::min(std::log(now / before) / half, most_growth / way);
  const double exponential = now * std::exp(0.5 * growth * half) * std::expm1(growth * way) / growth;
  return std::sqrt(line * exponential);
}

std::optional<TimeLeft> PathClock::left() const {
  if (parameter_.size() < 2 || falls_) return std::nullopt;
  constexpr double leap = 3.0;
  std::vector<double> all = paces();
  const double last = all.back();
  bool leaps = false;
  for (std::size_t k = 1; k < all.size(); ++k) leaps = leaps || all[k] > leap * all[k - 1];
  const double growing = by_growth();
  if (!leaps) return TimeLeft{growing, growing};
  std::sort(all.begin(), all.end());
  const double way = std::max(0.0, 1.0 - parameter_.back()), easy = way * all[all.size() / 3];
  return TimeLeft{std::min({growing, easy, way * last}), std::max({growing, easy, way * last})};
}

bool Heartbeat::due() {
  const double now = clock_();
  if (now - last_ < interval_) return false;
  last_ = now;
  return true;
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

namespace {

// Two estimates that are near each other are one.
std::string left_text(const TimeLeft& left) {
  constexpr double near = 2.0;
  if (left.most < near * left.least) return duration_text(std::sqrt(left.least * left.most));
  return duration_text(left.least) + " or " + duration_text(left.most);
}

}  // namespace

std::string progress_line(const ProgressPoint& point) {
  std::ostringstream out;
  out << '[' << point.stage_number << '/' << point.stages << "] " << point.stage << ": step " << point.step << ", "
      << std::fixed << std::setprecision(1) << 100.0 * point.parameter
      << (point.final_state ? " % (final state), load " : " %, load ") << std::setprecision(4) << point.load << ", "
      << point.iterations << " iterations, " << duration_text(point.seconds) << " elapsed";
  if (point.left && point.left->most > 0.0) out << ", about " << left_text(*point.left) << " to 100 %";
  return out.str();
}

std::string iteration_line(const IterationPoint& point) {
  std::ostringstream out;
  out << '[' << point.stage_number << '/' << point.stages << "] " << point.stage << ": ";
  if (point.relaxing)
    out << "seeking the final state";
  else
    out << "seeking " << std::fixed << std::setprecision(1) << 100.0 * point.parameter << " %";
  out << ", iteration " << point.iteration << std::scientific << std::setprecision(1) << ", residual " << point.residual
      << " (tolerance " << point.tolerance << ")";
  if (point.cut_backs > 0) out << ", " << point.cut_backs << " cut-backs";
  out << ", " << duration_text(point.seconds) << " elapsed";
  return out.str();
}

}  // namespace toile::base
