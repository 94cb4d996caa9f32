#include <algorithm>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "format.hpp"
#include "geometry.hpp"
#include "runs.hpp"
#include "segment.hpp"
#include "svg_keys.hpp"
#include "svg_path.hpp"
#include "svg_shapes.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"

namespace toile::pattern {
namespace {

using Affine = Eigen::Affine2d;

constexpr double pixel = 25.4 / 96.0;  ///< mm, as CSS has it
constexpr int deepest = 200;           ///< of elements in each other
/// Ends of a line that are no further apart count as one point, mm.
constexpr double closed = 0.01;
/// Where a path turns by more than this, an edge ends, radians.
constexpr double corner = 2.0 * M_PI / 180.0;

/// A length such as "210mm". Without unit: user units, pixels of CSS.
double length_of(const std::string& text) {
  static const std::pair<const char*, double> units[] = {{"", pixel},        {"px", pixel}, {"mm", 1.0},
                                                         {"cm", 10.0},       {"in", 25.4},  {"pt", 25.4 / 72.0},
                                                         {"pc", 25.4 / 6.0}, {"Q", 0.25}};
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string unit(rest, text.data() + text.size() - rest);
  for (const auto& [name, mm] : units)
    if (error == std::errc() && unit == name && value > 0.0 && value <= largest_coordinate) return value * mm;
  throw base::InputError("\"" + text +
                         "\" is no length on paper; write a number with its unit: mm, cm, in, pt, pc, px");
}

/// From user units of the drawing to mm, with y up.
Affine scale_of(const pugi::xml_node& root) {
  Affine map = Affine::Identity();
  map.scale(Vec2(1.0, -1.0));
  const std::string width = root.attribute("width").value(), height = root.attribute("height").value();
  const pugi::xml_attribute box = root.attribute("viewBox");
  if (!box) return map.scale(pixel);
  const std::vector<double> view = parse_numbers(box.value());
  if (view.size() != 4 || !(view[2] > 0.0 && view[3] > 0.0))
    throw base::InputError("viewBox \"" + std::string(box.value()) + "\" must be x, y, width, height");
  if (width.empty() || height.empty())
    throw base::InputError(
        "the drawing has no size on paper; give <svg> its width and height with a unit, e.g. width=\"210mm\"");
  Vec2 scale(length_of(width) / view[2], length_of(height) / view[3]);
  const std::string aspect = root.attribute("preserveAspectRatio").value();
  if (aspect.compare(0, 4, "none") != 0)
    scale.setConstant(aspect.find("slice") == std::string::npos ? scale.minCoeff() : scale.maxCoeff());
  return map.scale(scale);
}

class Reader {
 public:
  Pattern run(const pugi::xml_node& root) {
    refuse_css_map(root);
    walk(root, scale_of(root), 0);
    for (const auto& [name, curve] : open_) add_line(name, curve);
    return std::move(pattern_);
  }

 private:
  struct Open {
    std::string name;
    Curve curve;
  };

  static std::string name_of(const pugi::xml_node& node) {
    const pugi::xml_attribute name = node.attribute(svg_key::name);
    return name ? name.value() : node.attribute("id").value();
  }

  static std::string place_of(const pugi::xml_node& node) {
    return std::string("<") + node.name() + "> \"" + name_of(node) + "\": ";
  }

  static bool is_shown(const pugi::xml_node& node) {
    std::string style = node.attribute("style").value();
    style.erase(std::remove(style.begin(), style.end(), ' '), style.end());
    return std::string(node.attribute("display").value()) != "none" && style.find("display:none") == std::string::npos;
  }

  static std::string kind_of(const pugi::xml_node& node) {
    const std::string name = node.name();
    return name.compare(0, 4, "svg:") == 0 ? name.substr(4) : name;
  }

  /// CSS can move and scale what is drawn too. It is not read, and without it the size would be wrong.
  static void refuse_css_map(const pugi::xml_node& node) {
    static const std::set<std::string> maps = {"transform", "-webkit-transform", "translate", "rotate", "scale",
                                               "zoom"};
    std::istringstream style(node.attribute("style").value());
    for (std::string property; std::getline(style, property, ';');) {
      const std::size_t colon = property.find(':');
      if (colon == std::string::npos) continue;
      property.erase(std::remove_if(property.begin(), property.end(), [](unsigned char c) { return std::isspace(c); }),
                     property.end());
      if (maps.count(property.substr(0, property.find(':'))) == 0) continue;
      throw base::InputError(place_of(node) + "its attribute \"style\" has \"" + property +
                             "\", which is not read; write it as the attribute \"transform\", e.g. "
                             "transform=\"scale(2)\"");
    }
  }

  /// Map of the children of an element or of its own points.
  static Affine map_of(const pugi::xml_node& node, const Affine& map) {
    const pugi::xml_attribute transform = node.attribute("transform");
    return transform ? map * parse_transform(transform.value()) : map;
  }

  /// Work for each element that is drawn, with its map; told by its kind.
  template <class Work>
  static void for_each_drawn(const pugi::xml_node& node, const Affine& map, int depth, const Work& work) {
    if (depth > deepest) throw base::InputError("elements are nested more than 200 deep");
    for (const pugi::xml_node child : node.children()) {
      const std::string kind = kind_of(child);
      if (kind == "use" || kind == "svg")
        throw base::InputError(place_of(child) + (kind == "use" ? "copies (\"use\") are not read; unlink them first"
                                                                : "a drawing in a drawing is not read"));
      if (child.type() != pugi::node_element || !is_shown(child)) continue;
      refuse_css_map(child);
      try {
        work(child, kind, map_of(child, map), depth + 1);
      } catch (const base::InputError& error) {
        const std::string text = error.what();
        throw base::InputError(text.front() == '<' ? text : place_of(child) + text);
      }
    }
  }

  void walk(const pugi::xml_node& node, const Affine& map, int depth) {
    for_each_drawn(node, map, depth,
                   [this](const pugi::xml_node& child, const std::string& kind, const Affine& m, int d) {
                     const std::string own = child.attribute(svg_key::kind).value();
                     if (own == "stitch") {
                       pattern_.stitches.push_back({name_of(child), child.attribute(svg_key::first).value(),
                                                    child.attribute(svg_key::second).value(),
                                                    child.attribute(svg_key::reversed).as_bool()});
                     } else if (own == "panel") {
                       read_own(child, m, d);
                     } else if (own.empty() && (kind == "g" || kind == "a" || kind == "switch")) {
                       walk(child, m, d);
                     } else if (own.empty() && is_shape(kind)) {
                       read_shape(child, kind, m);
                     }
                   });
  }

  /// A group that we wrote: each path tells what it is.
  void read_own(const pugi::xml_node& group, const Affine& map, int depth) {
    Panel panel;
    panel.name = name_of(group);
    const std::vector<double> origin = parse_numbers(group.attribute(svg_key::origin).value());
    if (origin.size() != 2) throw base::InputError(std::string(svg_key::origin) + " must be two numbers");
    const Affine own = Eigen::Translation2d(-origin[0], origin[1]) * map;
    if (const pugi::xml_attribute placement = group.attribute(svg_key::placement))
      panel.placement = read_placement(placement.value());
    read_own_parts(group, own, depth, panel);
    if (panel.outline.empty()) throw base::InputError("this panel has no edges");
    pattern_.panels.push_back(std::move(panel));
  }

  static void read_own_parts(const pugi::xml_node& group, const Affine& map, int depth, Panel& panel) {
    for_each_drawn(
        group, map, depth, [&panel](const pugi::xml_node& child, const std::string& kind, const Affine& m, int d) {
          const std::string own = child.attribute(svg_key::kind).value();
          if (own.empty() && kind == "g") return read_own_parts(child, m, d, panel);
          if (own == "notch") {
            panel.notches.push_back(
                {name_of(child), child.attribute(svg_key::edge).value(), child.attribute(svg_key::at).as_double(-1.0)});
            return;
          }
          if (own != "edge" && own != "line" && own != "grain") return;
          const std::vector<SubPath> paths = parse_path(child.attribute("d").value());
          if (paths.size() != 1) throw base::InputError("expected one line, found " + std::to_string(paths.size()));
          const Curve curve(transformed(paths.front().segments, m));
          if (own == "line") panel.lines.push_back({name_of(child), curve});
          if (own == "grain") panel.grain = Grain{curve.front(), curve.back()};
          if (own != "edge") return;
          const pugi::xml_attribute hole = child.attribute(svg_key::hole);
          if (hole && hole.as_uint() > panel.holes.size())
            throw base::InputError("the number of its hole is missing before");
          if (hole && hole.as_uint() == panel.holes.size()) panel.holes.emplace_back();
          (hole ? panel.holes[hole.as_uint()] : panel.outline).push_back({name_of(child), curve});
        });
  }

  static Placement read_placement(const std::string& text) {
    const std::vector<double> v = parse_numbers(text);
    if (v.size() != 12) throw base::InputError(std::string(svg_key::placement) + " must be 12 numbers");
    Placement placement;
    placement.rotation << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
    placement.translation << v[9], v[10], v[11];
    if (!((placement.rotation * placement.rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6) ||
        !(placement.rotation.determinant() > 0.0))
      throw base::InputError(std::string(svg_key::placement) + " does not begin with a rotation");
    return placement;
  }

  /// Closed lines of one element: the largest is a panel's outline, the others are its holes. Open lines lie on panels.
  void read_shape(const pugi::xml_node& node, const std::string& kind, const Affine& map) {
    std::vector<std::vector<Segment>> loops;
    int number = 0;
    for (const SubPath& path : shape_paths(node, kind)) {
      std::vector<Segment> segments = transformed(path.segments, map);
      if (close_gap(segments, closed)) {
        loops.push_back(std::move(segments));
      } else {
        const std::string name = name_of(node).empty() ? "line" + std::to_string(open_.size() + 1) : name_of(node);
        open_.push_back({number++ == 0 ? name : name + "." + std::to_string(number), Curve(std::move(segments))});
      }
    }
    if (loops.empty()) return;
    std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
      return std::abs(area_of(Curve(a))) > std::abs(area_of(Curve(b)));
    });
    Panel panel;
    panel.name = name_of(node).empty() ? "panel" + std::to_string(pattern_.panels.size() + 1) : name_of(node);
    for (std::size_t k = 0; k < loops.size(); ++k) {
      Loop loop;
      for (const Curve& curve : smooth_runs(loops[k], corner))
        loop.push_back(
            {(k == 0 ? "" : "hole" + std::to_string(k) + ".") + "edge" + std::to_string(loop.size() + 1), curve});
      if (k == 0) {
        panel.outline = std::move(loop);
      } else {
        panel.holes.push_back(std::move(loop));
      }
    }
    pattern_.panels.push_back(std::move(panel));
  }

  void add_line(const std::string& name, const Curve& curve) {
    for (Panel& panel : pattern_.panels)
      if (lies_on(panel, curve.at(0.5))) {
        panel.lines.push_back({name, curve});
        return;
      }
    throw base::InputError("the open line \"" + name +
                           "\" lies on no panel; a panel's outline must be closed (a path that ends with Z)");
  }

  Pattern pattern_;
  std::vector<Open> open_;
};

}  // namespace

Pattern read_svg(const std::string& path) {
  const std::string text = base::read_file(path, "an SVG file", largest_file);
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result)
    throw base::InputError(path + ": this is no valid XML: " + result.description() + " at character " +
                           std::to_string(result.offset));
  const pugi::xml_node root = document.document_element();
  const std::string name = root.name();
  if (name != "svg" && name != "svg:svg")
    throw base::InputError(path + ": this is no SVG drawing; its first element is <" + name + ">, not <svg>");
  try {
    return Reader().run(root);
  } catch (const base::InputError& error) {
    throw base::InputError(path + ": " + error.what());
  }
}

}  // namespace toile::pattern
