#include <algorithm>
#include <cmath>

#include "toile/criteria/map.hpp"

namespace toile::criteria {
namespace {

std::string place(const MapPoint& p) {
  return criteria::place(p.wale, p.course, p.shear);
}

/// How often `lost` is true among the points that `counts` picks, and the one of them nearest to C = I.
template <class Counts, class Lost>
Finding loss(const std::vector<MapPoint>& map, const char* criterion, Verdict if_lost, Verdict if_kept, Counts counts,
             Lost lost) {
  int tried = 0, bad = 0;
  const MapPoint* first = nullptr;
  const auto distance = [](const MapPoint& p) { return std::hypot(std::log(p.wale), std::log(p.course), p.shear); };
  for (const MapPoint& p : map) {
    if (!p.state.admissible() || !counts(p)) continue;
    ++tried;
    if (!lost(p)) continue;
    ++bad;
    if (first == nullptr || distance(p) < distance(*first)) first = &p;
  }
  const std::string of = " of " + std::to_string(tried) + " states";
  if (tried == 0) return {criterion, Verdict::undecided, "the box holds no such state"};
  if (bad == 0) return {criterion, if_kept, "kept in all" + of};
  return {criterion, if_lost, "lost in " + std::to_string(bad) + of + ", nearest at " + place(*first)};
}

Finding validity(const std::vector<MapPoint>& map) {
  int refused = 0, extrapolated = 0;
  double least = 0.0, lost = 0.0;
  for (const MapPoint& p : map) {
    if (!p.state.admissible()) {
      ++refused;
      continue;
    }
    if (p.state.status == material::point_extrapolated) ++extrapolated;
    if (p.state.W < least) {
      least = p.state.W;
      lost = 1.0;
    }
  }
  std::string text = std::to_string(map.size()) + " states: " + std::to_string(extrapolated) +
                     " outside the calibrated range, " + std::to_string(refused) + " not admissible";
  if (lost > 0.0) text += "; W is negative down to " + figure(least) + " MPa";
  return {"range of validity", Verdict::reported, text};
}

Finding conditioning(const std::vector<MapPoint>& map) {
  const MapPoint *worst = nullptr, *in_tension = nullptr;
  int indefinite = 0;
  for (const MapPoint& p : map) {
    if (!p.state.admissible()) continue;
    if (!p.tangent_positive) ++indefinite;
    if (worst == nullptr || p.condition > worst->condition) worst = &p;
    if (p.tensile && (in_tension == nullptr || p.condition > in_tension->condition)) in_tension = &p;
  }
  if (worst == nullptr) return {"conditioning", Verdict::undecided, "no admissible state"};
  std::string text = "of the tangent D at most " + figure(worst->condition, 3) + " at " + place(*worst);
  if (in_tension != nullptr) text += "; in tension " + figure(in_tension->condition, 3) + " at " + place(*in_tension);
  if (indefinite > 0) text += "; D is not positive definite in " + std::to_string(indefinite) + " states";
  return {"conditioning", Verdict::reported, text};
}

}  // namespace

std::vector<Finding> judge(const std::vector<MapPoint>& map) {
  const auto tensile = [](const MapPoint& p) { return p.tensile; };
  const auto any = [](const MapPoint&) { return true; };
  const auto elliptic_lost = [](const MapPoint& p) { return !p.elliptic; };
  const auto convex_lost = [](const MapPoint& p) { return !p.convex; };
  const Verdict fails = Verdict::fails, holds = Verdict::holds;
  return {loss(map, name::elliptic_tension, fails, holds, tensile, elliptic_lost),
          loss(map, name::convex_tension, fails, holds, tensile, convex_lost),
          loss(map, name::elliptic, fails, holds, any, elliptic_lost),
          loss(map, name::convex, fails, holds, any, convex_lost),
          validity(map),
          conditioning(map)};
}

}  // namespace toile::criteria
