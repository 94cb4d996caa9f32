#include "toile/criteria/polyconvexity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constants.hpp"
#include "random_states.hpp"

namespace toile::criteria {
namespace {

constexpr int turns = 12;

using Gradient = std::array<double, 4>;  // F11, F12, F21, F22

struct Sampled {
  Gradient F;
  double W;
};

double determinant(const Gradient& F) {
  return F[0] * F[3] - F[1] * F[2];
}

/// Upper triangular F of C.
Gradient upper_triangular(const Strain& C) {
  const double wale = std::sqrt(C[0]), shear = C[2] / wale;
  return {wale, shear, 0.0, std::sqrt(C[1] - shear * shear)};
}

Gradient rotated(const Gradient& F, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * F[0] - s * F[2], c * F[1] - s * F[3], s * F[0] + c * F[2], s * F[1] + c * F[3]};
}

/// P = F S.
Gradient nominal_stress(const Gradient& F, const std::array<double, 3>& S) {
  return {F[0] * S[0] + F[1] * S[2], F[0] * S[2] + F[1] * S[1], F[2] * S[0] + F[3] * S[2], F[2] * S[2] + F[3] * S[1]};
}

std::vector<Sampled> all_turned(const Fabric& fabric, const std::vector<MapPoint>& map) {
  std::vector<Strain> mirrored;
  std::vector<Sampled> base, all;
  for (const MapPoint& p : map) {
    if (!p.state.admissible()) continue;
    base.push_back({{p.wale, p.shear, 0.0, p.course}, p.state.W});
    if (p.shear != 0.0) mirrored.push_back(strain_of(p.wale, p.course, -p.shear));
  }
  for (const Outputs& s : fabric.evaluate(mirrored))
    if (s.admissible()) base.push_back({upper_triangular(s.C), s.W});
  for (const Sampled& one : base)
    for (int k = 0; k < turns; ++k) all.push_back({rotated(one.F, 2.0 * pi * k / turns), one.W});
  return all;
}

/// Whether the bounds of all `samples` on the slope a at F0 contradict each other.
bool is_refuted(const Outputs& s, const std::vector<Sampled>& samples) {
  const Gradient F0 = upper_triangular(s.C), P = nominal_stress(F0, s.S);
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;
  for (const Sampled& other : samples) {
    Gradient step;
    double excess = other.W - s.W, size = std::abs(other.W) + std::abs(s.W);
    for (int i = 0; i < 4; ++i) {
      step[i] = other.F[i] - F0[i];
      excess -= P[i] * step[i];
      size += std::abs(P[i] * step[i]);
    }
    // Rounding must not refute.
    excess += 1e-12 * size;
    const double det = determinant(step),
                 length = step[0] * step[0] + step[1] * step[1] + step[2] * step[2] + step[3] * step[3];
    if (std::abs(det) <= 1e-12 * length) {
      if (excess < 0.0) return true;
    } else if (det > 0.0) {
      upper = std::min(upper, excess / det);
    } else {
      lower = std::max(lower, excess / det);
    }
  }
  return lower > upper;
}

}  // namespace

Polyconvexity polyconvexity(const Fabric& fabric, const Request& request, const std::vector<MapPoint>& map, int n) {
  const std::vector<Sampled> samples = all_turned(fabric, map);
  Polyconvexity result;
  for (const MapPoint& p : map) {
    if (!p.state.admissible()) continue;
    ++result.mapped;
    if (!p.elliptic && result.not_elliptic++ == 0) result.at = p.state.C;
  }
  for (const Outputs& s : fabric.evaluate(random_states(request, n))) {
    if (!s.admissible()) continue;
    const bool tensile = s.tensile();
    ++result.states;
    result.tensile += tensile ? 1 : 0;
    if (!is_refuted(s, samples)) continue;
    if (result.refuted++ == 0) result.at = s.C;
    result.tensile_refuted += tensile ? 1 : 0;
  }
  return result;
}

Finding polyconvexity_finding(const Polyconvexity& result) {
  const std::string tried =
      std::to_string(result.mapped) + " states by ellipticity and " + std::to_string(result.states) + " by pairs";
  if (!result.is_refuted())
    return {name::polyconvex, Verdict::undecided,
            "not decided: nothing contradicts it (" + tried + "), which is no proof"};
  return {name::polyconvex, Verdict::fails,
          "refuted in the plane of the fabric: not elliptic in " + std::to_string(result.not_elliptic) + " of " +
              std::to_string(result.mapped) + " states, contradicted by pairs at " + std::to_string(result.refuted) +
              " of " + std::to_string(result.states) + " (in tension " + std::to_string(result.tensile_refuted) +
              " of " + std::to_string(result.tensile) + "), for instance at " + place(result.at)};
}

}  // namespace toile::criteria
