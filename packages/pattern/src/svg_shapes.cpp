#include "svg_shapes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "format.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

/// A number of an element, in user units; zero if it is missing.
double number_of(const pugi::xml_node& node, const char* name) {
  const std::string text = node.attribute(name).value();
  if (text.empty()) return 0.0;
  const std::vector<double> numbers = parse_numbers(text);
  if (numbers.size() != 1 || !(std::abs(numbers[0]) <= largest_coordinate))
    throw base::InputError(std::string(name) + " \"" + text + "\" must be a number");
  return numbers[0];
}

double size_of(const pugi::xml_node& node, const char* name) {
  const double value = number_of(node, name);
  if (!(value > 0.0)) throw base::InputError(std::string(name) + " must be given and positive");
  return value;
}

SubPath ellipse(const Vec2& centre, double rx, double ry) {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  map.translate(centre).scale(Vec2(rx, ry));
  return {transformed({Arc{Vec2::Zero(), 1.0, 0.0, M_PI}, Arc{Vec2::Zero(), 1.0, M_PI, 2.0 * M_PI}}, map), true};
}

std::vector<SubPath> polygon(const std::string& points, bool closed) {
  const std::vector<double> v = parse_numbers(points);
  if (v.size() < 4 || v.size() % 2 != 0) throw base::InputError("points must be pairs of numbers, at least two");
  std::ostringstream path;
  path.precision(17);
  for (std::size_t k = 0; k < v.size(); k += 2) path << (k == 0 ? "M " : " L ") << v[k] << " " << v[k + 1];
  return parse_path(path.str() + (closed ? " Z" : ""));
}

std::vector<SubPath> rectangle(const pugi::xml_node& node) {
  const double x = number_of(node, "x"), y = number_of(node, "y");
  const double w = size_of(node, "width"), h = size_of(node, "height");
  double rx = number_of(node, "rx"), ry = number_of(node, "ry");
  if (!node.attribute("rx")) rx = ry;
  if (!node.attribute("ry")) ry = rx;
  rx = std::clamp(rx, 0.0, 0.5 * w);
  ry = std::clamp(ry, 0.0, 0.5 * h);
  const std::string arc = " a " + number_text(rx) + " " + number_text(ry) + " 0 0 1 ";
  const std::string a = number_text(rx), b = number_text(ry);
  const std::string across = number_text(w - 2.0 * rx), down = number_text(h - 2.0 * ry);
  return parse_path("M " + number_text(x + rx) + " " + number_text(y) + " h " + across + arc + a + " " + b + " v " +
                    down + arc + "-" + a + " " + b + " h -" + across + arc + "-" + a + " -" + b + " v -" + down + arc +
                    a + " -" + b + " Z");
}

}  // namespace

bool is_shape(const std::string& kind) {
  static const char* const all[] = {"path", "polygon", "polyline", "line", "rect", "circle", "ellipse"};
  return std::find(std::begin(all), std::end(all), kind) != std::end(all);
}

std::vector<SubPath> shape_paths(const pugi::xml_node& node, const std::string& kind) {
  if (kind == "path") return parse_path(node.attribute("d").value());
  if (kind == "polygon" || kind == "polyline") return polygon(node.attribute("points").value(), kind == "polygon");
  if (kind == "rect") return rectangle(node);
  if (kind == "line") {
    const Vec2 a(number_of(node, "x1"), number_of(node, "y1")), b(number_of(node, "x2"), number_of(node, "y2"));
    if (a == b) throw base::InputError("its ends are the same point");
    return {{Curve::line(a, b).segments(), false}};
  }
  const Vec2 centre(number_of(node, "cx"), number_of(node, "cy"));
  if (kind == "circle") return {ellipse(centre, size_of(node, "r"), size_of(node, "r"))};
  return {ellipse(centre, size_of(node, "rx"), size_of(node, "ry"))};
}

}  // namespace toile::pattern
