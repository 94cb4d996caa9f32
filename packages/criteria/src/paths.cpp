#include "toile/criteria/paths.hpp"

#include <algorithm>
#include <cmath>

#include "toile/criteria/map.hpp"

namespace toile::criteria {
namespace {

constexpr int steps = 400;

/// Newton on S_free = S12 = 0 in (C_free, C12), halving steps that leave the admissible states or raise the residual.
std::optional<Outputs> relaxed(const Fabric& fabric, Strain C, int free) {
  const auto residual = [&](const Outputs& s) { return std::hypot(s.S[free], s.S[2]); };
  const double to_C = 2.0;
  Outputs s = fabric.evaluate(C);
  if (!s.admissible()) return std::nullopt;
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double scale = std::abs(s.tangent(free, free)) * s.C[free];
    if (residual(s) <= 1e-13 * scale) return s;
    const double a = s.tangent(free, free), b = s.tangent(free, 2), d = s.tangent(2, 2), det = a * d - b * b;
    if (det == 0.0) return std::nullopt;
    const double dE = (-d * s.S[free] + b * s.S[2]) / det, dC12 = (b * s.S[free] - a * s.S[2]) / det;
    bool improved = false;
    for (double part = 1.0; part > 1e-6 && !improved; part *= 0.5) {
      Strain next = s.C;
      next[free] += part * to_C * dE;
      next[2] += part * dC12;
      const Outputs trial = fabric.evaluate(next);
      if (!trial.admissible() || !(residual(trial) < residual(s))) continue;
      s = trial;
      improved = true;
    }
    if (!improved) return residual(s) <= 1e-9 * scale ? std::optional<Outputs>(s) : std::nullopt;
  }
  return std::nullopt;
}

/// Nominal stress along the stretched axes: dW/dl of the path.
double force(const Outputs& s, const Path& path, double stretch) {
  return stretch * ((path.wale ? s.S[0] : 0.0) + (path.course ? s.S[1] : 0.0));
}

struct Sample {
  double stretch, force;
  MapPoint point;
  bool extrapolated;
};

std::optional<Sample> sample(const Fabric& fabric, const Path& path, double stretch, const Strain& guess) {
  const auto s = state_on(fabric, path, stretch, guess);
  if (!s) return std::nullopt;
  return Sample{stretch, force(*s, path, stretch), map_point(std::sqrt(s->C[0]), std::sqrt(s->C[1]), 0.0, *s),
                s->status == material::point_extrapolated};
}

/// Stretch between `good` and `bad` where `lost` turns true.
template <class Lost>
double bisected(const Fabric& fabric, const Path& path, Sample good, double bad, Lost lost) {
  while (std::abs(bad - good.stretch) > 1e-6) {
    const double middle = 0.5 * (good.stretch + bad);
    const auto at = sample(fabric, path, middle, good.point.state.C);
    if (!at || lost(*at)) {
      bad = middle;
    } else {
      good = *at;
    }
  }
  return bad;
}

}  // namespace

std::vector<Path> paths() {
  return {{"uniaxial wale", true, false, true},
          {"uniaxial course", false, true, true},
          {"strip wale", true, false, false},
          {"strip course", false, true, false},
          {"equibiaxial", true, true, false}};
}

std::optional<Outputs> state_on(const Fabric& fabric, const Path& path, double stretch, const Strain& guess) {
  const double squared = stretch * stretch;
  Strain C = {path.wale ? squared : 1.0, path.course ? squared : 1.0, 0.0};
  if (path.free) {
    const int free = path.wale ? 1 : 0;
    C[free] = guess[free];
    C[2] = guess[2];
    return relaxed(fabric, C, free);
  }
  const Outputs s = fabric.evaluate(C);
  return s.admissible() ? std::optional<Outputs>(s) : std::nullopt;
}

Losses losses(const Fabric& fabric, const Path& path, double end) {
  const auto not_elliptic = [](const Sample& s) { return !s.point.elliptic; };
  const auto not_convex = [](const Sample& s) { return !s.point.convex; };
  const auto outside = [](const Sample& s) { return s.extrapolated; };
  Losses found;
  auto before = sample(fabric, path, 1.0, {1.0, 1.0, 0.0});
  if (!before) {
    found.state = 1.0;
    return found;
  }
  for (int i = 1; i <= steps; ++i) {
    const double stretch = 1.0 + (end - 1.0) * i / steps;
    const auto now = sample(fabric, path, stretch, before->point.state.C);
    if (!now) {
      found.state = bisected(fabric, path, *before, stretch, [](const Sample&) { return false; });
      return found;
    }
    const auto note = [&](std::optional<double>& place, const auto& lost) {
      if (!place && lost(*now))
        place = lost(*before) ? before->stretch : bisected(fabric, path, *before, stretch, lost);
    };
    note(found.ellipticity, not_elliptic);
    note(found.convexity, not_convex);
    note(found.range, outside);
    if (!found.force && (now->force - before->force) * (end - 1.0) <= 0.0) found.force = before->stretch;
    before = now;
  }
  return found;
}

std::vector<Finding> path_findings(const Fabric& fabric, const Request& request) {
  std::vector<Finding> findings;
  for (const Path& path : paths()) {
    const double high =
        path.wale ? path.course ? std::min(request.wale[1], request.course[1]) : request.wale[1] : request.course[1];
    const double low =
        path.wale ? path.course ? std::max(request.wale[0], request.course[0]) : request.wale[0] : request.course[0];
    std::string text;
    for (double end : {high, low}) {
      if (end == high ? high <= 1.0 : low >= 1.0) continue;
      const Losses lost = losses(fabric, path, end);
      std::string told;
      const auto tell = [&](const char* what, const std::optional<double>& at) {
        if (at) told += std::string(told.empty() ? "" : ", ") + what + " " + figure(*at);
      };
      tell("ellipticity lost at", lost.ellipticity);
      tell("convexity lost at", lost.convexity);
      tell("force turns at", lost.force);
      tell("calibrated to", lost.range);
      tell("no state from", lost.state);
      text += std::string(text.empty() ? "" : "; ") + (end > 1.0 ? "up to " : "down to ") + figure(end) + ": " +
              (told.empty() ? "kept" : told);
    }
    if (!text.empty()) findings.push_back({std::string("path ") + path.name, Verdict::reported, text});
  }
  return findings;
}

}  // namespace toile::criteria
