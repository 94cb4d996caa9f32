// What the panels of a pattern are on the wearer, from where its file places them.
#pragma once

#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::dress {

using body::Vec3;

constexpr double infinite = std::numeric_limits<double>::max();

/// A panel in space: x to the wearer's left, y up, z to the front; mm.
struct Part {
  int panel = 0;       ///< index into the pattern
  bool front = true;   ///< in front of the wearer, or behind
  int side = 0;        ///< 0: of the trunk; 1, -1: of the left or of the right sleeve
  bool whole = false;  ///< a sleeve of one panel, which goes round the arm
};

/// Points of an edge in space, its ends included.
std::vector<Vec3> points_of(const pattern::Panel& panel, const pattern::Curve& curve);
/// Points of the outline in space, in order.
std::vector<Vec3> outline_of(const pattern::Panel& panel);

/// Which edges are sewn to which panels, by "panel.edge".
class Sewing {
 public:
  explicit Sewing(const pattern::Pattern& pattern);
  /// Names of the panels that an edge is sewn to; none: it is free.
  std::set<std::string> partners(const pattern::Panel& panel, const pattern::Edge& edge) const;

 private:
  std::map<std::string, std::set<std::string>> partners_;
};

/// Throws InputError for panels other than whole sleeves that lie neither in front of the wearer nor behind, or
/// nowhere.
std::vector<Part> parts_of(const pattern::Pattern& pattern);

/// Name of the part of the garment: "trunk", "left sleeve", "right sleeve".
std::string name_of_side(int side);

}  // namespace toile::dress
