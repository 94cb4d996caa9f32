#include <algorithm>

#include "placement.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

/// mm: three cells of a coarse body, because the smooth surface is less accurate beside a cut, and what a garment
/// slides.
constexpr double margin = 50.0;

bool is_same_axis(const body::Region& a, const body::Region& b) {
  const body::Vec3 between = *b.seed - *a.seed;
  return (a.direction - b.direction).norm() < 1e-6 &&
         (between - between.dot(a.direction) * a.direction).norm() < 1e-3 * (1.0 + between.norm());
}

}  // namespace

std::optional<body::Region> reach_of(const base::List& panels) {
  std::optional<body::Region> all;
  for (const base::List& panel : panels.entries()) {
    if (!panel.has_list("Placement")) return std::nullopt;
    const base::List list = panel.list("Placement");
    const Placement& placement = placement_of(list);
    if (placement.reach == nullptr) return std::nullopt;
    const std::optional<body::Region> one = placement.reach(list);
    if (!one) return std::nullopt;
    if (!all) all = one;
    if (!is_same_axis(*all, *one)) return std::nullopt;
    all->bottom = std::min(all->bottom, one->bottom);
    all->top = std::max(all->top, one->top);
  }
  if (all) all->margin = margin;
  return all;
}

}  // namespace toile::garment
