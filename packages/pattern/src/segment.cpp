#include "segment.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace toile::pattern {
namespace {

Vec2 lerp(const Vec2& a, const Vec2& b, double t) {
  return (1.0 - t) * a + t * b;
}

Vec2 unit(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Control points of the part before t (first) or after t, by de Casteljau's construction.
Bezier cut(const Bezier& b, double t, bool first) {
  const std::array<Vec2, 4>& c = b.control;
  const Vec2 p01 = lerp(c[0], c[1], t), p12 = lerp(c[1], c[2], t), p23 = lerp(c[2], c[3], t);
  const Vec2 p012 = lerp(p01, p12, t), p123 = lerp(p12, p23, t);
  const Vec2 middle = lerp(p012, p123, t);
  if (first) return {{c[0], p01, p012, middle}};
  return {{middle, p123, p23, c[3]}};
}

struct Value {
  double t;
  Vec2 operator()(const Bezier& b) const {
    const auto& c = b.control;
    const double u = 1.0 - t;
    return u * u * u * c[0] + 3.0 * u * u * t * c[1] + 3.0 * u * t * t * c[2] + t * t * t * c[3];
  }
  Vec2 operator()(const Arc& a) const { return a.centre + a.radius * unit((1.0 - t) * a.from + t * a.to); }
};

struct Derivative {
  double t;
  Vec2 operator()(const Bezier& b) const {
    const auto& c = b.control;
    const double u = 1.0 - t;
    return 3.0 * (u * u * (c[1] - c[0]) + 2.0 * u * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
  }
  Vec2 operator()(const Arc& a) const {
    const Vec2 d = unit((1.0 - t) * a.from + t * a.to);
    return a.radius * (a.to - a.from) * Vec2(-d.y(), d.x());
  }
};

struct SecondDerivative {
  double t;
  Vec2 operator()(const Bezier& b) const {
    const auto& c = b.control;
    return 6.0 * ((1.0 - t) * (c[2] - 2.0 * c[1] + c[0]) + t * (c[3] - 2.0 * c[2] + c[1]));
  }
  Vec2 operator()(const Arc& a) const {
    const double turn = a.to - a.from;
    return -a.radius * turn * turn * unit((1.0 - t) * a.from + t * a.to);
  }
};

}  // namespace

Vec2 value(const Segment& segment, double t) {
  return std::visit(Value{t}, segment);
}

Vec2 derivative(const Segment& segment, double t) {
  return std::visit(Derivative{t}, segment);
}

Vec2 second_derivative(const Segment& segment, double t) {
  return std::visit(SecondDerivative{t}, segment);
}

Vec2 direction(const Segment& segment, double t) {
  const auto* bezier = std::get_if<Bezier>(&segment);
  const Vec2 d = derivative(segment, t);
  if (bezier == nullptr) return d.normalized();
  // Where a control point lies on an end, the tangent there points to (or comes from) the next one that does not.
  const auto& c = bezier->control;
  const double small = 1e-9 * ((c[1] - c[0]).norm() + (c[2] - c[1]).norm() + (c[3] - c[2]).norm());
  if (d.norm() > small) return d.normalized();
  const Vec2 next = t < 0.5 ? Vec2(c[2] - c[0]) : Vec2(c[3] - c[1]);
  return (next.norm() > small ? next : Vec2(c[3] - c[0])).normalized();
}

bool is_line(const Segment& segment) {
  const auto* bezier = std::get_if<Bezier>(&segment);
  if (bezier == nullptr) return false;
  const auto& c = bezier->control;
  const double small = 1e-9 * (c[3] - c[0]).norm();
  return (c[1] - lerp(c[0], c[3], 1.0 / 3.0)).norm() < small && (c[2] - lerp(c[0], c[3], 2.0 / 3.0)).norm() < small;
}

double arc_length(const Segment& segment, double from, double to) {
  if (const auto* arc = std::get_if<Arc>(&segment)) return arc->radius * std::abs(arc->to - arc->from) * (to - from);
  return boost::math::quadrature::gauss<double, 10>::integrate([&](double t) { return derivative(segment, t).norm(); },
                                                               from, to);
}

Segment reversed(const Segment& segment) {
  if (const auto* arc = std::get_if<Arc>(&segment)) return Arc{arc->centre, arc->radius, arc->to, arc->from};
  const auto& c = std::get<Bezier>(segment).control;
  return Bezier{{c[3], c[2], c[1], c[0]}};
}

Segment part(const Segment& segment, double from, double to) {
  if (const auto* arc = std::get_if<Arc>(&segment)) {
    const double turn = arc->to - arc->from;
    return Arc{arc->centre, arc->radius, arc->from + from * turn, arc->from + to * turn};
  }
  const Bezier head = to < 1.0 ? cut(std::get<Bezier>(segment), to, true) : std::get<Bezier>(segment);
  return from > 0.0 ? cut(head, from / to, false) : head;
}

}  // namespace toile::pattern
