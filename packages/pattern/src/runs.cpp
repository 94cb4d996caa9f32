#include "runs.hpp"

#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "segment.hpp"

namespace toile::pattern {

std::vector<Curve> smooth_runs(const std::vector<Segment>& segments, double angle) {
  std::vector<Curve> runs;
  std::vector<Segment> run;
  for (const Segment& segment : segments) {
    if (!run.empty()) {
      const double cosine = direction(run.back(), 1.0).dot(direction(segment, 0.0));
      if (std::acos(std::clamp(cosine, -1.0, 1.0)) > angle) {
        runs.emplace_back(std::move(run));
        run.clear();
      }
    }
    run.push_back(segment);
  }
  if (!run.empty()) runs.emplace_back(std::move(run));
  return runs;
}

bool close_gap(std::vector<Segment>& segments, double distance) {
  if (segments.empty()) return false;
  const Vec2 start = value(segments.front(), 0.0);
  if ((value(segments.back(), 1.0) - start).norm() > distance) return false;
  if (segments.size() > 1 && arc_length(segments.back(), 0.0, 1.0) < distance) segments.pop_back();
  if (auto* last = std::get_if<Bezier>(&segments.back())) {
    last->control[2] += start - last->control[3];
    last->control[3] = start;
  }
  return segments.size() > 1 || arc_length(segments.back(), 0.0, 1.0) > distance;
}

double area_of(const Curve& curve) {
  return signed_area({{"", curve}});
}

}  // namespace toile::pattern
