#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "format.hpp"
#include "json_keys.hpp"
#include "segment.hpp"
#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

using Json = nlohmann::ordered_json;

/// Relative arc lengths that are no further apart are one place.
constexpr double same = 1e-9;
/// Arcs are written in parts that turn by no more than this, radians.
constexpr double most_turn = 2.0;

/// Places where an edge is cut into edges of the format, each one segment and sewn as a whole or not at all.
class Cuts {
 public:
  explicit Cuts(const Pattern& pattern) {
    for (const Stitch& stitch : pattern.stitches) pairs_.push_back(pair_of(pattern, stitch));
    for (int round = 0; round < 20; ++round) {
      bool added = false;
      for (const Pair& pair : pairs_) {
        added = carry(pair.first, pair.second, pair.reversed) || added;
        added = carry(pair.second, pair.first, pair.reversed) || added;
      }
      if (!added) return;
    }
    throw base::InputError(
        "this pattern cannot be written as JSON: its stitches join parts of edges in a circle, so that the edges would "
        "be cut without end");
  }

  /// From 0 to 1.
  std::vector<double> of(const Edge& edge) const {
    const auto known = cuts_.find(&edge);
    return known == cuts_.end() ? of_curve(edge.curve) : known->second;
  }

  /// Those that a curve needs by itself.
  static std::vector<double> of_curve(const Curve& curve) {
    std::vector<double> cuts{0.0, 1.0};
    double at = 0.0;
    for (const Segment& segment : curve.segments()) {
      const double length = arc_length(segment, 0.0, 1.0) / curve.length();
      const int n = parts(segment);
      for (int k = 1; k <= n; ++k) add(cuts, at + length * k / n);
      at += length;
    }
    return cuts;
  }

  /// Pairs of pieces that a stitch joins, by their numbers on the edge.
  std::vector<std::pair<std::size_t, std::size_t>> pieces(std::size_t stitch) const {
    const Pair& pair = pairs_[stitch];
    const std::vector<std::size_t> a = within(pair.first), b = within(pair.second);
    std::vector<std::pair<std::size_t, std::size_t>> all;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
      all.emplace_back(a[k], pair.reversed ? b[b.size() - 1 - k] : b[k]);
    return all;
  }

  const Side& first(std::size_t stitch) const { return pairs_[stitch].first; }
  const Side& second(std::size_t stitch) const { return pairs_[stitch].second; }

 private:
  struct Pair {
    Side first, second;
    bool reversed;
  };

  static Pair pair_of(const Pattern& pattern, const Stitch& stitch) {
    return {find_side(pattern, stitch.first), find_side(pattern, stitch.second), stitch.reversed};
  }

  /// Arcs turn by less than half a circle, and no piece ends where it starts.
  static int parts(const Segment& segment) {
    if (const auto* arc = std::get_if<Arc>(&segment))
      return std::max(1, static_cast<int>(std::ceil(std::abs(arc->to - arc->from) / most_turn)));
    const Vec2 chord = value(segment, 1.0) - value(segment, 0.0);
    return chord.norm() < 1e-3 * arc_length(segment, 0.0, 1.0) ? 2 : 1;
  }

  static bool add(std::vector<double>& cuts, double at) {
    const auto next = std::lower_bound(cuts.begin(), cuts.end(), at - same);
    if (next == cuts.end() || *next < at + same) return false;
    cuts.insert(next, at);
    return true;
  }

  /// Cuts the second side where the first one is cut.
  bool carry(const Side& from, const Side& to, bool reversed) {
    std::vector<double> cuts = of(*from.part.edge);
    cuts.push_back(from.part.from);
    cuts.push_back(from.part.to);
    cuts_.emplace(to.part.edge, of(*to.part.edge));
    bool added = false;
    for (const double cut : cuts) {
      const double t = (cut - from.part.from) / (from.part.to - from.part.from);
      if (t < -same || t > 1.0 + same) continue;
      const double at = to.part.from + (reversed ? 1.0 - t : t) * (to.part.to - to.part.from);
      added = add(cuts_[to.part.edge], at) || added;
    }
    return added;
  }

  std::vector<std::size_t> within(const Side& side) const {
    const std::vector<double> cuts = of(*side.part.edge);
    std::vector<std::size_t> pieces;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
      if (middle > side.part.from && middle < side.part.to) pieces.push_back(k);
    }
    return pieces;
  }

  std::vector<Pair> pairs_;
  std::map<const Edge*, std::vector<double>> cuts_;
};

Json point(const Vec2& p) {
  return {p.x(), p.y()};
}

/// The one segment that a piece between two cuts consists of; rounding may leave slivers of its neighbours.
Segment piece_of(const Curve& curve, double from, double to) {
  const Curve piece = curve.part(from, to);
  const auto& segments = piece.segments();
  return *std::max_element(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    return arc_length(a, 0.0, 1.0) < arc_length(b, 0.0, 1.0);
  });
}

Json curvature(const Segment& segment) {
  if (const auto* arc = std::get_if<Arc>(&segment))
    return {{"type", "circle"}, {"params", {arc->radius, 0, arc->to > arc->from ? 1 : 0}}};
  const auto& c = std::get<Bezier>(segment).control;
  const Vec2 d = c[3] - c[0], left(-d.y(), d.x());
  const auto relative = [&](const Vec2& p) {
    return point(Vec2((p - c[0]).dot(d), (p - c[0]).dot(left)) / d.squaredNorm());
  };
  return {{"type", "cubic"}, {"params", {relative(c[1]), relative(c[2])}}};
}

class Writer {
 public:
  explicit Writer(const Pattern& pattern) : pattern_(pattern), cuts_(pattern) {}

  Json run() {
    Json panels = Json::object();
    for (const Panel& panel : pattern_.panels) panels[panel.name] = panel_json(panel);
    return {{"pattern", {{"panels", panels}, {"stitches", stitches()}, {json_key, {{"stitches", own_stitches()}}}}},
            {"properties",
             {{"curvature_coords", "relative"}, {"normalize_panel_translation", false}, {"units_in_meter", 1000}}}};
  }

 private:
  /// `closed`: the last edge ends at the first vertex.
  Json edges_json(const Loop& loop, bool closed) {
    Json vertices = Json::array(), edges = Json::array();
    for (const Edge& edge : loop) {
      const std::vector<double> cuts = cuts_.of(edge);
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const Segment piece = piece_of(edge.curve, cuts[k], cuts[k + 1]);
        Json json = {{"endpoints", {vertices.size(), vertices.size() + 1}}};
        vertices.push_back(point(edge.curve.at(cuts[k])));
        if (!is_line(piece)) json["curvature"] = curvature(piece);
        json[json_key] = edge.name;
        edges.push_back(json);
      }
    }
    if (closed) {
      edges.back()["endpoints"][1] = 0;
    } else {
      vertices.push_back(point(loop.back().curve.back()));
    }
    return {{"vertices", vertices}, {"edges", edges}};
  }

  Json panel_json(const Panel& panel) {
    const Placement placement = panel.placement.value_or(Placement());
    const Eigen::Vector3d angles = placement.rotation.eulerAngles(2, 1, 0) * 180.0 / M_PI;
    Json json = {{"translation", {placement.translation.x(), placement.translation.y(), placement.translation.z()}},
                 {"rotation", {angles[2], angles[1], angles[0]}}};
    json.update(edges_json(panel.outline, true));
    const Json extra = extras(panel);
    if (!extra.empty()) json[json_key] = extra;
    return json;
  }

  Json extras(const Panel& panel) {
    Json json = Json::object();
    for (const Loop& hole : panel.holes) json["holes"].push_back(edges_json(hole, true));
    for (const InternalLine& line : panel.lines) {
      Json lines = edges_json({{line.name, line.curve}}, false);
      lines["name"] = line.name;
      json["lines"].push_back(lines);
    }
    for (const Notch& notch : panel.notches)
      json["notches"].push_back({{"name", notch.name}, {"edge", notch.edge}, {"at", notch.at}});
    if (panel.grain) json["grain"] = {{"from", point(panel.grain->from)}, {"to", point(panel.grain->to)}};
    return json;
  }

  std::map<std::string, std::size_t> first_pieces(const Panel& panel) {
    std::map<std::string, std::size_t> numbers;
    std::size_t number = 0;
    for (const Edge& edge : panel.outline) {
      numbers[edge.name] = number;
      number += cuts_.of(edge).size() - 1;
    }
    return numbers;
  }

  Json side(const Side& side, std::size_t piece) {
    const auto numbers = first_pieces(*side.panel);
    const auto found = numbers.find(side.part.edge->name);
    if (found == numbers.end())
      throw base::InputError("panel \"" + side.panel->name + "\": a stitch joins edge \"" + side.part.edge->name +
                             "\" of a hole, which the JSON format cannot tell");
    return {{"panel", side.panel->name}, {"edge", found->second + piece}};
  }

  Json stitches() {
    Json all = Json::array();
    for (std::size_t k = 0; k < pattern_.stitches.size(); ++k)
      for (const auto& [a, b] : cuts_.pieces(k)) {
        Json pair = {side(cuts_.first(k), a), side(cuts_.second(k), b)};
        if (!pattern_.stitches[k].reversed) pair.push_back("right_wrong");
        all.push_back(pair);
      }
    return all;
  }

  Json own_stitches() const {
    Json all = Json::array();
    for (const Stitch& stitch : pattern_.stitches)
      all.push_back(
          {{"name", stitch.name}, {"first", stitch.first}, {"second", stitch.second}, {"reversed", stitch.reversed}});
    return all;
  }

  const Pattern& pattern_;
  Cuts cuts_;
};

}  // namespace

void write_json(const Pattern& pattern, const std::string& path) {
  try {
    replace_content(path, Writer(pattern).run().dump(1) + "\n");
  } catch (const nlohmann::json::exception& error) {
    throw base::InputError(path + ": cannot write this pattern: " + error.what());
  }
}

Format json_format() {
  return {".json", "panels and stitches of Garment-Pattern-Generator and GarmentCode", read_json, write_json};
}

}  // namespace toile::pattern
