#include "toile/drape/drape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "normals.hpp"

namespace toile::drape {

namespace {

using mesh::Vec3;

/// Two nodes whose distance is that of the pattern if it can be.
struct Side {
  int a, b;
  double length;  ///< mm
  bool diagonal;
};

/// Length of a line of the pattern in fabric that is stretched along its wales and courses.
double stretched(const mesh::Vec2& line, double wale_angle, const Options& options) {
  const mesh::Vec2 wale(std::cos(wale_angle), std::sin(wale_angle)), course(-wale.y(), wale.x());
  return std::hypot(options.stretch_wale * line.dot(wale), options.stretch_course * line.dot(course));
}

/// Sides and diagonals of all elements, each once.
std::vector<Side> sides_of(const mesh::Mesh& mesh, const Options& options) {
  std::map<std::pair<int, int>, Side> pairs;
  for (const mesh::Block& block : mesh.blocks) {
    const std::size_t per = static_cast<std::size_t>(block.nodes_per_element);
    for (std::size_t e = 0; e < block.connectivity.size(); e += per)
      for (std::size_t i = 0; i < per; ++i)
        for (std::size_t j = 0; j < i; ++j) {
          const std::pair<int, int> pair = std::minmax(block.connectivity[e + i], block.connectivity[e + j]);
          const mesh::Vec2 line = mesh.pattern[pair.second] - mesh.pattern[pair.first];
          pairs[pair] = {pair.first, pair.second, stretched(line, block.wale_angle[e / per], options),
                         per == 4 && i - j == 2};
        }
  }
  std::vector<Side> sides;
  for (const auto& entry : pairs) sides.push_back(entry.second);
  return sides;
}

class Draping {
 public:
  Draping(mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters, const std::vector<Held>& held,
          const body::Surface& body, const Options& options)
      : mesh_(mesh),
        held_(held),
        body_(body),
        options_(options),
        at_(mesh.placed),
        sides_(sides_of(mesh, options)),
        clearance_(at_.size(), 0.0),
        near_(at_.size()) {
    for (std::size_t c = 0; c < clusters.size(); ++c)
      if (clusters[c].size() > 1) sewn_.push_back({static_cast<int>(c), clusters[c]});
  }

  Outcome run() {
    Outcome outcome;
    constexpr double closed = 0.2, at_rest = 0.005;  // mm
    int& round = outcome.rounds;
    for (double stretch = 1.0; round < options_.most_rounds; ++round) {
      // Seams are drawn gently at first, so that panels come round the body before they are tight. What the body makes
      // too long is then spread over the panels, as springs spread it.
      const double drawn = std::min(1.0, 0.05 + static_cast<double>(round) / 200.0);
      outcome.last_move = one_round(drawn, stretch);
      if (opening(outcome) >= closed) continue;
      stretch = evenly;
      if (outcome.last_move < at_rest) break;
    }
    tie();
    find_largest_stretch(outcome);
    mesh_.placed = at_;
    mesh_.normal = nodal_normals(mesh_);
    return outcome;
  }

 private:
  struct Sewn {
    int cluster;
    std::vector<int> nodes;
  };
  /// The body beside a node, as it was when it was asked last.
  struct Near {
    bool known = false;
    Vec3 asked = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double gap = 0.0;  ///< mm
  };
  static constexpr double evenly = 0.3, weak = 0.1;  ///< parts of sides and of diagonals

  /// Returns the largest move.
  double one_round(double drawn, double stretch) {
    const std::vector<Vec3> before = at_;
    for (const Side& side : sides_) pull(side, stretch);
    for (const Sewn& sewn : sewn_) {  // last: what is sewn stays together, and the sides between give way
      const Vec3 mean = middle(sewn);
      for (const int n : sewn.nodes) at_[n] += drawn * (mean - at_[n]);
    }
    double largest = 0.0;
    for (std::size_t n = 0; n < at_.size(); ++n) {
      Vec3 move = at_[n] - before[n];
      if (move.norm() > options_.largest_move) at_[n] = before[n] + move * (options_.largest_move / move.norm());
      push_out(n, (at_[n] - before[n]).norm());
    }
    for (const Held& held : held_) {
      const double shift = held.direction.dot(mesh_.placed[held.node] - at_[held.node]);
      at_[held.node] += shift * held.direction;
      clearance_[held.node] -= std::abs(shift);
    }
    for (std::size_t n = 0; n < at_.size(); ++n) {
      largest = std::max(largest, (at_[n] - before[n]).norm());
    }
    return largest;
  }

  /// Takes a part of what a side is too long or too short: `stretch` of what it is too long.
  void pull(const Side& side, double stretch) {
    const Vec3 way = at_[side.b] - at_[side.a];
    const double length = way.norm();
    if (length <= 0.0) return;
    const double part = side.diagonal ? weak : length > side.length ? stretch : evenly;
    const Vec3 half = 0.5 * part * (length - side.length) / length * way;
    at_[side.a] += half;
    at_[side.b] -= half;
  }

  /// The distance to the body falls by no more than a node moves: it is asked for only where it may have been used up,
  /// and not again before the node has left the place where the body is as good as a plane.
  void push_out(std::size_t n, double moved) {
    clearance_[n] -= moved;
    if (clearance_[n] > 0.0) return;
    constexpr double plane = 1.0;  // mm: at a radius of 20 mm it is off by 0.025 mm
    Near& near = near_[n];
    if (!near.known || (at_[n] - near.asked).norm() > plane) {
      const body::SurfacePoint foot = body_.closest(at_[n]);
      near = {true, at_[n], foot.normal, foot.gap};
    }
    const double inside = options_.distance - near.gap - near.normal.dot(at_[n] - near.asked);
    if (inside > 0.0) at_[n] += inside * near.normal;
    clearance_[n] = std::max(0.0, -inside);
  }

  Vec3 middle(const Sewn& sewn) const {
    Vec3 sum = Vec3::Zero();
    for (const int n : sewn.nodes) sum += at_[n];
    return sum / static_cast<double>(sewn.nodes.size());
  }

  double opening(Outcome& outcome) const {
    outcome.largest_opening = 0.0;
    for (const Sewn& sewn : sewn_) {
      const Vec3 mean = middle(sewn);
      for (const int n : sewn.nodes) {
        const double opening = 2.0 * (at_[n] - mean).norm();
        if (opening <= outcome.largest_opening) continue;
        outcome.largest_opening = opening;
        outcome.widest = sewn.cluster;
      }
    }
    return outcome.largest_opening;
  }

  void tie() {
    for (const Sewn& sewn : sewn_) {
      const Vec3 mean = middle(sewn);
      for (const int n : sewn.nodes) at_[n] = mean;
    }
  }

  void find_largest_stretch(Outcome& outcome) const {
    for (const Side& side : sides_) {
      const double stretch =
          (at_[side.a] - at_[side.b]).norm() / (mesh_.pattern[side.a] - mesh_.pattern[side.b]).norm();
      if (side.diagonal || stretch <= outcome.largest_stretch) continue;
      outcome.largest_stretch = stretch;
      outcome.most_stretched = side.a;
    }
  }

  mesh::Mesh& mesh_;
  const std::vector<Held>& held_;
  const body::Surface& body_;
  const Options& options_;
  std::vector<Vec3> at_;
  std::vector<Side> sides_;
  std::vector<Sewn> sewn_;
  std::vector<double> clearance_;  ///< [node] mm that it may move before it can be in the body
  std::vector<Near> near_;
};

}  // namespace

Outcome drape(mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters, const std::vector<Held>& held,
              const body::Surface& body, const Options& options) {
  return Draping(mesh, clusters, held, body, options).run();
}

base::Spec drape_spec() {
  return base::Spec(
             "Drape",
             "Lays the placed panels round the body and draws their seams together before anything is solved, by "
             "cheap geometric rounds: a start on the body with closed seams, which stages of type \"settle\" take "
             "to equilibrium.")
      .real("distance", "mm", "Of the fabric from the body that is kept.", 1.0, base::Range::positive())
      .real("largest move", "mm", "Of a node in a round; less than half of the thinnest limb.", 4.0,
            base::Range::positive())
      .real("stretch along wale", "",
            "Of the fabric where it lies: a garment that is smaller than the body everywhere comes evenly round it if "
            "this is about what it will be.",
            1.0, base::Range::at_least(1.0))
      .real("stretch along course", "", "The same along the courses.", 1.0, base::Range::at_least(1.0))
      .integer("most rounds", "After which the seams must be closed.", 2000, base::Range::at_least(1));
}

Options read_options(const base::List& list) {
  return {list.integer("most rounds"), list.real("distance"), list.real("largest move"),
          list.real("stretch along wale"), list.real("stretch along course")};
}

}  // namespace toile::drape
