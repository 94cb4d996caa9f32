#include "seeds.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "graded_seeds.hpp"
#include "toile/base/error.hpp"

namespace toile::garment {
namespace {

/// Relative arc lengths that are no further apart are one place.
constexpr double same = 1e-6;
/// Of the wanted distance of nodes: places that are closer to each other are meant to be one.
constexpr double closest = 0.01;
/// More on one edge come of seams that shift places round and round.
constexpr std::size_t most_places = 2000;

/// Adds a place unless it is there; true if it was added.
bool add_place(Fractions& places, double at) {
  const auto next = std::lower_bound(places.begin(), places.end(), at);
  if (next != places.end() && *next - at <= same) return false;
  if (next != places.begin() && at - *(next - 1) <= same) return false;
  places.insert(next, at);
  return true;
}

/// Index of a place that is there.
std::size_t index_of(const Fractions& places, double at) {
  return static_cast<std::size_t>(std::lower_bound(places.begin(), places.end(), at - same) - places.begin());
}

class Planner {
 public:
  Planner(const std::vector<SeededEdge>& edges, const std::vector<SeededSeam>& seams)
      : edges_(edges), seams_(seams), places_(edges.size()) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      places_[e] = {0.0, 1.0};
      for (const double at : edges[e].kept) add_place(places_[e], at);
      for (const double at : edges[e].dictated) add_place(places_[e], at);
    }
  }

  std::vector<Fractions> plan() {
    for (const SeededSeam& seam : seams_)
      for (const SeededSeam::Side* side : {&seam.first, &seam.second}) {
        add_place(places_[side->edge], side->from);
        add_place(places_[side->edge], side->to);
      }
    while (spread_places(most_places)) {
    }
    check_dictated();
    check_distances();
    grade();
    return seeds();
  }

 private:
  using Side = SeededSeam::Side;

  static double carried(double at, const Side& from, const Side& to, bool reversed) {
    const double share = (at - from.from) / (from.to - from.from);
    return to.from + (reversed ? 1.0 - share : share) * (to.to - to.from);
  }

  /// Carries the places of each seam's sides to the other side; true if there was a new one.
  bool spread_places(std::size_t most) {
    bool is_new = false;
    for (const SeededSeam& seam : seams_)
      for (const bool forth : {true, false}) {
        const Side& from = forth ? seam.first : seam.second;
        const Side& to = forth ? seam.second : seam.first;
        const Fractions places = places_[from.edge];
        for (const double at : places)
          if (at > from.from - same && at < from.to + same)
            is_new = add_place(places_[to.edge], carried(at, from, to, seam.reversed)) || is_new;
        if (places_[to.edge].size() > most)
          throw base::InputError("the seams round edge \"" + edges_[to.edge].name +
                                 "\" carry the ends of parts from edge to edge without end: some part of an edge is "
                                 "sewn to a shifted part of itself");
      }
    return is_new;
  }

  /// Nodes that a mesher dictates cannot have others between them.
  void check_dictated() const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (edges_[e].dictated.empty() || places_[e].size() == edges_[e].dictated.size()) continue;
      throw base::InputError("edge \"" + edges_[e].name + "\" has " + std::to_string(edges_[e].dictated.size()) +
                             " nodes in rows of elements, but its seams need nodes at " +
                             std::to_string(places_[e].size() - edges_[e].dictated.size()) +
                             " other places, where parts or elements of the other edge end: give both edges the same "
                             "number of elements, end parts at nodes, or mesh its panel freely");
    }
  }

  /// Two ends of parts, lines or zones that are meant to be one, on either side of a seam, leave a sliver of elements.
  void check_distances() const {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (std::size_t k = 1; k < places_[e].size() && edges_[e].dictated.empty(); ++k) {
        const double apart = (places_[e][k] - places_[e][k - 1]) * edges_[e].length;
        if (apart >= closest * edges_[e].size) continue;
        std::ostringstream text;
        text << "edge \"" << edges_[e].name << "\" needs two nodes that are " << apart << " mm apart, at "
             << places_[e][k - 1] * edges_[e].length << " mm along it, with elements of " << edges_[e].size
             << " mm: a part, notch, line or zone ends there on either side of its seam. Let them end at one place, or "
                "further apart";
        throw base::InputError(text.str());
      }
  }

  /// Part k of edge e, among all parts between two places.
  std::size_t part(std::size_t e, std::size_t k) const { return first_part_[e] + k; }

  /// Parts that are sewn together, as sets.
  void join_parts(boost::disjoint_sets<int*, std::size_t*>& sets) const {
    for (const SeededSeam& seam : seams_) {
      const Fractions& a = places_[seam.first.edge];
      const std::size_t first = index_of(a, seam.first.from), last = index_of(a, seam.first.to);
      const Fractions& b = places_[seam.second.edge];
      for (std::size_t k = first; k < last; ++k) {
        const double start = seam.reversed ? a[k + 1] : a[k];
        sets.union_set(part(seam.first.edge, k),
                       part(seam.second.edge, index_of(b, carried(start, seam.first, seam.second, seam.reversed))));
      }
    }
  }

  /// [part] A number that parts which are sewn together share.
  std::vector<std::size_t> sets_of_parts() {
    std::size_t parts = 0;
    first_part_.clear();
    for (const Fractions& places : places_) {
      first_part_.push_back(parts);
      parts += places.size() - 1;
    }
    std::vector<int> rank(parts, 0);
    std::vector<std::size_t> parent(parts), set(parts);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    boost::disjoint_sets<int*, std::size_t*> sets(rank.data(), parent.data());
    join_parts(sets);
    for (std::size_t p = 0; p < parts; ++p) set[p] = sets.find_set(p);
    return set;
  }

  /// Divides the parts whose size varies: of those that are sewn together the one that asks for most nodes leads.
  void grade() {
    const std::vector<std::size_t> set = sets_of_parts();
    std::map<std::size_t, std::pair<std::size_t, Fractions>> leader;  // [set] edge and places
    std::set<std::size_t> dictated;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (std::size_t k = 0; k + 1 < places_[e].size(); ++k) {
        if (!edges_[e].dictated.empty()) dictated.insert(set[part(e, k)]);
        Fractions graded = graded_places(edges_[e], places_[e][k], places_[e][k + 1]);
        auto& [edge, places] = leader[set[part(e, k)]];
        if (graded.size() <= places.size()) continue;
        edge = e;
        places = std::move(graded);
      }
    for (const auto& [number, lead] : leader)
      for (const double at : lead.second)
        if (dictated.count(number) == 0) add_place(places_[lead.first], at);
    while (spread_places(std::numeric_limits<std::size_t>::max())) {
    }
  }

  std::vector<Fractions> seeds() {
    const std::vector<std::size_t> set = sets_of_parts();
    std::map<std::size_t, int> sides;  // [set]
    for (const bool dictated : {false, true})
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (std::size_t k = 0; k + 1 < places_[e].size() && edges_[e].dictated.empty() != dictated; ++k) {
          int& count = sides[set[part(e, k)]];
          const double wanted = wanted_pairs(edges_[e], places_[e][k], places_[e][k + 1]);
          const int pairs = static_cast<int>(std::ceil(wanted - (edges_[e].finer ? 0.02 : 1e-6)));
          count = dictated ? 1 : std::max({count, 2, 2 * pairs});
        }
    std::vector<Fractions> all;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      all.push_back({0.0});
      for (std::size_t k = 0; k + 1 < places_[e].size(); ++k) {
        const int count = sides[set[part(e, k)]];
        const double from = places_[e][k], to = places_[e][k + 1];
        for (int i = 1; i <= count; ++i) all.back().push_back(from + (to - from) * i / count);
      }
      all.back().back() = 1.0;
    }
    return all;
  }

  const std::vector<SeededEdge>& edges_;
  const std::vector<SeededSeam>& seams_;
  std::vector<Fractions> places_;        ///< [edge] where nodes must lie
  std::vector<std::size_t> first_part_;  ///< [edge]
};

}  // namespace

std::vector<Fractions> plan_seeds(const std::vector<SeededEdge>& edges, const std::vector<SeededSeam>& seams) {
  return Planner(edges, seams).plan();
}

}  // namespace toile::garment
