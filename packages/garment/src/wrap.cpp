#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "body_end.hpp"
#include "limb_axis.hpp"
#include "placement.hpp"
#include "toile/base/error.hpp"
#include "wrap_places.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;

base::Spec add_wrap_parameters(base::Spec spec) {
  return add_axis_parameters(spec)
      .real("from", "mm", "Height along the axis of the panel's lowest point, or a landmark of the body (waist - 20).")
      .real("to", "mm", "Height along the axis of the panel's highest point, or a landmark.")
      .choice("rows",
              "as drawn: heights follow the pattern's y, so a curved hem or neckline stays curved; level: each row of "
              "elements lies at one height, as the curved hem of a skirt's gore or of a part of a ring is to hang.",
              {"as drawn", "level"}, std::string("as drawn"))
      .choice("width",
              "What the coverage and the centre line belong to. each height: the pattern's width there; whole: its "
              "greatest width, for a panel with an armhole, which is to stay open.",
              {"each height", "whole"}, std::string("each height"))
      .real("angle", "deg",
            "Where the panel's centre line lies: its part of the girth, 360 being once round, counter-clockwise seen "
            "from the top of the axis. Two panels of coverage 1/2 at 0 and 180 meet on any section.",
            0.0)
      .real("coverage", "",
            "Part of the girth that the panel covers at every level, so that the hoop stretch is uniform there; 0: the "
            "width of the pattern itself (unstretched).",
            0.0, base::Range::between(0.0, 1.0));
}

/// The surface that a panel is wrapped onto, seen from the axis.
struct Target {
  std::function<Section(const Axis&, double height)> section;
  /// Radius of the section at one angle, mm.
  std::function<double(const Axis&, double height, double angle)> radius;
  /// Outward unit normal at a place given by its angle and its position.
  std::function<Vec3(double height, double angle, const Vec3& position)> normal;
};

/// Puts nodes onto the target, with the sections made when they are first asked for.
class Wrapping {
 public:
  Wrapping(const base::List& list, const LimbAxis& axis, const Target& target, double spacing)
      : list_(list), axis_(axis), target_(target), spacing_(spacing) {}

  /// A node of a straight row: on the section of its height.
  void add_level(double height, double width, double fraction, mesh::Placed& placed) {
    const Axis frame = axis_.frame(height);
    const double angle = angle_on(section(height), height, width, fraction);
    add(frame, height, angle, section(height).radius(angle), placed);
  }
  /// A node of a curved row: between the two sections nearest to its height.
  void add_between(double height, double width, double fraction, mesh::Placed& placed) {
    const double below = spacing_ * std::floor(height / spacing_), share = (height - below) / spacing_;
    const double first = angle_on(section(below), below, width, fraction);
    const double step = angle_on(section(below + spacing_), below + spacing_, width, fraction) - first;
    const double angle = first + share * std::remainder(step, 2.0 * M_PI);
    const Axis frame = axis_.frame(height);
    add(frame, height, angle, target_.radius(frame, height, angle), placed);
  }

 private:
  const Section& section(double height) {
    const auto made = sections_.find(height);
    if (made != sections_.end()) return made->second;
    return sections_.emplace(height, target_.section(axis_.frame(height), height)).first->second;
  }

  /// `width` of the row, mm; `fraction` of it from the left to the node.
  double angle_on(const Section& section, double height, double width, double fraction) const {
    const double coverage = list_.real("coverage");
    const double covered = coverage > 0.0 ? coverage * section.girth() : width;
    if (covered > section.girth() * (1.0 + 1e-9)) {
      std::ostringstream text;
      text << "the pattern is " << covered << " mm wide at the height " << height << " mm, but the girth there is "
           << section.girth() << " mm: give a \"coverage\" of at most 1, or wrap the panel further away from the axis";
      list_.fail("coverage", text.str());
    }
    const double centre = list_.real("angle") / 360.0 * section.girth();
    if (fraction == 0.0) check_shape(section, height, centre - 0.5 * covered, centre + 0.5 * covered);
    return section.angle_at(centre + covered * (fraction - 0.5));
  }

  /// Refuses a fold of the section in the part that the row covers.
  void check_shape(const Section& section, double height, double from, double to) const {
    const auto fold = section.fold_between(from, to);
    if (!fold) return;
    std::ostringstream text;
    text << "seen from the axis the body's section at the height " << height
         << " mm folds behind itself where the panel lies (its radius jumps from " << fold->before << " to "
         << fold->after << " mm at the angle of " << fold->angle * 180.0 / M_PI
         << " degrees from \"zero direction\"): lay the axis through the middle of the limb and along it, or place a "
            "panel that spans a groove or slit there by \"free wrap\"";
    list_.fail(axis_.parameter(), text.str());
  }

  void add(const Axis& frame, double height, double angle, double radius, mesh::Placed& placed) const {
    placed.position.push_back(frame.at(height) + radius * frame.ray(angle));
    placed.normal.push_back(target_.normal(height, angle, placed.position.back()));
    placed.axis.push_back(frame.direction);
  }

  const base::List& list_;
  const LimbAxis& axis_;
  const Target& target_;
  const double spacing_;
  std::map<double, Section> sections_;  ///< [height]
};

/// Sections of a bent axis must not cross within the body: each line of nodes that rises in the pattern has to rise
/// along the axis.
void check_crossing(const base::List& list, const WrapPlaces& places, const LimbAxis& axis,
                    const mesh::Placed& placed) {
  constexpr double least = 0.02;  // of the way along the axis
  if (!axis.is_bent()) return;
  for (const auto& [a, b] : places.rising) {
    const double rise = places.node[b].height - places.node[a].height;
    const double middle = 0.5 * (places.node[a].height + places.node[b].height);
    const Axis frame = axis.frame(middle);
    if (rise <= 0.0 || (placed.position[b] - placed.position[a]).dot(frame.direction) > least * rise) continue;
    std::ostringstream text;
    const Vec3& at = placed.position[a];
    text << "the sections at the heights " << places.node[a].height << " and " << places.node[b].height
         << " mm cross near (" << at[0] << ", " << at[1] << ", " << at[2]
         << ") mm, at the inner side of a bend: the axis turns there with a radius of "
         << 1.0 / axis.curvature(middle).norm() << " mm, and the body's surface is " << (at - frame.at(middle)).norm()
         << " mm from it. Spread the corner over more of the limb (a larger \"smoothing\", or more points on an arc), "
            "or lay the axis nearer to the inner side";
    list.fail("axis", text.str());
  }
}

/// Puts every node on the target.
mesh::Placed wrap(const base::List& list, const mesh::PanelMesh& flat, const LimbAxis& axis, const Target& target) {
  WrapPlaces places = flat.across > 0 ? places_in_rows(list, flat) : places_by_width(list, flat);
  if (list.word("width") == "whole") widen(flat, places);
  Wrapping wrapping(list, axis, target, places.spacing);
  mesh::Placed placed;
  for (const WrapPlace& place : places.node) {
    if (place.is_level)
      wrapping.add_level(place.height, place.width, place.fraction, placed);
    else
      wrapping.add_between(place.height, place.width, place.fraction, placed);
  }
  check_crossing(list, places, axis, placed);
  return placed;
}

mesh::Placed place_on_body(const base::List& list, const FlatPanel& panel) {
  const body::Surface* body = panel.body;
  if (body == nullptr) list.fail("type", "\"wrap\" needs a body, and the scene has none; \"free wrap\" does not");
  const double offset = list.real("offset");
  const LimbAxis axis(list);
  const auto traced = [&](const Axis& frame, double height, const auto& trace) {
    try {
      return trace();
    } catch (const base::InputError& error) {
      refuse_section(list, *body, frame, height, axis.parameter(), error.what());
    }
  };
  Target target;
  target.section = [&](const Axis& frame, double height) {
    return traced(frame, height, [&] { return trace_section(*body, frame, height, offset); });
  };
  target.radius = [&](const Axis& frame, double height, double angle) {
    return traced(frame, height, [&] { return trace_radius(*body, frame, height, angle, offset); });
  };
  // The panel lies where the gap is the offset, so the gap's gradient is its normal.
  target.normal = [&](double, double, const Vec3& position) {
    const body::SurfacePoint point = body->closest(position);
    if (!point.found) list.fail("offset", "the body's surface is out of reach from there, so the panel has no normal");
    return point.normal;
  };
  return wrap(list, panel.mesh, axis, target);
}

mesh::Placed place_freely(const base::List& list, const FlatPanel& panel) {
  const base::Reals& around = list.reals("around");
  if (around.size() != 2) list.fail("around", "needs two radii, one at \"from\" and one at \"to\"");
  const LimbAxis axis(list);
  const double from = list.real("from");
  const double taper = (around[1] - around[0]) / (list.real("to") - from);
  const auto radius = [&](double height) { return around[0] + taper * (height - from); };
  Target target;
  target.section = [&](const Axis&, double height) {
    constexpr int samples = 16;  // any number: a circle is represented exactly
    return Section(std::vector<double>(samples, radius(height)));
  };
  target.radius = [&](const Axis&, double height, double) { return radius(height); };
  // Round a bend the way along the axis is longer at the outer side.
  target.normal = [&](double height, double angle, const Vec3&) {
    const Axis frame = axis.frame(height);
    const Vec3 ray = frame.ray(angle);
    const double way = 1.0 - radius(height) * axis.curvature(height).dot(ray);
    return Vec3((way * ray - taper * frame.direction).normalized());
  };
  return wrap(list, panel.mesh, axis, target);
}

std::optional<body::Region> reach_of_wrap(const base::List& list) {
  const LimbAxis limb(list);
  if (limb.is_bent()) return std::nullopt;
  const Axis axis = limb.frame(0.0);
  const auto [from, to] = wrap_heights(list);
  body::Region region;
  region.direction = axis.direction;
  region.bottom = axis.at(from).dot(axis.direction);
  region.top = axis.at(to).dot(axis.direction);
  region.seed = axis.at(0.5 * (from + to));
  return region;
}

}  // namespace

Placement wrap_placement() {
  base::Spec spec = add_wrap_parameters(base::Spec("wrap", "Round the body, level by level."));
  spec.real("offset", "mm", "Distance from the body's surface.", 0.0, base::Range::non_negative());
  return {spec, place_on_body, reach_of_wrap};
}

Placement free_wrap_placement() {
  base::Spec spec = add_wrap_parameters(
      base::Spec("free wrap",
                 "Round a cylinder or cone, without a body. Without a coverage, with two equal radii and with heights "
                 "as far apart as the panel is high, a rectangle is rolled without any strain."));
  spec.reals("around", "mm", "Radius at 'from' and at 'to'.", base::required, base::Range::positive());
  return {spec, place_freely, reach_of_wrap};
}

}  // namespace toile::garment
