#include "toile/pattern/svg.hpp"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "format.hpp"
#include "segment.hpp"
#include "svg_keys.hpp"
#include "svg_layout.hpp"

namespace toile::pattern {
namespace {

constexpr double paper_width = 210.0, paper_height = 297.0, paper_margin = 10.0;

std::string text_of(const Vec2& p) {
  return number_text(p.x()) + " " + number_text(p.y());
}

/// The pattern's y points up, the drawing's down.
Curve flipped(const Curve& curve) {
  return curve.mirrored(Vec2::Zero(), Vec2::UnitX());
}

Vec2 flipped(const Vec2& p) {
  return {p.x(), -p.y()};
}

/// Arcs in parts below half a circle, which is the longest that the format can tell.
std::string arc_text(const Arc& arc) {
  const double turn = arc.to - arc.from;
  const int n = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / 2.0)));
  std::string text;
  for (int k = 1; k <= n; ++k)
    text += " A " + number_text(arc.radius) + " " + number_text(arc.radius) + " 0 0 " + (turn > 0.0 ? "1 " : "0 ") +
            text_of(value(arc, static_cast<double>(k) / n));
  return text;
}

/// Path data of a curve of the drawing.
std::string path_text(const Curve& curve) {
  std::string text = "M " + text_of(curve.front());
  for (const Segment& segment : curve.segments()) {
    if (const auto* arc = std::get_if<Arc>(&segment)) {
      text += arc_text(*arc);
      continue;
    }
    const auto& c = std::get<Bezier>(segment).control;
    text +=
        is_line(segment) ? " L " + text_of(c[3]) : " C " + text_of(c[1]) + " " + text_of(c[2]) + " " + text_of(c[3]);
  }
  return text;
}

std::string id_of(std::string name) {
  for (char& c : name)
    if (std::isspace(static_cast<unsigned char>(c)) != 0) c = '_';
  return name;
}

/// Colour and dashes of a seam: both change, so that many can be told apart.
std::pair<std::string, std::string> seam_style(std::size_t k) {
  static const char* const colours[] = {"#d62728", "#1f77b4", "#2ca02c", "#ff7f0e", "#9467bd",
                                        "#17becf", "#e377c2", "#8c564b", "#bcbd22"};
  static const char* const dashes[] = {"", "6 2", "2 2", "8 2 2 2"};
  return {colours[k % std::size(colours)], dashes[k / std::size(colours) % std::size(dashes)]};
}

pugi::xml_node add_path(pugi::xml_node parent, const char* kind, const std::string& d, const char* stroke,
                        double width) {
  pugi::xml_node path = parent.append_child("path");
  path.append_attribute(svg_key::kind) = kind;
  path.append_attribute("d") = d.c_str();
  path.append_attribute("fill") = "none";
  path.append_attribute("stroke") = stroke;
  path.append_attribute("stroke-width") = number_text(width).c_str();
  return path;
}

pugi::xml_node add_text(pugi::xml_node parent, const Vec2& at, const std::string& words, double size,
                        const char* colour) {
  pugi::xml_node text = parent.append_child("text");
  text.append_attribute(svg_key::kind) = "drawing";
  text.append_attribute("x") = number_text(at.x()).c_str();
  text.append_attribute("y") = number_text(at.y()).c_str();
  text.append_attribute("font-size") = number_text(size).c_str();
  text.append_attribute("font-family") = "sans-serif";
  text.append_attribute("text-anchor") = "middle";
  text.append_attribute("dominant-baseline") = "middle";
  text.append_attribute("fill") = colour;
  text.text() = words.c_str();
  return text;
}

/// Draws the panels of a pattern as children of an element whose units are mm of the drawing.
class Drawing {
 public:
  explicit Drawing(const Pattern& pattern) : pattern_(pattern), layout_(lay_out(pattern)) {}

  Vec2 size() const { return layout_.size; }
  std::size_t panels() const { return pattern_.panels.size(); }
  const Box& box(std::size_t k) const { return layout_.boxes[k]; }

  void draw_panel(pugi::xml_node parent, std::size_t k) const {
    const Panel& panel = pattern_.panels[k];
    const Vec2& origin = layout_.origins[k];
    pugi::xml_node group = parent.append_child("g");
    group.append_attribute("id") = id_of(panel.name).c_str();
    group.append_attribute(svg_key::kind) = "panel";
    group.append_attribute(svg_key::name) = panel.name.c_str();
    group.append_attribute(svg_key::origin) = text_of(origin).c_str();
    group.append_attribute("transform") = ("translate(" + text_of(origin) + ")").c_str();
    if (panel.placement) group.append_attribute(svg_key::placement) = placement_text(*panel.placement).c_str();
    for (const Edge& edge : panel.outline) draw_edge(group, panel, edge);
    for (std::size_t h = 0; h < panel.holes.size(); ++h)
      for (const Edge& edge : panel.holes[h])
        draw_edge(group, panel, edge).append_attribute(svg_key::hole) = static_cast<unsigned>(h);
    draw_seams(group, panel);
    for (const InternalLine& line : panel.lines) {
      pugi::xml_node path = add_path(group, "line", path_text(flipped(line.curve)), "#555555", 0.35);
      path.append_attribute("stroke-dasharray") = "4 2";
      path.append_attribute(svg_key::name) = line.name.c_str();
    }
    for (const Notch& notch : panel.notches) draw_notch(group, panel, notch);
    if (panel.grain) draw_grain(group, *panel.grain);
    const Vec2 middle = 0.5 * (layout_.boxes[k].low + layout_.boxes[k].high) - origin;
    const double width = layout_.boxes[k].high.x() - layout_.boxes[k].low.x();
    add_text(group, middle, panel.name, std::clamp(width / 12.0, 4.0, 14.0), "black");
  }

  void add_stitches(pugi::xml_node parent) const {
    for (const Stitch& stitch : pattern_.stitches) {
      pugi::xml_node node = parent.append_child("desc");
      node.append_attribute(svg_key::kind) = "stitch";
      node.append_attribute(svg_key::name) = stitch.name.c_str();
      node.append_attribute(svg_key::first) = stitch.first.c_str();
      node.append_attribute(svg_key::second) = stitch.second.c_str();
      node.append_attribute(svg_key::reversed) = stitch.reversed;
    }
  }

 private:
  static std::string placement_text(const Placement& placement) {
    std::ostringstream text;
    text.precision(12);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) text << placement.rotation(i, j) << " ";
    text << placement.translation.transpose();
    return text.str();
  }

  static pugi::xml_node draw_edge(pugi::xml_node group, const Panel& panel, const Edge& edge) {
    pugi::xml_node path = add_path(group, "edge", path_text(flipped(edge.curve)), "black", 0.5);
    path.append_attribute("id") = id_of(panel.name + "." + edge.name).c_str();
    path.append_attribute(svg_key::name) = edge.name.c_str();
    const Vec2 at = edge.curve.at(0.5), t = edge.curve.tangent(0.5);
    const Vec2 place = flipped(Vec2(at + 4.0 * Vec2(-t.y(), t.x())));
    // Along the edge, and not upside down.
    const double angle = std::atan(-t.y() / t.x()) * 180.0 / M_PI;
    add_text(group, place, edge.name, 4.0, "#555555").append_attribute("transform") =
        ("rotate(" + number_text(angle) + " " + text_of(place) + ")").c_str();
    return path;
  }

  void draw_seams(pugi::xml_node group, const Panel& panel) const {
    for (std::size_t k = 0; k < pattern_.stitches.size(); ++k)
      for (const std::string& name : {pattern_.stitches[k].first, pattern_.stitches[k].second}) {
        const Side side = find_side(pattern_, name);
        if (side.panel != &panel) continue;
        const auto [colour, dashes] = seam_style(k);
        const Curve part = side.part.edge->curve.part(side.part.from, side.part.to);
        pugi::xml_node path = add_path(group, "drawing", path_text(flipped(part)), colour.c_str(), 1.2);
        if (!dashes.empty()) path.append_attribute("stroke-dasharray") = dashes.c_str();
      }
  }

  /// A short line from the edge into the panel, which lies to the left of its edges.
  static void draw_notch(pugi::xml_node group, const Panel& panel, const Notch& notch) {
    const Curve& curve = panel.edge(notch.edge)->curve;
    const Vec2 at = curve.at(notch.at), t = curve.tangent(notch.at), inwards(-t.y(), t.x());
    pugi::xml_node path =
        add_path(group, "notch", path_text(flipped(Curve::line(at, at + 4.0 * inwards))), "black", 0.7);
    path.append_attribute(svg_key::name) = notch.name.c_str();
    path.append_attribute(svg_key::edge) = notch.edge.c_str();
    path.append_attribute(svg_key::at) = notch.at;
    add_text(group, flipped(Vec2(at + 7.0 * inwards)), notch.name, 3.0, "black");
  }

  static void draw_grain(pugi::xml_node group, const Grain& grain) {
    const Vec2 d = (grain.to - grain.from).normalized(), n(-d.y(), d.x());
    add_path(group, "grain", path_text(flipped(Curve::line(grain.from, grain.to))), "black", 0.5);
    const Curve head = Curve::polyline({grain.to - 6.0 * d + 2.5 * n, grain.to, grain.to - 6.0 * d - 2.5 * n});
    add_path(group, "drawing", path_text(flipped(head)), "black", 0.5);
  }

  const Pattern& pattern_;
  Layout layout_;
};

void draw_grid(pugi::xml_node parent, const Box& box) {
  for (const int step : {10, 100}) {
    std::string d;
    for (double x = step * std::ceil(box.low.x() / step); x <= box.high.x(); x += step)
      d += "M " + text_of({x, box.low.y()}) + " V " + number_text(box.high.y()) + " ";
    for (double y = step * std::ceil(box.low.y() / step); y <= box.high.y(); y += step)
      d += "M " + text_of({box.low.x(), y}) + " H " + number_text(box.high.x()) + " ";
    add_path(parent, "drawing", d, step == 10 ? "#dddddd" : "#aaaaaa", step == 10 ? 0.1 : 0.2);
  }
}

pugi::xml_node add_root(pugi::xml_document& document, const Vec2& size) {
  pugi::xml_node root = document.append_child("svg");
  root.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  root.append_attribute("width") = (number_text(size.x()) + "mm").c_str();
  root.append_attribute("height") = (number_text(size.y()) + "mm").c_str();
  root.append_attribute("viewBox") = ("0 0 " + text_of(size)).c_str();
  return root;
}

void save(const pugi::xml_document& document, const std::string& path) {
  std::ostringstream text;
  document.save(text, " ");
  replace_content(path, text.str());
}

/// One page: what lies in the window, in a frame.
void draw_page(pugi::xml_document& document, const Drawing& drawing, const Box& window, const std::string& title,
               const SvgOptions& options) {
  const Vec2 size = window.high - window.low;
  pugi::xml_node root = add_root(document, {paper_width, paper_height});
  pugi::xml_node view = root.append_child("svg");
  view.append_attribute("x") = paper_margin;
  view.append_attribute("y") = paper_margin;
  view.append_attribute("width") = size.x();
  view.append_attribute("height") = size.y();
  view.append_attribute("viewBox") = (text_of(window.low) + " " + text_of(size)).c_str();
  if (options.grid) draw_grid(view, window);
  for (std::size_t k = 0; k < drawing.panels(); ++k)
    if (meets(drawing.box(k), window)) drawing.draw_panel(view, k);
  const Vec2 low(paper_margin, paper_margin), high = low + size;
  add_path(root, "drawing",
           "M " + text_of(low) + " H " + number_text(high.x()) + " V " + number_text(high.y()) + " H " +
               number_text(low.x()) + " Z",
           "#888888", 0.2);
  add_text(root, {0.5 * paper_width, paper_height - 0.5 * paper_margin}, title + "; the frame is 190 mm wide", 4.0,
           "#555555");
}

void write_default(const Pattern& pattern, const std::string& path) {
  write_svg(pattern, path);
}

}  // namespace

void write_svg(const Pattern& pattern, const std::string& path, const SvgOptions& options) {
  const Drawing drawing(pattern);
  pugi::xml_document document;
  pugi::xml_node root = add_root(document, drawing.size());
  if (options.grid) draw_grid(root, {Vec2::Zero(), drawing.size()});
  for (std::size_t k = 0; k < drawing.panels(); ++k) drawing.draw_panel(root, k);
  drawing.add_stitches(root);
  save(document, path);
}

std::vector<std::string> write_svg_pages(const Pattern& pattern, const std::string& path, const SvgOptions& options) {
  const Drawing drawing(pattern);
  const Vec2 step(paper_width - 2.0 * paper_margin, paper_height - 2.0 * paper_margin);
  std::vector<std::string> files;
  for (int row = 0; row * step.y() < drawing.size().y(); ++row)
    for (int column = 0; column * step.x() < drawing.size().x(); ++column) {
      const Vec2 low(column * step.x(), row * step.y());
      const Box window{low, low + step};
      bool used = false;
      for (std::size_t k = 0; k < drawing.panels(); ++k) used = used || meets(drawing.box(k), window);
      if (!used) continue;
      const std::string place = std::to_string(row + 1) + "-" + std::to_string(column + 1);
      pugi::xml_document document;
      draw_page(document, drawing, window, "page " + place + " (row-column)", options);
      files.push_back(path + "-" + place + ".svg");
      save(document, files.back());
    }
  return files;
}

Format svg_format() {
  return {".svg", "drawing in true scale", read_svg, write_default};
}

}  // namespace toile::pattern
