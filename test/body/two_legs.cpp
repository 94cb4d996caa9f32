#include "body/two_legs.hpp"

#include <cmath>

namespace toile::test {
namespace {

using body::Vec3;
using Row = std::vector<int>;

class Builder {
 public:
  Builder(const TwoLegs& legs, double edge) : legs_(legs), edge_(edge) {}
  body::TriangleMesh mesh() {
    const Row right = leg(1.0), left = leg(-1.0);
    const Row front = bottom(right, left, false), back = bottom(left, right, true);
    trunk(right, left, front, back);
    return mesh_;
  }

 private:
  int parts(double length) const { return std::max(1, static_cast<int>(std::lround(length / edge_))); }
  int add(const Vec3& point) {
    mesh_.vertices.push_back(point);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }
  /// Triangles between two rows that run the same way, the second to the left of the first.
  void join(const Row& a, const Row& b) {
    std::size_t i = 0, j = 0;
    while (i + 1 < a.size() || j + 1 < b.size()) {
      if (j + 1 == b.size() || (i + 1 < a.size() && (i + 1) * (b.size() - 1) <= (j + 1) * (a.size() - 1))) {
        mesh_.triangles.push_back({a[i], a[i + 1], b[j]});
        ++i;
      } else {
        mesh_.triangles.push_back({a[i], b[j + 1], b[j]});
        ++j;
      }
    }
  }
  /// Returns the upper rim, counter-clockwise from above, from the back of the leg (y < 0) on, closed.
  Row leg(double side) {
    quarter_ = parts(0.5 * M_PI * legs_.radius);
    const int rows = parts(legs_.leg);
    Row last;
    for (int j = 0; j <= rows; ++j) {
      Row row;
      for (int i = 0; i < 4 * quarter_; ++i) {
        const double angle = 0.5 * M_PI * (static_cast<double>(i) / quarter_ - 1.0);
        row.push_back(add({side * legs_.centre() + legs_.radius * std::cos(angle), legs_.radius * std::sin(angle),
                           legs_.leg * (static_cast<double>(j) / rows - 1.0)}));
      }
      row.push_back(row.front());
      if (j > 0) join(last, row);
      last = row;
    }
    return last;
  }
  Row line(int from, int to) {
    const Vec3 a = mesh_.vertices[from], b = mesh_.vertices[to];
    const int n = parts((b - a).norm());
    Row row{from};
    for (int i = 1; i < n; ++i) row.push_back(add(a + (b - a) * i / n));
    row.push_back(to);
    return row;
  }
  /// The flat bottom of the trunk between the legs, in front (y > 0) or behind. Returns its outer line, from one leg to
  /// the other as the rims of the prism run.
  Row bottom(const Row& from, const Row& to, bool behind) {
    Row outer, last;
    for (int i = 0; i <= quarter_; ++i) {
      // In front the right rim runs inwards from 2 quarters on and the left one from 2 quarters back to 1.
      const int a = behind ? (i == 0 ? 4 * quarter_ : 4 * quarter_ - i) : 2 * quarter_ + i;
      Row row;
      if (behind) {
        // Left rim: its back is at 0, inner side at 1 quarter; right rim: back at 4 quarters, inner side at 3.
        row = i == quarter_ ? Row{from[i], to[a]} : line(from[i], to[a]);
      } else {
        row = i == quarter_ ? Row{from[a], to[2 * quarter_ - i]} : line(from[a], to[2 * quarter_ - i]);
      }
      if (i == 0) outer = row;
      if (i > 0) join(row, last);
      last = row;
    }
    return outer;
  }
  void trunk(const Row& right, const Row& left, const Row& front, const Row& back) {
    Row base(right.begin(), right.begin() + 2 * quarter_);
    base.insert(base.end(), front.begin(), front.end() - 1);
    base.insert(base.end(), left.begin() + 2 * quarter_, left.end() - 1);
    base.insert(base.end(), back.begin(), back.end() - 1);
    base.push_back(base.front());
    const int rows = parts(legs_.trunk);
    Row last = base;
    for (int j = 1; j <= rows; ++j) {
      Row row;
      for (std::size_t i = 0; i + 1 < base.size(); ++i) {
        row.push_back(add(mesh_.vertices[base[i]] + Vec3(0.0, 0.0, legs_.trunk * j / rows)));
      }
      row.push_back(row.front());
      join(last, row);
      last = row;
    }
  }

  TwoLegs legs_;
  double edge_;
  int quarter_ = 1;
  body::TriangleMesh mesh_;
};

}  // namespace

Vec3 TwoLegs::at(double angle, double z) const {
  return {centre() - radius * std::cos(angle), radius * std::sin(angle), z};
}

body::TriangleMesh triangulation(const TwoLegs& legs, double edge) {
  return Builder(legs, edge).mesh();
}

}  // namespace toile::test
