#include <Eigen/Geometry>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "format.hpp"
#include "json_keys.hpp"
#include "json_node.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "toile/base/parameters.hpp"

namespace toile::pattern {
namespace {

using Json = nlohmann::json;
using json::Node;

/// Which edge a number of the file stands for, and which part of it if an edge of ours was written as several.
struct Piece {
  std::string edge;
  double from = 0.0, to = 1.0;
};

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  Pattern run(const Json& json) {
    const Node file(json, path_);
    const Node properties = file.at("properties");
    const double units = properties.at("units_in_meter").number();
    if (!(units >= 1e-3 && units <= 1e6)) properties.at("units_in_meter").fail("allowed are 0.001 to 1e6");
    unit_ = 1000.0 / units;
    relative_ = read_relative(properties);
    normalize_ = properties.has("normalize_panel_translation") && properties.at("normalize_panel_translation").flag();
    const Node pattern = file.at("pattern");
    pattern.at("panels").for_each_member([&](const std::string& name, const Node& node) {
      pattern_.panels.push_back(read_panel(name, node.called(path_ + ": panel \"" + name + "\"")));
    });
    read_stitches(pattern);
    return std::move(pattern_);
  }

 private:
  static bool read_relative(const Node& properties) {
    if (!properties.has("curvature_coords")) return true;
    const std::string word = properties.at("curvature_coords").text();
    if (word != "relative" && word != "absolute")
      properties.at("curvature_coords").fail("\"" + word + "\" is neither \"relative\" nor \"absolute\"");
    return word == "relative";
  }

  Vec2 to_mm(const Node& node) const {
    Vec2 p = unit_ * node.point();
    if (!(p.cwiseAbs().maxCoeff() <= largest_coordinate)) node.fail("this is further away than 1 km");
    return p;
  }

  std::vector<Vec2> read_vertices(const Node& panel) const {
    const Node list = panel.at("vertices");
    std::vector<Vec2> vertices;
    for (std::size_t k = 0; k < list.size(); ++k) vertices.push_back(to_mm(list.at(k)));
    if (vertices.empty()) list.fail("the list is empty");
    return vertices;
  }

  /// Curve of one edge. Relative control points count along the edge and to its left.
  Curve read_curve(const Node& edge, const Vec2& start, const Vec2& end) const {
    if ((end - start).norm() < 1e-9) edge.fail("its two ends are the same point; an edge needs a length");
    if (!edge.has("curvature")) return Curve::line(start, end);
    const Node curvature = edge.at("curvature");
    const auto control = [&](const Node& node) -> Vec2 {
      if (!relative_) return to_mm(node);
      const Vec2 d = end - start, c = node.point();
      if (!(c.cwiseAbs().maxCoeff() <= 1e3)) node.fail("this relative control point is out of all proportion");
      return start + c.x() * d + c.y() * Vec2(-d.y(), d.x());
    };
    if (curvature.is_list()) return Curve::quadratic(start, control(curvature), end);
    const std::string type = curvature.at("type").text();
    const Node params = curvature.at("params");
    if (type == "quadratic") return Curve::quadratic(start, control(params.at(std::size_t{0})), end);
    if (type == "cubic") return Curve::cubic(start, control(params.at(std::size_t{0})), control(params.at(1)), end);
    if (type != "circle")
      curvature.fail("\"" + type + "\" is no type of curve; valid are \"quadratic\", \"cubic\", \"circle\"");
    const double radius = unit_ * params.coordinate(0);
    if (!(radius > 0.0 && radius <= largest_coordinate)) params.fail("the radius must be positive and below 1 km");
    try {
      return Curve::circular(start, end, radius, params.at(1).flag(), params.at(2).flag());
    } catch (const base::InputError& error) {
      curvature.fail(error.what());
    }
  }

  /// Edges of a panel, a hole or an internal line. Pieces that follow each other under one name of ours are one edge.
  Loop read_edges(const Node& node, std::vector<Piece>& pieces) const {
    const std::vector<Vec2> vertices = read_vertices(node);
    const Node list = node.at("edges");
    std::vector<std::string> names = edge_names(list);
    Loop loop;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Node edge = list.at(k).called(node.place() + ", edge " + std::to_string(k));
      const Node ends = edge.at("endpoints");
      const Curve curve = read_curve(edge, vertices[ends.at(std::size_t{0}).index(vertices.size())],
                                     vertices[ends.at(1).index(vertices.size())]);
      if (loop.empty() || loop.back().name != names[k]) {
        loop.push_back({names[k], curve});
      } else {
        if ((loop.back().curve.back() - curve.front()).norm() > 1e-6)
          edge.fail("it goes on with edge \"" + names[k] + "\" but starts elsewhere");
        loop.back().curve = Curve::joined({loop.back().curve, curve});
      }
      pieces.push_back({names[k], loop.back().curve.length() - curve.length(), loop.back().curve.length()});
    }
    for (Piece& piece : pieces)
      for (const Edge& edge : loop)
        if (edge.name == piece.edge) {
          piece.from /= edge.curve.length();
          piece.to /= edge.curve.length();
        }
    return loop;
  }

  /// Names of ours, else labels that are unique in the panel, else numbers.
  static std::vector<std::string> edge_names(const Node& list) {
    std::map<std::string, int> labels;
    for (std::size_t k = 0; k < list.size(); ++k)
      if (list.at(k).has("label") && list.at(k).at("label").is_text()) ++labels[list.at(k).at("label").text()];
    std::vector<std::string> names;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Node edge = list.at(k);
      std::string name = "edge" + std::to_string(k);
      if (edge.has("label") && edge.at("label").is_text() && labels[edge.at("label").text()] == 1 &&
          !edge.at("label").text().empty())
        name = edge.at("label").text();
      if (edge.has(json_key)) name = edge.at(json_key).text();
      names.push_back(name);
    }
    return names;
  }

  Panel read_panel(const std::string& name, const Node& node) {
    Panel panel;
    panel.name = name;
    std::vector<Piece>& pieces = pieces_[name];
    panel.outline = read_edges(node, pieces);
    if (panel.outline.empty()) node.at("edges").fail("the list is empty");
    panel.placement = read_placement(node);
    if (node.has(json_key)) read_extras(node.at(json_key), panel);
    turn(panel);
    return panel;
  }

  Placement read_placement(const Node& node) const {
    Placement placement;
    if (node.has("rotation")) {
      const Node rotation = node.at("rotation");
      const auto turn = [&](std::size_t k) {
        return Eigen::AngleAxisd(rotation.coordinate(k) * M_PI / 180.0, Eigen::Vector3d::Unit(static_cast<int>(k)));
      };
      placement.rotation = (turn(2) * turn(1) * turn(0)).toRotationMatrix();
      if (!placement.rotation.allFinite()) rotation.fail("these are no angles");
    }
    if (node.has("translation")) {
      const Node translation = node.at("translation");
      for (std::size_t k = 0; k < 3; ++k) {
        const double value = unit_ * translation.coordinate(k);
        if (!(std::abs(value) <= largest_coordinate)) translation.fail("this is further away than 1 km");
        placement.translation[static_cast<int>(k)] = value;
      }
    }
    if (normalize_) {
      const std::vector<Vec2> vertices = read_vertices(node);
      Vec2 mean = Vec2::Zero();
      for (const Vec2& v : vertices) mean += v / static_cast<double>(vertices.size());
      const Eigen::Vector3d shift(mean.x(), mean.y(), 0.0);
      placement.translation += shift - placement.rotation * shift;
    }
    return placement;
  }

  /// What the format has no words for.
  void read_extras(const Node& node, Panel& panel) const {
    std::vector<Piece> unused;
    if (node.has("holes"))
      for (std::size_t k = 0; k < node.at("holes").size(); ++k)
        panel.holes.push_back(read_edges(node.at("holes").at(k), unused));
    if (node.has("lines"))
      for (std::size_t k = 0; k < node.at("lines").size(); ++k) {
        const Node line = node.at("lines").at(k);
        std::vector<Curve> curves;
        for (const Edge& edge : read_edges(line, unused)) curves.push_back(edge.curve);
        if (curves.empty()) line.fail("it has no edges");
        panel.lines.push_back({line.at("name").text(), Curve::joined(curves)});
      }
    if (node.has("notches"))
      for (std::size_t k = 0; k < node.at("notches").size(); ++k) {
        const Node notch = node.at("notches").at(k);
        panel.notches.push_back({notch.at("name").text(), notch.at("edge").text(), notch.at("at").number()});
      }
    if (node.has("grain")) panel.grain = Grain{to_mm(node.at("grain").at("from")), to_mm(node.at("grain").at("to"))};
  }

  /// Edges run counter-clockwise seen from the right side. A panel that is drawn from its wrong side is mirrored, and
  /// turned about the y axis in space, so that it stays where it is.
  static void turn(Panel& panel) {
    double twice_area = 0.0;
    for (const Edge& edge : panel.outline) {
      const std::vector<Vec2> points = edge.curve.points(1e-3 * edge.curve.length());
      for (std::size_t k = 1; k < points.size(); ++k)
        twice_area += points[k - 1].x() * points[k].y() - points[k].x() * points[k - 1].y();
    }
    if (twice_area >= 0.0) return;
    const auto mirror = [](Curve& curve) { curve = curve.mirrored(Vec2::Zero(), Vec2::UnitY()); };
    for (Edge& edge : panel.outline) mirror(edge.curve);
    for (Loop& hole : panel.holes)
      for (Edge& edge : hole) mirror(edge.curve);
    for (InternalLine& line : panel.lines) mirror(line.curve);
    if (panel.grain) {
      panel.grain->from.x() *= -1.0;
      panel.grain->to.x() *= -1.0;
    }
    panel.placement->rotation *= Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal();
  }

  std::string read_side(const Node& node) const {
    const std::string panel = node.at("panel").text();
    const auto found = pieces_.find(panel);
    if (found == pieces_.end()) {
      base::Texts names;
      for (const auto& entry : pieces_) names.push_back(entry.first);
      node.at("panel").fail("there is no panel \"" + panel + "\"" + base::hint(panel, names));
    }
    const Piece& piece = found->second[node.at("edge").index(found->second.size())];
    std::string name = panel + "." + piece.edge;
    if (piece.from == 0.0 && piece.to == 1.0) return name;
    return name + "[" + number_text(piece.from) + ":" + number_text(piece.to) + "]";
  }

  void read_stitches(const Node& pattern) {
    if (pattern.has(json_key)) {
      const Node list = pattern.at(json_key).at("stitches");
      for (std::size_t k = 0; k < list.size(); ++k) {
        const Node stitch = list.at(k);
        pattern_.stitches.push_back({stitch.at("name").text(), stitch.at("first").text(), stitch.at("second").text(),
                                     stitch.at("reversed").flag()});
      }
      return;
    }
    if (!pattern.has("stitches")) return;
    const Node list = pattern.at("stitches");
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string place = path_ + ": stitch " + std::to_string(k);
      const Node pair = list.at(k).called(place);
      const bool same_way = pair.size() > 2 && pair.at(2).is_text() && pair.at(2).text() == "right_wrong";
      if (pair.size() > 2 && !same_way) pair.fail("the third entry must be \"right_wrong\"");
      pattern_.stitches.push_back({"stitch" + std::to_string(k),
                                   read_side(pair.at(std::size_t{0}).called(place + ", first side")),
                                   read_side(pair.at(1).called(place + ", second side")), !same_way});
    }
  }

  const std::string& path_;
  double unit_ = 1.0;
  bool relative_ = true, normalize_ = false;
  Pattern pattern_;
  std::map<std::string, std::vector<Piece>> pieces_;
};

}  // namespace

Pattern read_json(const std::string& path) {
  Json json;
  try {
    json = Json::parse(base::read_file(path, "a JSON file", largest_file));
  } catch (const Json::exception& error) {
    throw base::InputError(path + ": this is no valid JSON: " + error.what());
  }
  try {
    return Reader(path).run(json);
  } catch (const Json::exception& error) {
    throw base::InputError(path + ": " + error.what());
  }
}

}  // namespace toile::pattern
