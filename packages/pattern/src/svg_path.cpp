#include "svg_path.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

#include "format.hpp"
#include "segment.hpp"
#include "svg_grammar.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

using Affine = Eigen::Affine2d;

/// Parts of an ellipse that one cubic segment follows turn by no more than this: off by 4e-8 of its size.
constexpr double ellipse_part = M_PI / 8.0;

/// Cubic segments along the image of an arc.
void append_ellipse(const Arc& arc, const Affine& map, std::vector<Segment>& segments) {
  const double turn = arc.to - arc.from;
  const int n = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / ellipse_part)));
  const double step = turn / n, reach = 4.0 / 3.0 * std::tan(step / 4.0);
  const auto at = [&](double angle, double along) -> Vec2 {
    const Vec2 d(std::cos(angle), std::sin(angle));
    return map * Vec2(arc.centre + arc.radius * (d + along * Vec2(-d.y(), d.x())));
  };
  for (int k = 0; k < n; ++k) {
    const double a = arc.from + k * step, b = a + step;
    segments.emplace_back(Bezier{{at(a, 0.0), at(a, reach), at(b, -reach), at(b, 0.0)}});
  }
}

/// Turns commands into segments.
class PathBuilder {
 public:
  std::string problem;  ///< what is wrong with the numbers
  void letter(char c) {
    command_ = c;
    numbers_.clear();
  }
  void number(double value) { numbers_.push_back(value); }

  void step() {
    const bool relative = std::islower(static_cast<unsigned char>(command_)) != 0;
    const Vec2 origin = relative ? at_ : Vec2(0.0, 0.0);
    const auto point = [&](std::size_t k) -> Vec2 { return origin + Vec2(numbers_[k], numbers_[k + 1]); };
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
    Vec2 cubic = at_, quadratic = at_;  // what a smooth command after this one mirrors
    switch (kind) {
      case 'M':
        start(point(0));
        command_ = relative ? 'l' : 'L';  // further pairs are lines
        cubic = quadratic = at_;
        break;
      case 'H':
        line({origin.x() + numbers_[0], at_.y()});
        break;
      case 'V':
        line({at_.x(), origin.y() + numbers_[0]});
        break;
      case 'L':
        line(point(0));
        break;
      case 'C':
        cubic = point(2);
        bezier(point(0), cubic, point(4));
        break;
      case 'S':
        cubic = point(0);
        bezier(2.0 * at_ - cubic_, cubic, point(2));
        break;
      case 'Q':
        quadratic = point(0);
        curve(quadratic, point(2));
        break;
      case 'T':
        quadratic = 2.0 * at_ - quadratic_;
        curve(quadratic, point(0));
        break;
      default:
        arc(point(5));
    }
    const bool was_cubic = kind == 'C' || kind == 'S', was_quadratic = kind == 'Q' || kind == 'T';
    cubic_ = was_cubic ? cubic : at_;
    quadratic_ = was_quadratic ? quadratic : at_;
    numbers_.clear();
  }

  void close() {
    if (paths_.empty()) return;
    line(start_);
    paths_.back().closed = true;
    pending_ = true;
    cubic_ = quadratic_ = at_;
  }

  std::vector<SubPath> paths() {
    std::vector<SubPath> all;
    for (SubPath& path : paths_)
      if (!path.segments.empty()) all.push_back(std::move(path));
    return all;
  }

 private:
  void start(const Vec2& p) {
    paths_.emplace_back();
    pending_ = false;
    start_ = at_ = p;
  }

  void add(const Segment& segment, const Vec2& end) {
    if (!(end.cwiseAbs().maxCoeff() <= largest_coordinate)) problem = "its numbers are too large for a garment";
    if (pending_) start(start_);
    paths_.back().segments.push_back(segment);
    at_ = end;
  }

  void line(const Vec2& to) {
    if ((to - at_).norm() > 0.0) add(Bezier{{at_, (2.0 * at_ + to) / 3.0, (at_ + 2.0 * to) / 3.0, to}}, to);
  }

  void bezier(const Vec2& a, const Vec2& b, const Vec2& to) {
    if (!(std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) <= largest_coordinate))
      problem = "its numbers are too large for a garment";
    if ((to - at_).norm() + (a - at_).norm() + (b - at_).norm() > 0.0) add(Bezier{{at_, a, b, to}}, to);
  }

  void curve(const Vec2& control, const Vec2& to) {
    bezier((at_ + 2.0 * control) / 3.0, (to + 2.0 * control) / 3.0, to);
  }

  /// Radii of zero mean a line, radii that are too small grow until they reach, as SVG has it.
  void arc(const Vec2& to) {
    const Vec2 radii(std::abs(numbers_[0]), std::abs(numbers_[1]));
    if (radii.minCoeff() == 0.0) return line(to);
    if ((to - at_).norm() == 0.0) return;
    Affine map = Affine::Identity();
    map.rotate(numbers_[2] * M_PI / 180.0).scale(radii);
    const Affine back = map.inverse();
    const Vec2 a = back * at_, b = back * to;
    const double radius = std::max(1.0, 0.5 * (b - a).norm());
    const Curve circle = Curve::circular(a, b, radius, numbers_[3] != 0.0, numbers_[4] != 0.0);
    for (const Segment& segment : transformed(circle.segments(), map)) add(segment, value(segment, 1.0));
    at_ = to;
  }

  char command_ = 'M';
  std::vector<double> numbers_;
  std::vector<SubPath> paths_;
  bool pending_ = true;  ///< the next segment begins a new part
  Vec2 at_ = Vec2::Zero(), start_ = Vec2::Zero(), cubic_ = Vec2::Zero(), quadratic_ = Vec2::Zero();
};

struct TransformBuilder {
  std::string problem;
  std::string name;
  std::vector<double> numbers;
  Affine map = Affine::Identity();

  void number(double value) { numbers.push_back(value); }

  void apply() {
    const std::size_t n = numbers.size();
    const auto& v = numbers;
    Affine part = Affine::Identity();
    if (name == "matrix" && n == 6) {
      part.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0.0, 0.0, 1.0;
    } else if (name == "translate" && (n == 1 || n == 2)) {
      part.translate(Vec2(v[0], n == 2 ? v[1] : 0.0));
    } else if (name == "scale" && (n == 1 || n == 2)) {
      part.scale(Vec2(v[0], n == 2 ? v[1] : v[0]));
    } else if (name == "rotate" && (n == 1 || n == 3)) {
      const Vec2 centre = n == 3 ? Vec2(v[1], v[2]) : Vec2(0.0, 0.0);
      part.translate(centre).rotate(v[0] * M_PI / 180.0).translate(-centre);
    } else if (name == "skewX" && n == 1) {
      part.matrix()(0, 1) = std::tan(v[0] * M_PI / 180.0);
    } else if (name == "skewY" && n == 1) {
      part.matrix()(1, 0) = std::tan(v[0] * M_PI / 180.0);
    } else {
      problem = "\"" + name + "\" with " + std::to_string(n) +
                " numbers is none of matrix(6), translate(1 or 2), scale(1 or 2), rotate(1 or 3), skewX(1), skewY(1)";
    }
    map = map * part;
    numbers.clear();
  }
};

struct NumberList {
  std::string problem;
  std::vector<double> numbers;
  void number(double value) { numbers.push_back(value); }
};

template <class Rule>
struct Action : tao::pegtl::nothing<Rule> {};

template <>
struct Action<svg::Number> {
  template <class Input, class State>
  static void apply(const Input& in, State& state) {
    const char* begin = in.begin();
    if (begin != in.end() && *begin == '+') ++begin;
    double value = 0.0;
    if (std::from_chars(begin, in.end(), value).ec != std::errc())
      state.problem = "\"" + in.string() + "\" is no number";
    state.number(value);
  }
};
template <>
struct Action<svg::Flag> {
  template <class Input>
  static void apply(const Input& in, PathBuilder& builder) {
    builder.number(*in.begin() == '1' ? 1.0 : 0.0);
  }
};
template <class Arguments, char... letters>
struct Action<svg::Letter<Arguments, letters...>> {
  template <class Input>
  static void apply(const Input& in, PathBuilder& builder) {
    builder.letter(*in.begin());
  }
};
template <class Arguments>
struct Action<svg::Step<Arguments>> {
  static void apply0(PathBuilder& builder) { builder.step(); }
};
template <>
struct Action<svg::Close> {
  static void apply0(PathBuilder& builder) { builder.close(); }
};
template <>
struct Action<svg::Name> {
  template <class Input>
  static void apply(const Input& in, TransformBuilder& builder) {
    builder.name = in.string();
  }
};
template <>
struct Action<svg::Function> {
  static void apply0(TransformBuilder& builder) { builder.apply(); }
};

template <class Rule, class State>
void parse(const std::string& text, const std::string& what, State& state) {
  tao::pegtl::memory_input in(text, "");
  std::string where;
  try {
    tao::pegtl::parse<tao::pegtl::must<Rule>, Action>(in, state);
  } catch (const tao::pegtl::parse_error& error) {
    const std::size_t at = error.positions().front().byte;
    where = " at character " + std::to_string(at + 1) + ", near \"" + text.substr(at, 20) + "\"";
    if (state.problem.empty()) state.problem = "not understood";
  }
  if (!state.problem.empty())
    throw base::InputError(what + " \"" + text.substr(0, 40) + (text.size() > 40 ? "..." : "") +
                           "\": " + state.problem + where);
}

}  // namespace

std::vector<SubPath> parse_path(const std::string& text) {
  PathBuilder builder;
  parse<svg::Path>(text, "path", builder);
  return builder.paths();
}

Affine parse_transform(const std::string& text) {
  TransformBuilder builder;
  parse<svg::Transform>(text, "transform", builder);
  return builder.map;
}

std::vector<double> parse_numbers(const std::string& text) {
  NumberList list;
  parse<svg::Numbers>(text, "numbers", list);
  return list.numbers;
}

std::vector<Segment> transformed(const std::vector<Segment>& segments, const Affine& map) {
  const Eigen::Matrix2d m = map.linear();
  const double size = std::sqrt(std::abs(m.determinant()));
  const bool similar = (m.transpose() * m - size * size * Eigen::Matrix2d::Identity()).norm() < 1e-12 * size * size;
  const double flip = m.determinant() < 0.0 ? -1.0 : 1.0, turn = std::atan2(m(1, 0), m(0, 0));
  std::vector<Segment> all;
  for (const Segment& segment : segments) {
    if (const auto* arc = std::get_if<Arc>(&segment)) {
      if (similar) {
        all.emplace_back(Arc{map * arc->centre, size * arc->radius, turn + flip * arc->from, turn + flip * arc->to});
      } else {
        append_ellipse(*arc, map, all);
      }
      continue;
    }
    Bezier bezier = std::get<Bezier>(segment);
    for (Vec2& c : bezier.control) c = map * c;
    all.emplace_back(bezier);
  }
  return all;
}

}  // namespace toile::pattern
