#include "girths.hpp"

#include <algorithm>
#include <limits>

#include "text.hpp"
#include "toile/base/error.hpp"

namespace toile::dress {
namespace {

/// How much of the line across `direction` at a distance along it lies in the outline, mm.
double width_at(const std::vector<Vec3>& outline, const Vec3& direction, double along) {
  const Vec3 across(-direction.y(), direction.x(), 0.0);
  std::vector<double> meets;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double from = direction.dot(a) - along, to = direction.dot(b) - along;
    if ((from < 0.0) == (to < 0.0)) continue;
    meets.push_back(across.dot(a + from / (from - to) * (b - a)));
  }
  std::sort(meets.begin(), meets.end());
  double width = 0.0;
  for (std::size_t i = 1; i < meets.size(); i += 2) width += meets[i] - meets[i - 1];
  return width;
}

double garment_girth(const Placed& placed, int side, const Vec3& direction, double along) {
  double girth = 0.0;
  for (const Part& part : placed.parts)
    if (part.side == side) girth += width_at(outline_of(placed.pattern.panels[part.panel]), direction, along);
  return girth;
}

void add_trunk(const Placed& placed, const Wearer& wearer, std::vector<Girth>& girths) {
  constexpr int stations = 12;
  for (int k = 0; k <= stations; ++k) {
    // The ends themselves may be corners.
    const double height = placed.lowest + (0.02 + 0.96 * k / stations) * (placed.underarm - placed.lowest);
    girths.push_back({name_of_side(0), height, garment_girth(placed, 0, Vec3::UnitY(), height), wearer.girth(height)});
  }
}

/// Where all halves of a sleeve are closed to a tube: from the end of the cap to the nearest end of the cuff.
std::pair<double, double> tube_of(const Placed& placed, int side, const SleeveShape& shape) {
  const Sewing sewing(placed.pattern);
  double from = -infinite, to = infinite;
  for (const Part& part : placed.parts) {
    if (part.side != side) continue;
    const pattern::Panel& panel = placed.pattern.panels[part.panel];
    for (const pattern::Edge& edge : panel.outline) {
      const std::set<std::string> partners = sewing.partners(panel, edge);
      const bool cap = std::any_of(partners.begin(), partners.end(), [&](const std::string& name) {
        return std::any_of(placed.parts.begin(), placed.parts.end(), [&](const Part& other) {
          return other.side != side && placed.pattern.panels[other.panel].name == name;
        });
      });
      for (const Vec3& at : points_of(panel, edge.curve)) {
        const double along = shape.direction.dot(at - shape.top);
        if (cap) from = std::max(from, along);
        if (partners.empty()) to = std::min(to, along);
      }
    }
  }
  return {from, to};
}

void add_sleeve(const Placed& placed, const Wearer& wearer, int side, std::vector<Girth>& girths) {
  const SleeveShape shape = shape_of_sleeve(placed, side);
  const Arm arm = wearer.arm(side);
  const auto [from, to] = tube_of(placed, side, shape);
  constexpr int stations = 6;
  for (int k = 0; k <= stations && from < to; ++k) {
    const double along = from + (0.02 + 0.96 * k / stations) * (to - from);
    girths.push_back({name_of_side(side), along,
                      garment_girth(placed, side, shape.direction, shape.direction.dot(shape.top) + along),
                      wearer.girth(arm, along)});
  }
}

/// The body has nothing at the heights of the garment.
[[noreturn]] void fail_beside(const std::vector<Girth>& girths) {
  std::string text = "the body is not where the pattern is: nothing of it is between the hem and the armholes";
  double lowest = std::numeric_limits<double>::max(), highest = -lowest, widest = 0.0;
  for (const Girth& girth : girths) {
    if (girth.of != name_of_side(0)) continue;
    lowest = std::min(lowest, girth.at);
    highest = std::max(highest, girth.at);
    widest = std::max(widest, girth.garment);
  }
  if (highest > lowest)
    text += ", at heights of " + decimals(lowest, 0) + " to " + decimals(highest, 0) +
            " mm: a body's trunk counts up to its armpits. The garment measures " + decimals(widest, 0) +
            " mm round at most: is it too small or too short (its unit, --scale), or is --hem too high or too low?";
  throw base::InputError(text);
}

}  // namespace

std::vector<Girth> girths_of(const Placed& placed, const Wearer& wearer) {
  std::vector<Girth> girths;
  add_trunk(placed, wearer, girths);
  for (const int side : {1, -1})
    if (std::any_of(placed.parts.begin(), placed.parts.end(), [&](const Part& part) { return part.side == side; }))
      add_sleeve(placed, wearer, side, girths);
  return girths;
}

Girth tightest_of(const std::vector<Girth>& girths) {
  const Girth* tightest = nullptr;
  for (const Girth& girth : girths)
    if (girth.body > 0.0 && girth.garment > 0.0 && (tightest == nullptr || girth.stretch() > tightest->stretch()))
      tightest = &girth;
  if (tightest == nullptr) fail_beside(girths);
  return *tightest;
}

}  // namespace toile::dress
