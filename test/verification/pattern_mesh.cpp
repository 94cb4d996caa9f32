#include "verification/pattern_mesh.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <utility>

namespace toile::test {
namespace {

using Vec2 = Eigen::Vector2d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = std::pair<int, int>;  // a point, and by how many widths it is moved
using Element = std::vector<Corner>;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Corner, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Points of one width, and elements of points, some of them in the next width.
struct Periodic {
  double width, height;
  std::vector<Vec2> points;
  std::vector<Element> elements;

  Vec2 at(const Corner& c) const { return points[static_cast<size_t>(c.first)] + Vec2(c.second * width, 0.0); }
  bool at_end(int point) const {
    const double y = points[static_cast<size_t>(point)].y();
    return y < 1e-9 || y > height - 1e-9;
  }
  /// Triangles between the points whose centroid lies in [0, width).
  void triangulate();
  /// Moves inner points towards the mean of their neighbours.
  void smooth(int passes);
  /// Joins pairs of triangles, best ones first, whose angles deviate from 90 degrees by at most that (radians).
  void join(double deviation);
  /// Halves the sides of all elements: quadrilaterals only.
  void halve();
  PatternMesh mesh() const;

 private:
  double ugliness(const Element& quadrilateral) const;
};

void Periodic::triangulate() {
  std::vector<std::pair<Kernel::Point_2, Corner>> all;
  for (int shift = -1; shift <= 1; ++shift)
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
      const Vec2 p = at({i, shift});
      all.emplace_back(Kernel::Point_2(p.x(), p.y()), Corner(i, shift));
    }
  const Triangulation triangulation(all.begin(), all.end());
  elements.clear();
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    Element e;
    Vec2 centre = Vec2::Zero();
    for (int i = 0; i < 3; ++i) {
      e.push_back(f->vertex(i)->info());
      centre += at(e.back()) / 3.0;
    }
    if (centre.x() >= -1e-9 * width && centre.x() < width * (1.0 - 1e-9) &&
        twice_area(at(e[0]), at(e[1]), at(e[2])) > 1e-9)
      elements.push_back(e);
  }
}

void Periodic::smooth(int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<Vec2> sum(points.size(), Vec2::Zero());
    std::vector<int> count(points.size(), 0);
    for (const Element& e : elements)
      for (size_t i = 0; i < e.size(); ++i)
        for (const size_t j : {(i + 1) % e.size(), (i + e.size() - 1) % e.size()}) {
          sum[static_cast<size_t>(e[i].first)] += at(e[j]) - at(e[i]);
          ++count[static_cast<size_t>(e[i].first)];
        }
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
      if (!at_end(i))
        points[static_cast<size_t>(i)] += 0.5 * sum[static_cast<size_t>(i)] / count[static_cast<size_t>(i)];
  }
}

/// Largest deviation of an angle from 90 degrees.
double Periodic::ugliness(const Element& e) const {
  double worst = 0.0;
  for (size_t i = 0; i < 4; ++i) {
    const Vec2 u = (at(e[(i + 1) % 4]) - at(e[i])).normalized(), v = (at(e[(i + 3) % 4]) - at(e[i])).normalized();
    const double angle = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    worst = std::max(worst, angle > 0.0 ? std::abs(angle - 0.5 * M_PI) : M_PI);
  }
  return worst;
}

void Periodic::join(double deviation) {
  struct Side {
    size_t element, corner;
  };
  std::map<std::pair<int, int>, std::vector<Side>> sides;
  for (size_t e = 0; e < elements.size(); ++e)
    for (size_t i = 0; i < 3; ++i) {
      const int a = elements[e][i].first, b = elements[e][(i + 1) % 3].first;
      sides[std::minmax(a, b)].push_back({e, i});
    }
  struct Pair {
    double ugliness;
    size_t first, second;
    Element joined;
  };
  std::vector<Pair> pairs;
  for (const auto& [key, of] : sides) {
    if (of.size() != 2) continue;
    const Element &a = elements[of[0].element], &b = elements[of[1].element];
    const size_t i = of[0].corner, j = of[1].corner;
    Corner opposite = b[(j + 2) % 3];
    opposite.second += a[(i + 1) % 3].second - b[j].second;
    const Element joined = {a[i], opposite, a[(i + 1) % 3], a[(i + 2) % 3]};
    pairs.push_back({ugliness(joined), of[0].element, of[1].element, joined});
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.ugliness < b.ugliness; });
  std::vector<bool> taken(elements.size(), false);
  std::vector<Element> coarse;
  for (const Pair& pair : pairs) {
    if (taken[pair.first] || taken[pair.second] || pair.ugliness > deviation) continue;
    taken[pair.first] = taken[pair.second] = true;
    coarse.push_back(pair.joined);
  }
  for (size_t e = 0; e < elements.size(); ++e)
    if (!taken[e]) coarse.push_back(elements[e]);
  elements = coarse;
}

void Periodic::halve() {
  const std::vector<Element> coarse = std::move(elements);
  elements.clear();
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](Corner a, Corner b) {
    if (a.first > b.first) std::swap(a, b);
    const auto [found, is_new] = middle.try_emplace({a.first, b.first}, static_cast<int>(points.size()));
    if (is_new) points.push_back(0.5 * (at({a.first, 0}) + at({b.first, b.second - a.second})));
    return Corner(found->second, a.second);
  };
  for (const Element& e : coarse) {
    Vec2 centre = Vec2::Zero();
    for (const Corner& c : e) centre += at(c) / static_cast<double>(e.size());
    const Corner inner(static_cast<int>(points.size()), 0);
    points.push_back(centre);
    for (size_t i = 0; i < e.size(); ++i)
      elements.push_back(
          {e[i], middle_of(e[i], e[(i + 1) % e.size()]), inner, middle_of(e[(i + e.size() - 1) % e.size()], e[i])});
  }
}

PatternMesh Periodic::mesh() const {
  PatternMesh out;
  std::map<Corner, int> node;
  std::vector<int> first(points.size(), -1);
  const auto number = [&](const Corner& c) {
    const auto [found, is_new] = node.try_emplace(c, static_cast<int>(out.nodes.size()));
    if (is_new) {
      out.nodes.push_back(at(c));
      int& tie = first[static_cast<size_t>(c.first)];
      if (tie < 0) tie = found->second;
      out.tied_to.push_back(tie);
    }
    return found->second;
  };
  for (const Element& e : elements) {
    for (size_t i = 0; i < e.size(); ++i)
      if (twice_area(at(e[i]), at(e[(i + 1) % e.size()]), at(e[(i + 2) % e.size()])) <= 0.0)
        throw std::logic_error("an element is turned over");
    if (e.size() == 4) {
      out.quadrilaterals.push_back({number(e[0]), number(e[1]), number(e[2]), number(e[3])});
    } else {
      out.triangles.push_back({number(e[0]), number(e[1]), number(e[2])});
    }
  }
  return out;
}

Periodic grid(double width, double height, double size, double shift) {
  Periodic p{width, height, {}, {}};
  const int nx = std::max(6, static_cast<int>(std::lround(width / size)));
  const int ny = std::max(3, static_cast<int>(std::lround(height / size)));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> by(-shift, shift);
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const double dx = by(random), dy = j == 0 || j == ny ? 0.0 : by(random);
      p.points.emplace_back(width * (i + (shift > 0.0 ? dx : 0.0)) / nx, height * (j + (shift > 0.0 ? dy : 0.0)) / ny);
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int next = (i + 1) % nx, over = i + 1 == nx ? 1 : 0;
      p.elements.push_back(
          {{j * nx + i, 0}, {j * nx + next, over}, {(j + 1) * nx + next, over}, {(j + 1) * nx + i, 0}});
    }
  return p;
}

/// A square lattice, turned by atan(4/7) = 29.7 degrees so that it closes over the width; triangles fill up to the
/// ends.
Periodic turned(double width, double height, double size) {
  const int k = std::max(1, static_cast<int>(std::lround(width / (std::sqrt(65.0) * size))));
  const double h = width / (std::sqrt(65.0) * k), cosine = 7.0 / std::sqrt(65.0), sine = 4.0 / std::sqrt(65.0);
  const Vec2 u = h * Vec2(cosine, sine), v = h * Vec2(-sine, cosine), origin(0.13 * h, 0.29 * h);
  Periodic p{width, height, {}, {}};
  const int reach = static_cast<int>((width + height) / h) + 5;
  const auto inside = [&](const Vec2& x) { return x.y() > 0.62 * h && x.y() < height - 0.62 * h; };
  const auto place = [&](int i, int j) -> Vec2 { return origin + i * u + j * v; };
  std::map<std::pair<long, long>, int> number;  // by place in the width, rounded
  const auto corner = [&](const Vec2& x) {
    const int shift = static_cast<int>(std::floor(x.x() / width + 1e-9));
    const Vec2 base = x - Vec2(shift * width, 0.0);
    const auto [found, is_new] = number.try_emplace({std::lround(1e4 * base.x() / h), std::lround(1e4 * base.y() / h)},
                                                    static_cast<int>(p.points.size()));
    if (is_new) p.points.push_back(base);
    return Corner(found->second, shift);
  };
  std::map<std::pair<int, int>, bool> cell;
  std::vector<Element> squares;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const Vec2 x = place(i, j), centre = x + 0.5 * (u + v);
      if (inside(x) && x.x() >= -1e-9 * width && x.x() < width * (1.0 - 1e-9)) corner(x);
      if (!inside(x) || !inside(x + u) || !inside(x + u + v) || !inside(x + v)) continue;
      cell[{i, j}] = true;
      if (centre.x() >= -1e-9 * width && centre.x() < width * (1.0 - 1e-9))
        squares.push_back({corner(x), corner(x + u), corner(x + u + v), corner(x + v)});
    }
  const int at_ends = std::max(6, static_cast<int>(std::lround(width / h)));
  for (int i = 0; i < at_ends; ++i)
    for (const double y : {0.0, height}) p.points.emplace_back((i + 0.5) * width / at_ends, y);
  p.triangulate();
  const auto in_square = [&](const Element& e) {
    const Vec2 r = ((p.at(e[0]) + p.at(e[1]) + p.at(e[2])) / 3.0 - origin) / (h * h);
    return cell.count({static_cast<int>(std::floor(r.dot(u))), static_cast<int>(std::floor(r.dot(v)))}) > 0;
  };
  p.elements.erase(std::remove_if(p.elements.begin(), p.elements.end(), in_square), p.elements.end());
  p.elements.insert(p.elements.end(), squares.begin(), squares.end());
  return p;
}

/// Points that keep a distance from each other.
class Scatter {
 public:
  Scatter(double width, double height, double size, bool graded)
      : points_{width, height, {}, {}}, size_(size), graded_(graded), columns_(static_cast<int>(width / size) + 1) {}
  void fill_ends();
  /// Square lattices, each in its own part of the width and turned its own way.
  void fill_with_lattices();
  void fill_at_random();
  const Periodic& points() const { return points_; }

 private:
  double size_at(double x) const {
    const double t = x / points_.width - std::floor(x / points_.width);
    return !graded_ ? size_ : t > 0.25 && t < 0.75 ? size_ / std::sqrt(3.0) : std::sqrt(3.0) * size_;
  }
  Vec2 between(const Vec2& from, const Vec2& to) const {
    Vec2 d = to - from;
    d.x() -= points_.width * std::round(d.x() / points_.width);
    return d;
  }
  std::pair<int, int> bin_of(const Vec2& x) const {
    return {static_cast<int>(x.x() / size_), static_cast<int>(x.y() / size_)};
  }
  void enter(const Vec2& x) {
    bins_[bin_of(x)].push_back(static_cast<int>(points_.points.size()));
    points_.points.push_back(x);
  }
  bool alone(const Vec2& x, double apart) const;

  Periodic points_;
  double size_;
  bool graded_;
  int columns_;
  std::map<std::pair<int, int>, std::vector<int>> bins_;
  std::mt19937 random_{2};
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

void Scatter::fill_ends() {
  constexpr int fine = 100000;
  const double dx = points_.width / fine;
  double count = 0.0;
  for (int i = 0; i < fine; ++i) count += dx / size_at((i + 0.5) * dx);
  const double step = count / std::round(count);
  double passed = 0.5 * step;
  for (int i = 0; i < fine; ++i) {
    passed += dx / size_at((i + 0.5) * dx);
    if (passed < step) continue;
    passed -= step;
    for (const double y : {0.0, points_.height}) enter({(i + 0.5) * dx, y});
  }
}

bool Scatter::alone(const Vec2& x, double apart) const {
  if (x.y() < 0.7 * apart || x.y() > points_.height - 0.7 * apart) return false;
  const auto [column, row] = bin_of(x);
  const int rings = static_cast<int>(apart / size_) + 1;
  for (int i = column - rings; i <= column + rings; ++i)
    for (int j = row - rings; j <= row + rings; ++j) {
      const auto found = bins_.find({(i + columns_) % columns_, j});
      if (found == bins_.end()) continue;
      for (const int other : found->second)
        if (between(x, points_.points[static_cast<size_t>(other)]).norm() < apart) return false;
    }
  return true;
}

void Scatter::fill_with_lattices() {
  constexpr int parts = 8;
  std::vector<Vec2> seeds;
  for (int i = 0; i < parts; ++i)
    seeds.emplace_back(points_.width * (i + unit_(random_)) / parts, points_.height * unit_(random_));
  const auto nearest = [&](const Vec2& x) {
    return std::min_element(seeds.begin(), seeds.end(),
                            [&](const Vec2& a, const Vec2& b) { return between(x, a).norm() < between(x, b).norm(); }) -
           seeds.begin();
  };
  for (int s = 0; s < parts; ++s) {
    const double h = size_at(seeds[static_cast<size_t>(s)].x()), angle = 0.5 * M_PI * unit_(random_);
    const Vec2 u = h * Vec2(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
    const int reach = static_cast<int>((points_.width + points_.height) / h);
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const Vec2 x = seeds[static_cast<size_t>(s)] + i * u + j * v;
        if (x.x() < 0.0 || x.x() >= points_.width || nearest(x) != s || size_at(x.x()) != h) continue;
        if (alone(x, 0.8 * h)) enter(x);
      }
  }
}

void Scatter::fill_at_random() {
  constexpr double spacing = 0.73;  // makes as many triangles as an area of size^2 / 2 each does
  const int trials = static_cast<int>(60.0 * points_.width * points_.height / (size_ * size_));
  for (int t = 0; t < trials; ++t) {
    const double x = points_.width * unit_(random_), y = points_.height * unit_(random_);
    if (alone({x, y}, spacing * size_at(x))) enter({x, y});
  }
}

/// Free triangles; `graded`: in the middle half three times smaller than elsewhere.
Periodic free_triangles(double width, double height, double size, bool graded) {
  Scatter scatter(width, height, size, graded);
  scatter.fill_ends();
  scatter.fill_at_random();
  Periodic p = scatter.points();
  for (int pass = 0; pass < 4; ++pass) {
    p.triangulate();
    p.smooth(1);
  }
  p.triangulate();
  return p;
}

Periodic free_quadrilaterals(double width, double height, double size, bool graded) {
  Scatter scatter(width, height, 2.0 * size, graded);
  scatter.fill_ends();
  scatter.fill_with_lattices();
  scatter.fill_at_random();
  Periodic p = scatter.points();
  p.triangulate();
  p.join(1.0);
  p.halve();
  p.smooth(2);
  return p;
}

/// Free triangles, of which those are joined that make good quadrilaterals.
Periodic free_mixture(double width, double height, double size) {
  Periodic p = free_triangles(width, height, size, false);
  p.join(0.7);
  return p;
}

}  // namespace

const std::vector<std::string>& mesh_kinds() {
  static const std::vector<std::string> kinds = {
      "aligned",        "turned", "shifted",          "triangles",
      "quadrilaterals", "mixed",  "graded triangles", "graded quadrilaterals"};
  return kinds;
}

PatternMesh pattern_mesh(const std::string& kind, double width, double height, double size) {
  if (kind == "aligned") return grid(width, height, size, 0.0).mesh();
  if (kind == "shifted") return grid(width, height, size, 0.25).mesh();
  if (kind == "turned") return turned(width, height, size).mesh();
  if (kind == "mixed") return free_mixture(width, height, size).mesh();
  const bool graded = kind.rfind("graded", 0) == 0;
  const auto make = kind.find("triangles") != std::string::npos ? free_triangles : free_quadrilaterals;
  return make(width, height, size, graded).mesh();
}

}  // namespace toile::test
