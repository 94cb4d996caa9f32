#include "parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::dress {
namespace {

using pattern::Panel;

/// Parts of sleeves are further than this from the middle of the wearer, mm.
constexpr double middle = 100.0;

Eigen::AlignedBox3d box_of(const Panel& panel) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : outline_of(panel)) box.extend(point);
  return box;
}

double depth_of(const Panel& panel) {
  return box_of(panel).center().z();
}

/// 0 if it comes near the middle of the wearer.
int side_of(const Panel& panel) {
  const Eigen::AlignedBox3d box = box_of(panel);
  return box.min().x() > middle ? 1 : box.max().x() < -middle ? -1 : 0;
}

void check_placed(const Panel& panel) {
  if (panel.placement) return;
  throw base::InputError("panel \"" + panel.name +
                         "\" is not placed in space, so that front and back cannot be told from each other; files of "
                         "Garment-Pattern-Generator and GarmentCode (JSON) place their panels (\"translation\", "
                         "\"rotation\": y up, z to the front)");
}

void check_flat(const Panel& panel) {
  if (std::abs(panel.placement->rotation(2, 2)) > 0.9) return;
  throw base::InputError("panel \"" + panel.name +
                         "\" lies across the front of the wearer (its \"rotation\" turns it out of the x-y plane); "
                         "panels in front of the wearer and behind are dressed, and sleeves of one panel, whose own "
                         "edges are sewn to each other under the arm");
}

}  // namespace

std::vector<Vec3> points_of(const Panel& panel, const pattern::Curve& curve) {
  std::vector<Vec3> points;
  for (const pattern::Vec2& at : curve.points(0.5))
    points.push_back(panel.placement->rotation * Vec3(at.x(), at.y(), 0.0) + panel.placement->translation);
  return points;
}

std::vector<Vec3> outline_of(const Panel& panel) {
  std::vector<Vec3> outline;
  for (const pattern::Edge& edge : panel.outline) {
    const std::vector<Vec3> points = points_of(panel, edge.curve);
    outline.insert(outline.end(), points.begin(), points.end() - 1);
  }
  return outline;
}

Sewing::Sewing(const pattern::Pattern& pattern) {
  const auto key = [](const pattern::Side& side) { return side.panel->name + "." + side.part.edge->name; };
  for (const pattern::Stitch& stitch : pattern.stitches) {
    const pattern::Side first = find_side(pattern, stitch.first), second = find_side(pattern, stitch.second);
    partners_[key(first)].insert(second.panel->name);
    partners_[key(second)].insert(first.panel->name);
  }
}

std::set<std::string> Sewing::partners(const Panel& panel, const pattern::Edge& edge) const {
  const auto known = partners_.find(panel.name + "." + edge.name);
  return known == partners_.end() ? std::set<std::string>() : known->second;
}

namespace {

/// A sleeve of one panel is closed under the arm.
bool is_sewn_to_itself(const Sewing& sewing, const Panel& panel) {
  return std::any_of(panel.outline.begin(), panel.outline.end(),
                     [&](const pattern::Edge& edge) { return sewing.partners(panel, edge).count(panel.name) > 0; });
}

}  // namespace

std::vector<Part> parts_of(const pattern::Pattern& pattern) {
  double lower = infinite, upper = -infinite;
  for (const Panel& panel : pattern.panels) {
    check_placed(panel);
    lower = std::min(lower, depth_of(panel));
    upper = std::max(upper, depth_of(panel));
  }
  std::vector<Part> parts;
  const Sewing sewing(pattern);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const Panel& panel = pattern.panels[p];
    parts.push_back({static_cast<int>(p), 2.0 * depth_of(panel) > lower + upper, side_of(panel)});
    parts.back().whole = parts.back().side != 0 && is_sewn_to_itself(sewing, panel);
    if (!parts.back().whole) check_flat(panel);
  }
  for (const bool front : {true, false})
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const Part& part) { return part.side == 0 && part.front == front; }))
      throw base::InputError(std::string("no panel lies ") + (front ? "in front of" : "behind") +
                             " the trunk of the wearer (\"translation\": y up, z to the front, x = 0 in the middle); a "
                             "garment is dressed from panels in front and behind");
  return parts;
}

std::string name_of_side(int side) {
  return side == 0 ? "trunk" : side > 0 ? "left sleeve" : "right sleeve";
}

}  // namespace toile::dress
