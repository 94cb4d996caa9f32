#include "cutter.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace toile::result {
namespace {

using mesh::Vec3;

/// Pieces of the cut, told by the edges of triangles that they join.
class Pieces {
 public:
  /// Number of the edge between two (tied) vertices.
  int edge(int a, int b) {
    const auto [at, is_new] = edges_.try_emplace(std::minmax(a, b), static_cast<int>(parent_.size()));
    if (is_new) {
      parent_.push_back(at->second);
      count_.push_back(0);
    }
    return at->second;
  }
  void join(int a, int b) {
    ++count_[static_cast<std::size_t>(a)];
    ++count_[static_cast<std::size_t>(b)];
    parent_[static_cast<std::size_t>(root(a))] = root(b);
  }
  int root(int edge) const {
    while (parent_[static_cast<std::size_t>(edge)] != edge) edge = parent_[static_cast<std::size_t>(edge)];
    return edge;
  }
  /// Calls work(edge, a, b) for the edges where a piece ends, which one segment alone meets, with their vertices.
  template <class F>
  void for_each_end(const F& work) const {
    for (const auto& [vertices, edge] : edges_)
      if (count_[static_cast<std::size_t>(edge)] == 1) work(edge, vertices.first, vertices.second);
  }

 private:
  std::map<std::pair<int, int>, int> edges_;
  std::vector<int> parent_;
  std::vector<int> count_;  ///< [edge] segments that meet it
};

/// Two directions across `direction`, the first as near to x as possible (to y if that is along x).
std::pair<Vec3, Vec3> across(const Vec3& direction) {
  const Vec3 near = std::abs(direction.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 first = (near - near.dot(direction) * direction).normalized();
  return {first, direction.cross(first)};
}

/// Whether the section runs round the axis: a ray from the axis meets a closed one an odd number of times; an open one
/// is seen under more than half a turn, and half of one with a mirror image under more than a quarter.
bool surrounds(const Section& section, const AxisPlace& axis) {
  const auto [right, back] = across(axis.direction);
  // Not along the middle of a limb, where a regular mesh may have a node: its round-off would count it twice.
  const Vec3 first = std::cos(0.1234) * right + std::sin(0.1234) * back;
  const Vec3 second = axis.direction.cross(first);
  int crossings = 0;
  double angle = 0.0;
  for (const Segment& segment : section.segments) {
    const Vec3 a = segment.point[0] - axis.point, b = segment.point[1] - axis.point;
    const double ya = second.dot(a), yb = second.dot(b), xa = first.dot(a), xb = first.dot(b);
    if ((ya > 0.0) != (yb > 0.0) && xa + (xb - xa) * ya / (ya - yb) > 0.0) ++crossings;
    angle += std::atan2(a.cross(b).norm(), a.dot(b));
  }
  if (section.mirrored) return angle > 0.5 * M_PI;
  return section.closed ? crossings % 2 == 1 : angle > M_PI;
}

std::set<int> blocks_of(const Section& section) {
  std::set<int> blocks;
  for (const Segment& segment : section.segments) blocks.insert(segment.block);
  return blocks;
}

/// The open pieces of the same panels as one section: a wavy hem is cut in many.
std::vector<Section> with_open_pieces_joined(std::vector<Section> pieces) {
  std::vector<Section> sections;
  std::map<std::set<int>, std::size_t> open;
  for (Section& piece : pieces) {
    const auto at = piece.closed ? open.end() : open.find(blocks_of(piece));
    if (at == open.end()) {
      if (!piece.closed) open[blocks_of(piece)] = sections.size();
      sections.push_back(std::move(piece));
    } else {
      std::vector<Segment>& all = sections[at->second].segments;
      all.insert(all.end(), piece.segments.begin(), piece.segments.end());
    }
  }
  return sections;
}

/// In the order of the panels, and along the axis' right and back where they share one.
void sort_sections(std::vector<Section>& sections, const Vec3& direction) {
  const auto [right, back] = across(direction);
  std::vector<std::pair<std::tuple<int, double, double>, std::size_t>> keys;
  for (const Section& section : sections)
    keys.push_back(
        {{*blocks_of(section).begin(), right.dot(section.centre()), back.dot(section.centre())}, keys.size()});
  std::sort(keys.begin(), keys.end());
  std::vector<Section> sorted;
  for (const auto& [key, index] : keys) sorted.push_back(std::move(sections[index]));
  sections = std::move(sorted);
}

}  // namespace

double Section::girth() const {
  return std::accumulate(segments.begin(), segments.end(), 0.0,
                         [](double sum, const Segment& s) { return sum + s.length(); });
}

Vec3 Section::centre() const {
  Vec3 moment = Vec3::Zero();
  for (const Segment& segment : segments) moment += segment.length() * segment.middle();
  return moment / girth();
}

Cutter::Cutter(const GarmentFields& garment, const Axis& axis)
    : garment_(garment), axis_(axis), surface_(triangulate(*garment.mesh, garment.position)) {
  axis_.direction.normalize();
  pressure_ = at_vertices(*garment.mesh, garment.pressure);
  for (const PressureError& part : garment.pressure_errors) errors_.push_back(at_vertices(*garment.mesh, part.values));
  find_neighbours();
  tied_.resize(surface_.mesh.vertices.size());
  std::iota(tied_.begin(), tied_.end(), 0);
  std::copy(garment.tied.begin(), garment.tied.end(), tied_.begin());
  mirror_.assign(tied_.size(), -1);
  for (std::size_t n = 0; n < garment.mirror.size(); ++n)
    if (garment.mirror[n] >= 0) mirror_[n] = mirror_[static_cast<std::size_t>(tied_[n])] = garment.mirror[n];
  find_ends(axis_);
}

// By least squares, in the pattern's plane: the tension's over the elements that share a node with it, the pressure's
// over its own nodes.
void Cutter::find_neighbours() {
  constexpr double determined = 1e-6;  // smallest over largest eigenvalue: a single row has no slope across
  const mesh::Mesh& mesh = *garment_.mesh;
  std::vector<std::vector<std::size_t>> around(static_cast<std::size_t>(mesh.nodes()));
  for (const mesh::Block& block : mesh.blocks)
    for (std::size_t i = 0; i < block.connectivity.size(); ++i) {
      if (i % static_cast<std::size_t>(block.nodes_per_element) == 0) corners_.emplace_back();
      corners_.back().push_back(static_cast<std::size_t>(block.connectivity[i]));
      around[corners_.back().back()].push_back(corners_.size() - 1);
    }
  for (const std::vector<std::size_t>& nodes : corners_) {
    mesh::Vec2 centre = mesh::Vec2::Zero();
    for (const std::size_t n : nodes) centre += mesh.pattern[n] / static_cast<double>(nodes.size());
    centre_.push_back(centre);
    const auto at = [&](std::size_t k) -> const Vec3& { return garment_.position[nodes[k]]; };
    normal_.push_back((at(2) - at(0)).cross(at(nodes.size() - 1) - at(1)));
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    mesh::Vec2 moment = mesh::Vec2::Zero();
    for (const std::size_t n : nodes) {
      const mesh::Vec2 off = mesh.pattern[n] - centre;
      squares += off * off.transpose();
      moment += garment_.pressure[n] * off;
    }
    slope_.push_back(squares.inverse() * moment);
  }
  for (std::size_t e = 0; e < corners_.size(); ++e) {
    std::set<std::size_t> others;
    for (const std::size_t n : corners_[e]) others.insert(around[n].begin(), around[n].end());
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const std::size_t o : others) squares += (centre_[o] - centre_[e]) * (centre_[o] - centre_[e]).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(squares);
    neighbours_.emplace_back();
    if (!(solver.eigenvalues()[0] > determined * solver.eigenvalues()[1])) continue;
    for (const std::size_t o : others)
      if (o != e) neighbours_.back().push_back({o, squares.inverse() * (centre_[o] - centre_[e])});
  }
  std::vector<Vec3> flat;
  for (const mesh::Vec2& p : mesh.pattern) flat.emplace_back(p.x(), p.y(), 0.0);
  pattern_ = at_vertices(mesh, flat);
}

double Cutter::tension_across(std::size_t element, const Vec3& axis) const {
  const Vec3 along = axis.cross(normal_[element]).normalized();
  return along.dot(garment_.tension[element] * along);
}

double Cutter::missed_between_rows(std::size_t element, const mesh::Vec2& place, double pressure,
                                   const std::vector<double>& above) const {
  const auto larger = [](double x, double y) { return std::abs(x) < std::abs(y) ? y : x; };
  std::array<double, 2> missed{};  // below, above
  std::array<bool, 2> known{};
  for (const Neighbour& other : neighbours_[element]) {
    double height = 0.0, mean = 0.0;
    for (const std::size_t n : corners_[other.element]) {
      height += above[n];
      mean += garment_.pressure[n] / static_cast<double>(corners_[other.element].size());
    }
    const std::size_t side = height > 0.0 ? 1 : 0;
    const double foretold = mean + slope_[other.element].dot(place - centre_[other.element]);
    missed[side] = larger(missed[side], foretold - pressure);
    known[side] = true;
  }
  const bool both = known[0] && known[1], upper_is_nearer = larger(missed[1], missed[0]) == missed[0];
  const std::size_t nearer = both ? (upper_is_nearer ? 1 : 0) : (known[0] ? 0 : 1);
  return 0.75 * missed[nearer];
}

AxisPlace Cutter::place(double height) const {
  return axis_.bent ? axis_.bent(height) : AxisPlace{axis_.point + height * axis_.direction, axis_.direction};
}

void Cutter::find_ends(const Axis& axis) {
  std::vector<AxisPlace> samples = {place(0.0)};
  std::vector<double> heights = {0.0};
  if (axis.bent) {
    constexpr int count = 400;
    Eigen::AlignedBox3d box(axis.bent(0.0).point);
    for (const Vec3& vertex : surface_.mesh.vertices) box.extend(vertex);
    const double beyond = box.diagonal().norm();
    for (int k = 0; k <= count; ++k) {
      heights.push_back(-beyond + (axis.length + 2.0 * beyond) * k / count);
      samples.push_back(axis.bent(heights.back()));
    }
  }
  for (const Vec3& vertex : surface_.mesh.vertices) {
    const auto nearest = std::min_element(samples.begin(), samples.end(), [&](const AxisPlace& a, const AxisPlace& b) {
      return (a.point - vertex).squaredNorm() < (b.point - vertex).squaredNorm();
    });
    heights_.push_back(heights[static_cast<std::size_t>(nearest - samples.begin())] +
                       nearest->direction.dot(vertex - nearest->point));
  }
  refine_ends();
  lowest_ = *std::min_element(heights_.begin(), heights_.end());
  highest_ = *std::max_element(heights_.begin(), heights_.end());
}

/// Along a bent axis the heights so far are those along its tangents at the samples; near the ends they must be exact.
void Cutter::refine_ends() {
  if (!axis_.bent) return;
  const auto [lowest, highest] = std::minmax_element(heights_.begin(), heights_.end());
  const double near = 0.1 * (*highest - *lowest), lower = *lowest + near, upper = *highest - near;
  for (std::size_t v = 0; v < heights_.size(); ++v) {
    double change = near;
    for (int k = 0; k < 50 && (heights_[v] < lower || heights_[v] > upper) && std::abs(change) > 1e-9 * near; ++k) {
      const AxisPlace there = axis_.bent(heights_[v]);
      change = there.direction.dot(surface_.mesh.vertices[v] - there.point);
      heights_[v] += change;
    }
  }
}

mesh::Vec2 Cutter::add_point(Segment& segment, std::size_t k, int from, int to,
                             const std::vector<double>& above) const {
  const auto a = static_cast<std::size_t>(from);
  const auto b = static_cast<std::size_t>(to);
  const double t = above[a] / (above[a] - above[b]);
  segment.point[k] = (1.0 - t) * surface_.mesh.vertices[a] + t * surface_.mesh.vertices[b];
  segment.pressure[k] = (1.0 - t) * pressure_[a] + t * pressure_[b];
  for (const std::vector<double>& part : errors_) segment.errors[k].push_back((1.0 - t) * part[a] + t * part[b]);
  return ((1.0 - t) * pattern_[a] + t * pattern_[b]).head<2>();
}

Segment Cutter::segment(std::size_t triangle, std::size_t alone, const std::vector<double>& above,
                        const Vec3& axis) const {
  const auto& corner = surface_.mesh.triangles[triangle];
  Segment segment{};
  segment.element = surface_.element[triangle];
  segment.block = surface_.block[triangle];
  const mesh::Vec2 first = add_point(segment, 0, corner[alone], corner[(alone + 1) % 3], above);
  const mesh::Vec2 second = add_point(segment, 1, corner[alone], corner[(alone + 2) % 3], above);
  const auto e = static_cast<std::size_t>(segment.element);
  const mesh::Vec2 middle = 0.5 * (first + second), off = middle - centre_[e];
  segment.missed = missed_between_rows(e, middle, 0.5 * (segment.pressure[0] + segment.pressure[1]), above);
  const Vec3 tangent = segment.step().normalized();  // zero for a point
  segment.tension = tangent.dot(garment_.tension[e] * tangent);
  const double here = tension_across(e, axis);
  for (const Neighbour& other : neighbours_[e])
    segment.tension += off.dot(other.weight) * (tension_across(other.element, axis) - here);
  return segment;
}

std::vector<double> Cutter::above(double height, const AxisPlace& axis) const {
  const double margin = 1e-6 * (highest_ - lowest_);
  const bool at_end = std::min(std::abs(height - lowest_), std::abs(height - highest_)) < margin;
  const double on_plane = height < 0.5 * (lowest_ + highest_) ? -0.0 : 0.0;
  std::vector<double> above;
  for (const Vec3& vertex : surface_.mesh.vertices) {
    above.push_back(axis.direction.dot(vertex - axis.point));
    if (at_end && std::abs(above.back()) < margin) above.back() = on_plane;
  }
  return above;
}

std::vector<Section> Cutter::pieces(double height, const AxisPlace& axis) const {
  const std::vector<double> above = this->above(height, axis);

  std::vector<std::pair<int, Segment>> found;  // with an edge that it meets
  Pieces pieces;
  for (std::size_t t = 0; t < surface_.mesh.triangles.size(); ++t) {
    const auto& corner = surface_.mesh.triangles[t];
    // A vertex in the plane counts as above, so that a plane through a row of nodes meets each place once.
    const auto is_above = [&](int vertex) { return !std::signbit(above[static_cast<std::size_t>(vertex)]); };
    const auto count = std::count_if(corner.begin(), corner.end(), is_above);
    if (count == 0 || count == 3) continue;
    const auto alone = static_cast<std::size_t>(
        std::find_if(corner.begin(), corner.end(), [&](int v) { return is_above(v) == (count == 1); }) -
        corner.begin());
    const auto tied = [&](std::size_t k) { return tied_[static_cast<std::size_t>(corner[k % 3])]; };
    const int first = pieces.edge(tied(alone), tied(alone + 1));
    pieces.join(first, pieces.edge(tied(alone), tied(alone + 2)));
    found.emplace_back(first, segment(t, alone, above, axis.direction));
  }

  std::map<int, Section> sections;
  for (const auto& [edge, segment] : found) sections[pieces.root(edge)].segments.push_back(segment);
  for (auto& [root, section] : sections) section.closed = true;
  // An open piece whose ends lie in one plane of symmetry goes on beyond it, back to its other end.
  std::map<int, std::set<int>> planes;  // [piece] in which it ends; -1: in none
  pieces.for_each_end([&](int edge, int a, int b) {
    const int plane = mirror_[static_cast<std::size_t>(a)];
    planes[pieces.root(edge)].insert(plane == mirror_[static_cast<std::size_t>(b)] ? plane : -1);
  });
  for (const auto& [piece, ends] : planes) {
    sections[piece].mirrored = ends.size() == 1 && *ends.begin() >= 0;
    sections[piece].closed = sections[piece].mirrored;
  }

  std::vector<Section> all;
  for (auto& [root, section] : sections)
    if (section.girth() > 0.0) all.push_back(std::move(section));
  return all;
}

std::optional<Cutter::SeamInPlane> Cutter::seam_at(double height) const {
  constexpr int least = 8;       // nodes of each panel: a seam that crosses the plane has one
  constexpr double near = 0.05;  // of the elements' mean size
  const mesh::Mesh& mesh = *garment_.mesh;
  const std::vector<double> above = this->above(height, place(height));
  double area = 0.0;
  for (const Vec3& normal : normal_) area += 0.5 * normal.norm();
  const double most = near * std::sqrt(area / static_cast<double>(normal_.size()));
  std::map<int, std::map<int, double>> at_place;  // [tied][block] pressure
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (const int node : mesh.blocks[b].connectivity) {
      const auto n = static_cast<std::size_t>(node);
      if (std::abs(above[n]) <= most) at_place[tied_[n]][static_cast<int>(b)] = garment_.pressure[n];
    }
  struct Sums {
    int places = 0;
    std::array<double, 2> pressure{};
  };
  std::map<std::array<int, 2>, Sums> pairs;
  for (const auto& [place, blocks] : at_place) {
    if (blocks.size() != 2) continue;
    const auto first = blocks.begin(), second = std::next(first);
    Sums& sums = pairs[{first->first, second->first}];
    ++sums.places;
    sums.pressure[0] += first->second;
    sums.pressure[1] += second->second;
  }
  for (const auto& [blocks, sums] : pairs)
    if (sums.places >= least)
      return SeamInPlane{blocks, {sums.pressure[0] / sums.places, sums.pressure[1] / sums.places}};
  return std::nullopt;
}

std::vector<Section> Cutter::cut(double height) const {
  const AxisPlace axis = place(height);
  std::vector<Section> all = with_open_pieces_joined(pieces(height, axis));
  if (axis_.bent)
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Section& s) { return !surrounds(s, axis); }), all.end());
  sort_sections(all, axis.direction);
  return all;
}

}  // namespace toile::result
