#include <algorithm>
#include <cmath>
#include <set>

#include "dxf_layers.hpp"
#include "dxf_pieces.hpp"
#include "format.hpp"
#include "runs.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

/// Points that are no further apart are one, mm.
constexpr double same = 1e-3;
/// Where a boundary without turn points bends by more than this at a vertex, an edge ends, radians.
constexpr double corner = M_PI / 6.0;

/// Makes a panel of what one block holds.
class PieceReader {
 public:
  PieceReader(dxf::Piece piece, double mm) : piece_(std::move(piece)) {
    for (dxf::Line& line : piece_.lines)
      for (dxf::Vertex& v : line.vertices) v.at *= mm;
    for (dxf::Point& p : piece_.points) p.at *= mm;
    for (dxf::Text& t : piece_.texts) t.at *= mm;
  }

  Panel run() {
    panel_.name = piece_.name;
    for (const dxf::Text& text : piece_.texts)
      if (const std::string name = dxf::after(text.words, dxf_text::piece); !name.empty()) panel_.name = name;
    read_outline();
    for (const dxf::Line& line : piece_.lines) {
      if (line.layer == dxf_layer::cutouts)
        panel_.holes.push_back(read_loop(line, "hole" + std::to_string(panel_.holes.size() + 1) + ".edge"));
      if (line.layer == dxf_layer::lines) read_line(line);
      if (line.layer == dxf_layer::grain && line.vertices.size() == 2)
        panel_.grain = Grain{line.vertices.front().at, line.vertices.back().at};
    }
    for (const dxf::Point& point : piece_.points)
      if (point.layer == dxf_layer::notches) read_notch(point);
    return std::move(panel_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw base::InputError("piece \"" + panel_.name + "\": " + problem);
  }

  static bool is_closed(const dxf::Line& line) {
    return line.closed ||
           (line.vertices.size() > 2 && (line.vertices.front().at - line.vertices.back().at).norm() < same);
  }

  /// The sew line if there is one, since the boundary then has a seam allowance; else the boundary.
  void read_outline() {
    for (const char* layer : {dxf_layer::sew_lines, dxf_layer::boundary}) {
      const dxf::Line* outline = nullptr;
      for (const dxf::Line& line : piece_.lines) {
        if (line.layer != layer || !is_closed(line)) continue;
        if (outline != nullptr) fail(std::string("layer ") + layer + " has two closed polylines; one outlines a piece");
        outline = &line;
      }
      if (outline == nullptr) continue;
      panel_.outline = read_loop(*outline, "edge");
      return;
    }
    fail("there is no closed polyline on layer 1 (piece boundary) or 14 (sew line)");
  }

  bool has_point(const char* layer, const Vec2& at) const {
    return std::any_of(piece_.points.begin(), piece_.points.end(),
                       [&](const dxf::Point& point) { return point.layer == layer && (point.at - at).norm() < same; });
  }

  /// Name of our note at a place; empty if there is none.
  std::string note(const char* keyword, const Vec2& at) const {
    for (const dxf::Text& text : piece_.texts)
      if ((text.at - at).norm() < 0.1)
        if (std::string name = dxf::after(text.words, keyword); !name.empty()) return name;
    return "";
  }

  /// Vertices without repeated ones; a closed line does not repeat its first.
  static std::vector<dxf::Vertex> distinct(const dxf::Line& line, bool closed) {
    std::vector<dxf::Vertex> all;
    for (const dxf::Vertex& v : line.vertices)
      if (all.empty() || (v.at - all.back().at).norm() > same) all.push_back(v);
    while (closed && all.size() > 1 && (all.front().at - all.back().at).norm() <= same) all.pop_back();
    return all;
  }

  /// Vertices where edges end: turn points, or corners where the file has no turn points for this line.
  std::vector<bool> ends_of(const std::vector<dxf::Vertex>& v, bool closed) const {
    const std::size_t n = v.size();
    std::vector<bool> ends(n, false);
    for (std::size_t k = 0; k < n; ++k) ends[k] = has_point(dxf_layer::turn_points, v[k].at);
    if (std::find(ends.begin(), ends.end(), true) == ends.end())
      for (std::size_t k = 0; k < n; ++k) {
        if (!closed && (k == 0 || k + 1 == n)) continue;
        const Vec2 in = v[k].at - v[(k + n - 1) % n].at, out = v[(k + 1) % n].at - v[k].at;
        ends[k] = std::acos(std::clamp(in.normalized().dot(out.normalized()), -1.0, 1.0)) > corner;
      }
    return ends;
  }

  /// Curve through the vertices of one run: a spline, or arcs and lines where there are arcs.
  static Curve curve_of(const std::vector<dxf::Vertex>& run) {
    if (std::none_of(run.begin(), run.end() - 1, [](const dxf::Vertex& v) { return v.bulge != 0.0; })) {
      std::vector<Vec2> points;
      for (const dxf::Vertex& v : run) points.push_back(v.at);
      return Curve::spline(points);
    }
    std::vector<Curve> parts;
    for (std::size_t k = 0; k + 1 < run.size(); ++k) {
      const Vec2 &a = run[k].at, &b = run[k + 1].at;
      const double bulge = run[k].bulge, size = std::abs(bulge);
      if (size < 1e-9) {
        parts.push_back(Curve::line(a, b));
        continue;
      }
      const double radius = (b - a).norm() * (1.0 + size * size) / (4.0 * size);
      if (!(radius < largest_coordinate * 1e3))
        throw base::InputError("the bulge of a vertex is out of all proportion");
      parts.push_back(Curve::circular(a, b, radius, size > 1.0, bulge > 0.0));
    }
    return Curve::joined(parts);
  }

  /// Smooth runs between the ends.
  std::vector<Curve> runs_of(const dxf::Line& line, bool closed) const {
    std::vector<dxf::Vertex> v = distinct(line, closed);
    if (v.size() < 2) fail("a line on layer " + line.layer + " has fewer than two different points");
    std::vector<bool> ends = ends_of(v, closed);
    if (closed) {
      const auto first = std::find(ends.begin(), ends.end(), true);
      const auto start = first == ends.end() ? 0 : first - ends.begin();
      std::rotate(v.begin(), v.begin() + start, v.end());
      std::rotate(ends.begin(), ends.begin() + start, ends.end());
      v.push_back(v.front());
      ends.push_back(true);
    }
    std::vector<Curve> runs;
    std::vector<dxf::Vertex> run{v.front()};
    for (std::size_t k = 1; k < v.size(); ++k) {
      run.push_back(v[k]);
      if (!ends[k] && k + 1 < v.size()) continue;
      runs.push_back(curve_of(run));
      run = {v[k]};
    }
    return runs;
  }

  /// Runs that follow each other under one name are one edge.
  Loop read_loop(const dxf::Line& line, const std::string& default_name) const {
    Loop loop;
    int number = 0;
    for (const Curve& run : runs_of(line, true)) {
      std::string name = note(dxf_text::edge, run.at(0.5));
      ++number;
      if (!name.empty() && !loop.empty() && loop.back().name == name) {
        loop.back().curve = Curve::joined({loop.back().curve, run});
        continue;
      }
      loop.push_back({name.empty() ? default_name + std::to_string(number) : name, run});
    }
    return loop;
  }

  void read_line(const dxf::Line& line) {
    const Curve curve = Curve::joined(runs_of(line, is_closed(line)));
    const std::string name = note(dxf_text::line, curve.front());
    panel_.lines.push_back({name.empty() ? "line" + std::to_string(panel_.lines.size() + 1) : name, curve});
  }

  void read_notch(const dxf::Point& point) {
    double best = 1e300;
    Notch notch;
    const auto look = [&](const Edge& edge) {
      const double at = nearest(edge.curve, point.at), distance = (edge.curve.at(at) - point.at).norm();
      if (distance >= best) return;
      best = distance;
      notch.edge = edge.name;
      notch.at = at;
    };
    for (const Edge& edge : panel_.outline) look(edge);
    for (const Loop& hole : panel_.holes)
      for (const Edge& edge : hole) look(edge);
    notch.name = note(dxf_text::notch, point.at);
    if (notch.name.empty()) notch.name = "notch" + std::to_string(panel_.notches.size() + 1);
    panel_.notches.push_back(notch);
  }

  dxf::Piece piece_;
  Panel panel_;
};

}  // namespace

Pattern read_dxf(const std::string& path) {
  const dxf::File file = dxf::read_pieces(path);
  try {
    if (file.blocks.empty())
      throw base::InputError("there is no block in this file; ASTM D6673 has one for each piece");
    if (file.mm == 0.0)
      throw base::InputError(
          "the file does not tell its unit; ASTM D6673 has the text \"UNITS: METRIC\" (mm) or \"UNITS: ENGLISH\" "
          "(inch), "
          "others the variable $INSUNITS (1: inch, 4: mm, 5: cm, 6: m)");
    Pattern pattern;
    for (const dxf::Piece& block : file.blocks)
      if (!block.lines.empty()) pattern.panels.push_back(PieceReader(block, file.mm).run());
    return pattern;
  } catch (const base::InputError& error) {
    throw base::InputError(path + ": " + error.what());
  }
}

}  // namespace toile::pattern
