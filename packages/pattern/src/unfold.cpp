#include <algorithm>
#include <cmath>

#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::pattern {
namespace {

/// Of the fold's length: how far a straight fold may be from its chord.
constexpr double straight = 1e-6;
/// Cosine of the angle at which an edge still counts as perpendicular to the fold: 0.6 degrees off.
constexpr double perpendicular = 0.01;

const std::string suffix = ".mirrored";

/// Makes the whole panel of a half.
class Unfolding {
 public:
  Unfolding(const Panel& half, const std::string& fold) : half_(half), fold_(fold) {
    const auto found =
        std::find_if(half.outline.begin(), half.outline.end(), [&](const Edge& edge) { return edge.name == fold; });
    if (found == half.outline.end()) {
      base::Texts names;
      for (const Edge& edge : half.outline) names.push_back(edge.name);
      fail("there is no edge of that name on its outline" + base::hint(fold, names));
    }
    if (half.outline.size() < 2) fail("its outline is this edge alone");
    axis_ = &*found;
    point_ = axis_->curve.front();
    direction_ = (axis_->curve.back() - point_).normalized();
    for (const Notch& notch : half.notches)
      if (notch.edge == fold) fail("notch \"" + notch.name + "\" lies on it, and it is no edge of the whole panel");
    check_straight();
    rest_.assign(found + 1, half.outline.end());
    rest_.insert(rest_.end(), half.outline.begin(), found);
  }

  Panel run() {
    whole_.name = half_.name;
    whole_.grain = half_.grain;
    whole_.placement = half_.placement;
    make_outline();
    add_holes();
    for (const InternalLine& line : half_.lines) {
      whole_.lines.push_back(line);
      whole_.lines.push_back({line.name + suffix, image(line.curve)});
    }
    whole_.lines.push_back({fold_, axis_->curve});
    return whole_;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw base::InputError("panel \"" + half_.name + "\" cannot be unfolded at \"" + fold_ + "\": " + problem);
  }

  void check_straight() const {
    const double length = axis_->curve.length();
    for (const Vec2& p : axis_->curve.points(straight * length)) {
      const Vec2 d = p - point_;
      const double off = std::abs(d.x() * direction_.y() - d.y() * direction_.x());
      if (off > straight * length)
        fail("this edge is bent, by " + std::to_string(off) + " mm; fabric folds along a straight line");
    }
  }

  Curve image(const Curve& curve) const { return curve.mirrored(point_, direction_); }

  bool meets_at_right_angle(const Vec2& tangent) const { return std::abs(tangent.dot(direction_)) < perpendicular; }

  /// The fold runs between the last and the first of the other edges.
  void make_outline() {
    const bool at_start = meets_at_right_angle(rest_.front().curve.tangent(0.0));
    const bool at_end = meets_at_right_angle(rest_.back().curve.tangent(1.0));
    const std::size_t n = rest_.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Edge& edge = rest_[k];
      const Curve other = image(edge.curve).reversed();
      if (k + 1 == n && at_end) {
        add(Curve::joined({edge.curve, other}), edge.name, 0.0, 0.5);
      } else if (k == 0 && at_start) {
        add(Curve::joined({other, edge.curve}), edge.name, 0.5, 1.0);
      } else {
        add(edge.curve, edge.name, 0.0, 1.0);
      }
    }
    for (std::size_t k = n; k-- > 0;) {
      if ((k + 1 == n && at_end) || (k == 0 && at_start)) continue;
      const Edge& edge = rest_[k];
      whole_.outline.push_back({edge.name + suffix, image(edge.curve).reversed()});
      for (const Notch& notch : half_.notches)
        if (notch.edge == edge.name)
          whole_.notches.push_back({notch.name + suffix, edge.name + suffix, 1.0 - notch.at});
    }
  }

  /// Adds an edge of which the old one is the part between two relative arc lengths, with the notches of both halves.
  void add(const Curve& curve, const std::string& name, double from, double to) {
    whole_.outline.push_back({name, curve});
    for (const Notch& notch : half_.notches) {
      if (notch.edge != name) continue;
      const double at = from + notch.at * (to - from);
      whole_.notches.push_back({notch.name, name, at});
      if (to - from < 1.0) whole_.notches.push_back({notch.name + suffix, name, 1.0 - at});
    }
  }

  void add_holes() {
    whole_.holes = half_.holes;
    for (const Loop& hole : half_.holes) {
      Loop other;
      for (auto edge = hole.rbegin(); edge != hole.rend(); ++edge) {
        other.push_back({edge->name + suffix, image(edge->curve).reversed()});
        for (const Notch& notch : half_.notches) {
          if (notch.edge != edge->name) continue;
          whole_.notches.push_back(notch);
          whole_.notches.push_back({notch.name + suffix, edge->name + suffix, 1.0 - notch.at});
        }
      }
      whole_.holes.push_back(other);
    }
  }

  const Panel& half_;
  const std::string& fold_;
  const Edge* axis_ = nullptr;
  Vec2 point_ = Vec2::Zero(), direction_ = Vec2::Zero();
  Loop rest_;  ///< without the fold, from its end to its start
  Panel whole_;
};

}  // namespace

Panel unfolded(const Panel& panel, const std::string& fold) {
  return Unfolding(panel, fold).run();
}

}  // namespace toile::pattern
