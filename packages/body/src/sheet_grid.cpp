#include "sheet_grid.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <numeric>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr double most_positions = 2e8;  ///< of the box: a person in cells of 3 mm has 6e7
constexpr int padding = 2;              ///< cells between the facets' box and the grid's border
/// A sample makes the cells active that are within this distance of it, in cells. Samples are half a cell apart, so
/// that all points within a fifth of a cell of the facets are in active cells.
constexpr double reach_of_sample = 0.75;

/// Distance of the local coordinate x from the interval [i, i + 1].
double beyond_side(double x, int i) {
  return std::max({0.0, i - x, x - i - 1.0});
}

/// Neighbours of each sample: others[start[s]] .. others[start[s + 1]].
struct Neighbourhood {
  explicit Neighbourhood(const SurfaceSamples& samples)
      : start(samples.size() + 1, 0), others(2 * samples.links.size()) {
    for (const auto& [a, b] : samples.links) {
      ++start[a + 1];
      ++start[b + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> next(start.begin(), start.end() - 1);
    for (const auto& [a, b] : samples.links) {
      others[next[a]++] = b;
      others[next[b]++] = a;
    }
  }
  std::vector<int> start;
  std::vector<int> others;
};

/// Round the samples on facets.
Eigen::AlignedBox3d box_of_facets(const SurfaceSamples& samples, double cell) {
  std::vector<Vec3> points;
  points.reserve(2 * samples.links.size());
  for (const auto& [a, b] : samples.links) {
    points.push_back(samples.points[a]);
    points.push_back(samples.points[b]);
  }
  return SheetGrid::box_of(points, cell);
}

}  // namespace

SheetGrid::SheetGrid(const SurfaceSamples& samples, double cell) : cell_(cell) {
  make_box(box_of_facets(samples, cell_));
  make_cells(samples);
}

SheetGrid::SheetGrid(const SurfaceSamples& samples, const SheetGrid& coarse) : cell_(0.5 * coarse.cell_) {
  Eigen::AlignedBox3d box = box_of_facets(samples, cell_);
  const Vec3 corner = coarse.local(box.min()).array().floor();
  box.extend(Vec3(coarse.origin_ + coarse.cell_ * corner));
  make_box(box);
  make_cells(samples);
}

void SheetGrid::make_cells(const SurfaceSamples& samples) {
  std::vector<Entry> entries = entries_near(samples);
  part_sheets(samples, &entries);
  number_nodes(neighbours(entries));
  merge_equal_cells(&entries);
  keep_shared(entries);
}

Eigen::AlignedBox3d SheetGrid::box_of(const std::vector<Vec3>& points, double cell) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points) box.extend(point);
  const double positions = (box.sizes() / cell + Vec3::Constant(1 + 2 * padding)).prod();
  if (positions <= most_positions) return box;
  std::ostringstream text;
  text << "the smooth surface of the body would need a grid of " << positions << " cells of " << cell << " mm round "
       << box.sizes().transpose() << " mm, at most " << most_positions
       << " are possible: enlarge \"cell\", or bound the part of the body that the garment can reach (list Reach)";
  throw base::InputError(text.str());
}

void SheetGrid::make_box(const Eigen::AlignedBox3d& box) {
  origin_ = box.min() - Vec3::Constant(padding * cell_);
  for (int axis = 0; axis < 3; ++axis) {
    size_[axis] = static_cast<int>(std::floor(box.sizes()[axis] / cell_)) + 1 + 2 * padding;
  }
}

std::vector<SheetGrid::Entry> SheetGrid::entries_near(const SurfaceSamples& samples) const {
  std::vector<char> used(samples.size(), 0);
  for (const auto& link : samples.links) {
    used[link[0]] = used[link[1]] = 1;
  }
  std::vector<Entry> unsorted;
  std::vector<int> start(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
  for (int s = 0; s < samples.size(); ++s) {
    if (used[s] == 0) continue;
    const Vec3 x = local(samples.points[s]);
    const Eigen::Array3i low = (x.array() - reach_of_sample).floor().cast<int>();
    const Eigen::Array3i high = (x.array() + reach_of_sample).floor().cast<int>();
    for (int i = low[0]; i <= high[0]; ++i) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int k = low[2]; k <= high[2]; ++k) {
          const Vec3 off(beyond_side(x[0], i), beyond_side(x[1], j), beyond_side(x[2], k));
          if (off.squaredNorm() <= reach_of_sample * reach_of_sample) {
            unsorted.push_back({index({i, j, k}), s, -1});
            ++start[unsorted.back().position + 1];
          }
        }
      }
    }
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Entry> entries(unsorted.size());
  for (const Entry& entry : unsorted) {
    entries[start[entry.position]++] = entry;
  }
  return entries;
}

void SheetGrid::part_sheets(const SurfaceSamples& samples, std::vector<Entry>* entries) {
  first_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2], -1);
  const Neighbourhood neighbourhood(samples);
  std::vector<int> place(samples.size(), -1);  // of a sample among the entries of the position at hand
  std::vector<std::size_t> waiting;
  for (std::size_t begin = 0, end = 0; begin < entries->size(); begin = end) {
    const int here = (*entries)[begin].position;
    for (end = begin; end < entries->size() && (*entries)[end].position == here; ++end) {
      place[(*entries)[end].sample] = static_cast<int>(end);
    }
    first_[here] = static_cast<int>(cells_.size());
    for (std::size_t seed = begin; seed < end; ++seed) {
      if ((*entries)[seed].cell >= 0) continue;
      const int cell = static_cast<int>(cells_.size());
      cells_.push_back({position(here), {}, (*entries)[seed].sample});
      (*entries)[seed].cell = cell;
      for (waiting = {seed}; !waiting.empty();) {
        const int sample = (*entries)[waiting.back()].sample;
        waiting.pop_back();
        for (int n = neighbourhood.start[sample]; n < neighbourhood.start[sample + 1]; ++n) {
          const int other = place[neighbourhood.others[n]];
          if (other >= 0 && (*entries)[other].cell < 0) {
            (*entries)[other].cell = cell;
            waiting.push_back(static_cast<std::size_t>(other));
          }
        }
      }
    }
    for (std::size_t e = begin; e < end; ++e) {
      place[(*entries)[e].sample] = -1;
    }
  }
}

std::vector<std::array<std::vector<int>, 3>> SheetGrid::neighbours(const std::vector<Entry>& entries) const {
  const std::array<int, 3> step{size_[1] * size_[2], size_[2], 1};
  std::vector<std::array<std::vector<int>, 3>> beyond(cells_.size());
  std::vector<Entry> by_sample = entries;
  std::stable_sort(by_sample.begin(), by_sample.end(),
                   [](const Entry& a, const Entry& b) { return a.sample < b.sample; });
  for (auto begin = by_sample.begin(), end = begin; begin != by_sample.end(); begin = end) {
    end = std::find_if(begin, by_sample.end(), [begin](const Entry& e) { return e.sample != begin->sample; });
    for (auto a = begin; a != end; ++a) {
      for (auto b = a + 1; b != end; ++b) {
        for (int axis = 0; axis < 3; ++axis) {
          if (b->position == a->position + step[axis]) {
            auto& list = beyond[a->cell][axis];
            if (std::find(list.begin(), list.end(), b->cell) == list.end()) list.push_back(b->cell);
          }
        }
      }
    }
  }
  return beyond;
}

/// A node belongs to one sheet as long as that is in one piece within the node's 4 x 4 x 4 positions.
void SheetGrid::number_nodes(const std::vector<std::array<std::vector<int>, 3>>& beyond) {
  const Position nodes{size_[0] + 3, size_[1] + 3, size_[2] + 3};
  std::vector<char> used(static_cast<std::size_t>(nodes[0]) * nodes[1] * nodes[2], 0);
  for (const Cell& cell : cells_) {
    for (int n = 0; n < 64; ++n) {
      used[((cell.at[0] + n / 16) * nodes[1] + cell.at[1] + n / 4 % 4) * nodes[2] + cell.at[2] + n % 4] = 1;
    }
  }
  std::vector<int> place(cells_.size(), -1);
  std::vector<std::array<int, 2>> around;  // cells that use the node, and the node's number in them
  std::vector<int> rank, parent, unknown;
  for (std::size_t u = 0; u < used.size(); ++u) {
    if (used[u] == 0) continue;
    const int at = static_cast<int>(u);
    const Position node{at / (nodes[1] * nodes[2]), at / nodes[2] % nodes[1], at % nodes[2]};
    around.clear();
    for (int n = 0; n < 64; ++n) {
      const Position p{node[0] - n / 16, node[1] - n / 4 % 4, node[2] - n % 4};
      if (p[0] < 0 || p[1] < 0 || p[2] < 0 || p[0] >= size_[0] || p[1] >= size_[1] || p[2] >= size_[2]) continue;
      for (int c = first_[index(p)]; c >= 0 && c < static_cast<int>(cells_.size()) && cells_[c].at == p; ++c) {
        place[c] = static_cast<int>(around.size());
        around.push_back({c, n});
      }
    }
    rank.resize(around.size());
    parent.resize(around.size());
    boost::disjoint_sets<int*, int*> sheets(rank.data(), parent.data());
    for (std::size_t a = 0; a < around.size(); ++a) {
      sheets.make_set(static_cast<int>(a));
    }
    for (std::size_t a = 0; a < around.size(); ++a) {
      for (const auto& list : beyond[around[a][0]]) {
        for (const int other : list) {
          if (place[other] >= 0) sheets.union_set(static_cast<int>(a), place[other]);
        }
      }
    }
    unknown.assign(around.size(), -1);
    for (std::size_t a = 0; a < around.size(); ++a) {
      int& number = unknown[sheets.find_set(static_cast<int>(a))];
      if (number < 0) {
        number = static_cast<int>(nodes_.size());
        nodes_.push_back(node);
      }
      cells_[around[a][0]].unknowns[around[a][1]] = number;
      place[around[a][0]] = -1;
    }
  }
}

void SheetGrid::merge_equal_cells(std::vector<Entry>* entries) {
  std::vector<int> renumbered(cells_.size());
  std::vector<Cell> kept;
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    int same = static_cast<int>(kept.size());
    while (--same >= 0 && kept[same].at == cells_[c].at && kept[same].unknowns != cells_[c].unknowns) {
    }
    if (same >= 0 && kept[same].at == cells_[c].at) {
      renumbered[c] = same;
    } else {
      renumbered[c] = static_cast<int>(kept.size());
      kept.push_back(cells_[c]);
    }
  }
  for (Entry& entry : *entries) entry.cell = renumbered[entry.cell];
  for (int& first : first_) {
    if (first >= 0) first = renumbered[first];
  }
  cells_ = std::move(kept);
}

void SheetGrid::keep_shared(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries) {
    const auto [first, end] = cells_of(entry.position);
    if (end - first > 1) shared_.push_back({entry.cell, entry.sample});
  }
  std::sort(shared_.begin(), shared_.end());
}

std::array<int, 2> SheetGrid::cells_of(int place) const {
  const int first = first_[place];
  if (first < 0) return {0, 0};
  int end = first + 1;
  while (end < static_cast<int>(cells_.size()) && cells_[end].at == cells_[first].at) ++end;
  return {first, end};
}

std::array<int, 2> SheetGrid::cells_at(const Vec3& local) const {
  Position at;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(local[axis] >= 0.0 && local[axis] < size_[axis])) return {0, 0};
    at[axis] = static_cast<int>(local[axis]);
  }
  return cells_of(index(at));
}

int SheetGrid::cell_of(const Vec3& local, int sample) const {
  const auto [first, end] = cells_at(local);
  if (end - first == 1) return first;
  for (int c = first; c < end; ++c) {
    if (std::binary_search(shared_.begin(), shared_.end(), std::array<int, 2>{c, sample})) return c;
  }
  return -1;
}

int SheetGrid::common_nodes(int first, int second) const {
  const Cell &a = cells_[first], &b = cells_[second];
  const int di = a.at[0] - b.at[0], dj = a.at[1] - b.at[1], dk = a.at[2] - b.at[2];
  int count = 0;
  for (int n = 0; n < 64; ++n) {
    const int i = n / 16 + di, j = n / 4 % 4 + dj, k = n % 4 + dk;
    const bool inside = i >= 0 && i < 4 && j >= 0 && j < 4 && k >= 0 && k < 4;
    if (inside && a.unknowns[n] == b.unknowns[16 * i + 4 * j + k]) ++count;
  }
  return count;
}

int SheetGrid::continued(int cell, const Vec3& local) const {
  const auto [first, end] = cells_at(local);
  int best = -1, most = 0;
  for (int c = first; c < end; ++c) {
    const int count = common_nodes(cell, c);
    if (count > most) {
      most = count;
      best = c;
    }
  }
  return best;
}

int SheetGrid::shared_positions() const {
  int count = 0;
  for (std::size_t c = 1; c < cells_.size(); ++c) {
    const bool again = cells_[c].at == cells_[c - 1].at;
    count += again && (c == 1 || cells_[c].at != cells_[c - 2].at) ? 1 : 0;
  }
  return count;
}

}  // namespace toile::body
