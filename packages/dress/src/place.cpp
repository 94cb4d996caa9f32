#include "place.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scaled.hpp"
#include "toile/base/error.hpp"

namespace toile::dress {
namespace {

using pattern::Panel;

class Placing {
 public:
  Placing(const pattern::Pattern& pattern, const Wearer& wearer) : wearer_(wearer), sewing_(pattern) {
    placed_.pattern = pattern;
    placed_.parts = parts_of(pattern);
  }

  Placed run(const Options& options) {
    find_extents();
    move({wearer_.middle() - 0.5 * (least_x_ + most_x_), height(options) - placed_.lowest, 0.0});
    find_extents();
    for (const Part& part : placed_.parts)
      if (part.whole) lay_flat(part);
    for (const int side : {1, -1})
      if (has(side)) turn_sleeve(side);
    move_clear_of_body();
    for (const Part& part : placed_.parts)
      if (part.whole) wrap(part);
    return placed_;
  }

 private:
  Panel& panel(const Part& part) { return placed_.pattern.panels[part.panel]; }
  bool has(int side) const {
    return std::any_of(placed_.parts.begin(), placed_.parts.end(), [&](const Part& p) { return p.side == side; });
  }
  void move(const Vec3& by) {
    for (Panel& panel : placed_.pattern.panels) panel.placement->translation += by;
  }

  /// Heights of the trunk, its hems, and how wide it is.
  void find_extents() {
    placed_.lowest = placed_.underarm = least_x_ = infinite;
    placed_.highest = most_x_ = -infinite;
    placed_.hems.clear();
    each_trunk_edge([&](const Panel&, const pattern::Edge&, const std::vector<Vec3>& points) {
      for (const Vec3& at : points) {
        placed_.lowest = std::min(placed_.lowest, at.y());
        placed_.highest = std::max(placed_.highest, at.y());
        least_x_ = std::min(least_x_, at.x());
        most_x_ = std::max(most_x_, at.x());
      }
    });
    const double near_hem = placed_.lowest + 0.15 * (placed_.highest - placed_.lowest);
    each_trunk_edge([&](const Panel& panel, const pattern::Edge& edge, const std::vector<Vec3>& points) {
      double lowest = infinite, highest = -infinite;
      for (const Vec3& at : points) {
        lowest = std::min(lowest, at.y());
        highest = std::max(highest, at.y());
      }
      const std::set<std::string> partners = sewing_.partners(panel, edge);
      if (partners.empty() && highest < near_hem)
        placed_.hems.push_back(panel.name + "." + edge.name);
      else if (partners.empty() || joins_sleeve(partners)) {
        if (lowest < near_hem)
          throw base::InputError("edge \"" + panel.name + "." + edge.name +
                                 "\" goes up from the hem and no stitch "
                                 "sews it to the trunk: the trunk must be a tube there. Is a stitch missing?");
        placed_.underarm = std::min(placed_.underarm, lowest);
      }
    });
    placed_.underarm = std::min(placed_.underarm, placed_.highest);
  }

  template <class Use>
  void each_trunk_edge(const Use& use) {
    for (const Part& part : placed_.parts)
      if (part.side == 0)
        for (const pattern::Edge& edge : panel(part).outline)
          use(panel(part), edge, points_of(panel(part), edge.curve));
  }

  const Part* part_of(const std::string& name) const {
    for (const Part& part : placed_.parts)
      if (placed_.pattern.panels[part.panel].name == name) return &part;
    return nullptr;
  }
  bool joins_sleeve(const std::set<std::string>& partners) const {
    return std::any_of(partners.begin(), partners.end(),
                       [&](const std::string& name) { return part_of(name)->side != 0; });
  }

  /// Points of the seams that join front and back on the shoulders.
  std::vector<Vec3> shoulder_seams() {
    std::vector<Vec3> seams;
    each_trunk_edge([&](const Panel& panel, const pattern::Edge& edge, const std::vector<Vec3>& points) {
      const Vec3 along = points.back() - points.front();
      const bool lies = std::abs(along.x()) > std::abs(along.y());
      const bool up = points.front().y() > 0.5 * (placed_.lowest + placed_.highest);
      const bool front = part_of(panel.name)->front;
      for (const std::string& name : sewing_.partners(panel, edge))
        if (lies && up && part_of(name)->side == 0 && part_of(name)->front != front)
          for (int k = 0; k <= 8; ++k) seams.push_back(points.front() + k / 8.0 * along);
    });
    return seams;
  }

  /// Of the lowest point of the trunk.
  double height(const Options& options) {
    if (options.hem) return *options.hem;
    std::vector<Vec3> seams = shoulder_seams();
    if (seams.empty())
      throw base::InputError(
          "no seam joins front and back on the shoulders, so that nothing says how high the garment starts; give the "
          "height of its lowest point by --hem, in mm above the zero of the body's file");
    const double shift = wearer_.middle() - 0.5 * (least_x_ + most_x_);
    // The neck and the head are no shoulders.
    const double tip = wearer_.shoulder().value_or(0.0);
    double lift = -infinite, at = 0.0;
    for (const bool outer : {true, false}) {
      for (const Vec3& seam : seams) {
        const double x = seam.x() + shift;
        if (outer && std::abs(x - wearer_.middle()) < 0.6 * tip) continue;
        const std::optional<double> top = wearer_.top(x);
        if (!top || *top - seam.y() <= lift) continue;
        lift = *top - seam.y();
        at = x;
      }
      if (lift > -infinite) break;
    }
    if (lift == -infinite)
      throw base::InputError("the body is not below the shoulder seams of the pattern; check the units of both");
    const double armhole = placed_.underarm + lift;
    return placed_.lowest + lift + std::max(wearer_.detour(at, armhole, true), wearer_.detour(at, armhole, false));
  }

  /// Turns a sleeve about the highest point of its cap towards the arm, and moves it to where it is sewn to the trunk.
  void turn_sleeve(int side) {
    const Arm arm = wearer_.arm(side);
    const SleeveShape shape = shape_of_sleeve(placed_, side);
    const Vec3 to = Vec3(arm.direction.x(), arm.direction.y(), 0.0).normalized();
    const double angle = std::atan2(shape.direction.x() * to.y() - shape.direction.y() * to.x(),
                                    shape.direction.x() * to.x() + shape.direction.y() * to.y());
    // All the way, the underarm seam would start in front of the chest; not at all, above the arm.
    constexpr double part_of_turn = 0.6;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(part_of_turn * angle, Vec3::UnitZ()).toRotationMatrix();
    Vec3 tip(0.0, -infinite, 0.0);
    each_trunk_edge([&](const Panel& of, const pattern::Edge& edge, const std::vector<Vec3>& points) {
      for (const std::string& name : sewing_.partners(of, edge))
        if (part_of(name)->side == side)
          for (const Vec3& at : points)
            if (at.y() > tip.y()) tip = at;
    });
    // The trunk starts higher than it ends, by its way over bust and back; the sleeve starts where the arm is.
    constexpr double clearance = 10.0;  // mm
    if (const std::optional<double> top = wearer_.top(tip.x())) tip.y() = std::min(tip.y(), *top + clearance);
    const Vec3 target = tip + clearance * to;
    for (const Part& part : placed_.parts) {
      if (part.side != side) continue;
      pattern::Placement& placement = *panel(part).placement;
      Vec3 pivot = shape.top;
      pivot.z() = placement.translation.z();
      Vec3 moved = target;
      moved.z() = pivot.z();
      placement.translation = moved + turn * (placement.translation - pivot);
      placement.rotation = turn * placement.rotation;
    }
  }

  /// Cap upwards in the pattern, and in front of the wearer along the arm, so that it compares with the arm as a half
  /// does.
  void lay_flat(const Part& part) {
    Panel& sleeve = panel(part);
    sleeve.placement->rotation.setIdentity();
    const Vec3 down = shape_of_sleeve(placed_, part.side).direction;
    turn(sleeve, std::atan2(-down.x(), -down.y()));
    const Vec3 arm = wearer_.arm(part.side).direction;
    sleeve.placement->rotation = Eigen::AngleAxisd(std::atan2(arm.x(), -arm.y()), Vec3::UnitZ()).toRotationMatrix();
  }

  /// Round the arm, with room for it.
  void wrap(const Part& part) {
    constexpr double below = 300.0, beyond = 20.0, room = 10.0, open = 1.15;  // mm; of the width
    Eigen::AlignedBox2d box;
    for (const pattern::Edge& edge : panel(part).outline)
      for (const pattern::Vec2& at : edge.curve.points(0.5)) box.extend(at);
    const Arm arm = wearer_.arm(part.side);
    const Vec3 up = Vec3::UnitY() - Vec3::UnitY().dot(arm.direction) * arm.direction;
    Wrap wrap;
    wrap.panel = panel(part).name;
    wrap.top = Wearer::in_space(arm.shoulder);
    wrap.bottom = Wearer::in_space(arm.shoulder + below * arm.direction);
    wrap.zero = Wearer::in_space(up.normalized());
    wrap.to = below + beyond;
    wrap.from = wrap.to - box.sizes().y();
    const double girth = std::max(wearer_.girth(arm, 0.5 * box.sizes().y()), wearer_.girth(arm, box.sizes().y()));
    wrap.radius = std::max(girth / (2.0 * M_PI) + room, open * box.sizes().x() / (2.0 * M_PI));
    placed_.wraps.push_back(wrap);
  }

  /// All of the trunk's front in one plane, and so on.
  void move_clear_of_body() {
    constexpr double clearance = 15.0, beside = 10.0;  // mm
    for (const int side : {0, 1, -1})
      for (const bool front : {true, false}) {
        double plane = -infinite;
        for (const Part& part : placed_.parts) {
          if (part.side != side || part.front != front) continue;
          Vec3 lower = Vec3::Constant(infinite), upper = -lower;
          for (const Vec3& at : outline_of(panel(part))) {
            lower = lower.cwiseMin(at);
            upper = upper.cwiseMax(at);
          }
          const Vec3 more = Vec3::Constant(beside);
          const std::optional<double> depth = wearer_.depth(lower - more, upper + more, front);
          if (depth) plane = std::max(plane, front ? *depth : -*depth);
        }
        if (plane == -infinite) continue;
        const double to = (front ? 1.0 : -1.0) * (plane + clearance);
        for (const Part& part : placed_.parts)
          if (part.side == side && part.front == front)
            panel(part).placement->translation.z() += to - outline_of(panel(part)).front().z();
      }
  }

  const Wearer& wearer_;
  Sewing sewing_;
  Placed placed_;
  double least_x_ = 0.0, most_x_ = 0.0;
};

}  // namespace

Placed place(const pattern::Pattern& pattern, const Wearer& wearer, const Options& options) {
  return Placing(pattern, wearer).run(options);
}

SleeveShape shape_of_sleeve(const Placed& placed, int side) {
  const Sewing sewing(placed.pattern);
  const auto of_trunk = [&](const std::string& name) {
    return std::any_of(placed.parts.begin(), placed.parts.end(), [&](const Part& part) {
      return part.side == 0 && placed.pattern.panels[part.panel].name == name;
    });
  };
  Vec3 cap = Vec3::Zero(), cuff = Vec3::Zero(), top(0.0, -infinite, 0.0);
  int caps = 0, cuffs = 0;
  for (const Part& part : placed.parts) {
    if (part.side != side) continue;
    const Panel& panel = placed.pattern.panels[part.panel];
    for (const pattern::Edge& edge : panel.outline) {
      const std::vector<Vec3> points = points_of(panel, edge.curve);
      const Vec3 ends = points.front() + points.back();
      const std::set<std::string> partners = sewing.partners(panel, edge);
      if (partners.empty()) {
        cuff += 0.5 * ends;
        ++cuffs;
      } else if (std::any_of(partners.begin(), partners.end(), of_trunk)) {
        cap += 0.5 * ends;
        ++caps;
        for (const Vec3& at : points)
          if (at.y() > top.y()) top = at;
      }
    }
  }
  if (caps == 0)
    throw base::InputError("no stitch sews the " + name_of_side(side) +
                           " (panels that are more than 100 mm from the middle) to a panel of the trunk");
  if (cuffs == 0) throw base::InputError("the " + name_of_side(side) + " is closed: it has no edge without a stitch");
  Vec3 direction = cuff / cuffs - cap / caps;
  direction.z() = 0.0;
  return {top, direction.normalized()};
}

}  // namespace toile::dress
