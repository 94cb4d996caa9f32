#include "toile/mesh/four_sided.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::mesh {
namespace {

Curve line(const Vec2& a, const Vec2& b) {
  return Curve::line(a, b);
}

/// Arc of a circle round the origin.
Curve rim(double radius, double from, double to) {
  return Curve::circular(Vec2::Zero(), radius, from, to);
}

Vec2 coons(const FourSides& sides, double u, double v) {
  const Vec2 ruled =
      (1.0 - v) * sides.bottom.at(u) + v * sides.top.at(u) + (1.0 - u) * sides.left.at(v) + u * sides.right.at(v);
  const Vec2 of_corners = (1.0 - u) * (1.0 - v) * sides.bottom.front() + u * (1.0 - v) * sides.bottom.back() +
                          (1.0 - u) * v * sides.top.front() + u * v * sides.top.back();
  return ruled - of_corners;
}

void connect(Grid& grid, bool triangles) {
  grid.nodes_per_element = triangles ? 3 : 4;
  for (int j = 0; j < grid.along; ++j) {
    for (int i = 0; i < grid.across; ++i) {
      const int a = grid.node(i, j), b = grid.node(i + 1, j), c = grid.node(i + 1, j + 1), d = grid.node(i, j + 1);
      std::vector<int> ids{a, b, c, d};
      if (triangles) ids = (i + j) % 2 == 0 ? std::vector<int>{a, b, c, a, c, d} : std::vector<int>{a, b, d, b, c, d};
      grid.connectivity.insert(grid.connectivity.end(), ids.begin(), ids.end());
    }
  }
}

void distort(Grid& grid, double amount) {
  std::mt19937 random(12345);
  const auto signed_unit = [&random] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  const std::vector<Vec2> regular = grid.nodes;
  for (int j = 1; j < grid.along; ++j) {
    for (int i = 1; i < grid.across; ++i) {
      const Vec2& here = regular[grid.node(i, j)];
      double nearest = (regular[grid.node(i - 1, j)] - here).norm();
      for (const int id : {grid.node(i + 1, j), grid.node(i, j - 1), grid.node(i, j + 1)}) {
        nearest = std::min(nearest, (regular[id] - here).norm());
      }
      const double x = signed_unit();
      const double y = signed_unit();
      grid.nodes[grid.node(i, j)] += amount * nearest * Vec2(x, y);
    }
  }
}

/// The first element corner whose Jacobian is not positive.
std::optional<Vec2> find_turned_corner(const Grid& grid) {
  const int n = grid.nodes_per_element;
  for (std::size_t e = 0; e < grid.connectivity.size(); e += n) {
    for (int k = 0; k < n; ++k) {
      const Vec2& here = grid.nodes[grid.connectivity[e + k]];
      const Vec2 next = grid.nodes[grid.connectivity[e + (k + 1) % n]] - here;
      const Vec2 last = grid.nodes[grid.connectivity[e + (k + n - 1) % n]] - here;
      if (next.x() * last.y() - next.y() * last.x() <= 1e-10 * next.norm() * last.norm()) return here;
    }
  }
  return std::nullopt;
}

std::optional<std::string> gap_between(const std::string& first, const Vec2& a, const std::string& second,
                                       const Vec2& b, double tolerance) {
  if ((a - b).norm() <= tolerance) return std::nullopt;
  std::ostringstream text;
  text << first << " at (" << a.x() << ", " << a.y() << ") and " << second << " at (" << b.x() << ", " << b.y() << ")";
  return text.str();
}

}  // namespace

std::optional<std::string> FourSides::open_corner() const {
  const double tolerance = 1e-6 * (bottom.length() + right.length() + top.length() + left.length());
  auto gap = gap_between("the start of bottom", bottom.front(), "the start of left", left.front(), tolerance);
  if (!gap) gap = gap_between("the end of bottom", bottom.back(), "the start of right", right.front(), tolerance);
  if (!gap) gap = gap_between("the end of right", right.back(), "the end of top", top.back(), tolerance);
  if (!gap) gap = gap_between("the end of left", left.back(), "the start of top", top.front(), tolerance);
  return gap;
}

FourSides rectangle(double width, double height) {
  return {line({0.0, 0.0}, {width, 0.0}), line({width, 0.0}, {width, height}), line({0.0, height}, {width, height}),
          line({0.0, 0.0}, {0.0, height})};
}

FourSides sector(double inner_radius, double outer_radius, double from, double to) {
  const Curve bottom = rim(outer_radius, from, to);
  const Curve top = rim(inner_radius, from, to);
  return {bottom, line(bottom.back(), top.back()), top, line(bottom.front(), top.front())};
}

FourSides disc(double radius) {
  constexpr double eighth = M_PI / 4.0;
  return {rim(radius, -3.0 * eighth, -eighth), rim(radius, -eighth, eighth), rim(radius, 3.0 * eighth, eighth),
          rim(radius, 5.0 * eighth, 3.0 * eighth)};
}

FourSides quarter_disc(double radius) {
  constexpr double eighth = M_PI / 4.0;
  return {line({0.0, 0.0}, {radius, 0.0}), rim(radius, 0.0, eighth), rim(radius, 2.0 * eighth, eighth),
          line({0.0, 0.0}, {0.0, radius})};
}

std::vector<int> Grid::row(int j) const {
  std::vector<int> ids;
  for (int i = 0; i <= across; ++i) ids.push_back(node(i, j));
  return ids;
}

std::vector<int> Grid::column(int i) const {
  std::vector<int> ids;
  for (int j = 0; j <= along; ++j) ids.push_back(node(i, j));
  return ids;
}

double graded(double t, double exponent) {
  return t <= 0.5 ? 0.5 * std::pow(2.0 * t, exponent) : 1.0 - 0.5 * std::pow(2.0 * (1.0 - t), exponent);
}

Grid mesh_four_sided(const std::string& panel, const FourSides& sides, const GridOptions& options) {
  assert(options.across > 0 && options.along > 0);
  Grid grid;
  grid.across = options.across;
  grid.along = options.along;
  for (int j = 0; j <= grid.along; ++j) {
    const double v = graded(static_cast<double>(j) / grid.along, options.grading_along);
    for (int i = 0; i <= grid.across; ++i) {
      const double u = graded(static_cast<double>(i) / grid.across, options.grading_across);
      grid.nodes.push_back(coons(sides, u, v));
    }
  }
  connect(grid, options.triangles);
  if (options.distortion > 0.0) distort(grid, options.distortion);
  if (const auto at = find_turned_corner(grid)) {
    std::ostringstream text;
    text << "panel \"" << panel << "\" overlaps itself near (" << at->x() << ", " << at->y()
         << "): an element is turned over there. The sides of a four-sided panel must not bend so far that the lines "
            "between opposite sides cross; move its corners or split it.";
    throw base::InputError(text.str());
  }
  return grid;
}

PanelMesh panel_mesh(const Grid& grid) {
  PanelMesh panel;
  panel.nodes = grid.nodes;
  panel.across = grid.across;
  panel.parts.push_back({"", grid.nodes_per_element, grid.connectivity});
  panel.edges = {{"bottom", grid.row(0)},
                 {"right", grid.column(grid.across)},
                 {"top", grid.row(grid.along)},
                 {"left", grid.column(0)}};
  return panel;
}

}  // namespace toile::mesh
