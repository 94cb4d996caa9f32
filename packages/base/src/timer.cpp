#include "toile/base/timer.hpp"

#include <algorithm>
#include <cassert>
#include <iomanip>
#include <sstream>

namespace toile::base {
namespace {

double seconds_since(Timer::Clock::time_point start) {
  return std::chrono::duration<double>(Timer::Clock::now() - start).count();
}

void print_line(std::ostream& out, std::size_t width, const std::string& name, double seconds, double whole) {
  const double share = whole > 0.0 ? 100.0 * seconds / whole : 0.0;
  out << std::left << std::setw(static_cast<int>(width)) << name << std::right << std::fixed << std::setprecision(2)
      << std::setw(10) << seconds << " s" << std::setprecision(1) << std::setw(7) << share << " %";
}

}  // namespace

Timer::Timer() : start_(Clock::now()), nodes_(1) {}

Timer::Scope Timer::phase(const std::string& name) {
  const std::vector<int>& inner = nodes_[open_].inner;
  const auto known = std::find_if(inner.begin(), inner.end(), [&](int i) { return nodes_[i].phase.name == name; });
  int next = static_cast<int>(nodes_.size());
  if (known != inner.end()) {
    next = *known;
  } else {
    const int depth = open_ == 0 ? 0 : nodes_[open_].phase.depth + 1;
    nodes_[open_].inner.push_back(next);
    nodes_.push_back({{name, depth, 0, 0.0}, open_, {}, {}});
  }
  open_ = next;
  nodes_[open_].start = Clock::now();
  return Scope(*this);
}

void Timer::leave() {
  assert(open_ != 0);
  Node& node = nodes_[open_];
  node.phase.seconds += seconds_since(node.start);
  ++node.phase.calls;
  open_ = node.parent;
}

void Timer::append(int node, std::vector<Phase>& phases) const {
  for (const int inner : nodes_[node].inner) {
    phases.push_back(nodes_[inner].phase);
    append(inner, phases);
  }
}

std::vector<Timer::Phase> Timer::phases() const {
  std::vector<Phase> all;
  append(0, all);
  return all;
}

double Timer::elapsed() const {
  return seconds_since(start_);
}

std::string Timer::table() const {
  const std::vector<Phase> all = phases();
  const double whole = elapsed();
  const auto indented = [](const Phase& phase) { return std::string(2 * phase.depth, ' ') + phase.name; };
  std::size_t width = 5;
  for (const Phase& phase : all) width = std::max(width, indented(phase).size());
  std::ostringstream out;
  for (const Phase& phase : all) {
    print_line(out, width, indented(phase), phase.seconds, whole);
    out << std::setw(8) << phase.calls << "x\n";
  }
  print_line(out, width, "total", whole, whole);
  out << '\n';
  return out.str();
}

}  // namespace toile::base
