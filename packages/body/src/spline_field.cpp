#include "spline_field.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr double most_cells = 2e8;  ///< of the box: a person in cells of 3 mm has 6e7
constexpr int padding = 2;          ///< cells between the facets' box and the grid's border

/// Calls `visit` on points that are no further than half a cell from each other and cover the triangle.
template <class Visit>
void sample_triangle(const Vec3& a, const Vec3& b, const Vec3& c, double spacing, const Visit& visit) {
  const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
  const int n = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      visit(Vec3(a + (b - a) * i / n + (c - a) * j / n));
    }
  }
}

}  // namespace

Eigen::Matrix4d cubic_splines(double t) {
  const double s = 1.0 - t;
  Eigen::Matrix4d b;
  b.row(0) << s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
      t * t * t / 6.0;
  b.row(1) << -0.5 * s * s, 1.5 * t * t - 2.0 * t, -1.5 * s * s + 2.0 * s, 0.5 * t * t;
  b.row(2) << s, 3.0 * t - 2.0, 3.0 * s - 2.0, t;
  b.row(3) << -1.0, 3.0, -3.0, 1.0;
  return b;
}

CellGrid::CellGrid(const TriangleMesh& mesh, double cell) : cell_(cell) {
  Vec3 lower = mesh.vertices.front();
  Vec3 upper = lower;
  for (const Vec3& vertex : mesh.vertices) {
    lower = lower.cwiseMin(vertex);
    upper = upper.cwiseMax(vertex);
  }
  origin_ = lower - Vec3::Constant(padding * cell);
  const double box_cells = ((upper - lower) / cell + Vec3::Constant(1 + 2 * padding)).prod();
  if (!(box_cells <= most_cells)) {
    std::ostringstream text;
    text << "the smooth surface of the body would need a grid of " << box_cells << " cells of " << cell << " mm round "
         << (upper - lower).transpose() << " mm, at most " << most_cells
         << " are possible: enlarge \"cell\", or bound the part of the body that the garment can reach (list Reach)";
    throw base::InputError(text.str());
  }
  for (int axis = 0; axis < 3; ++axis) {
    cells_[axis] = static_cast<int>(std::floor((upper - lower)[axis] / cell)) + 1 + 2 * padding;
  }
  mark(mesh);
  number_nodes();
}

void CellGrid::mark(const TriangleMesh& mesh) {
  std::vector<char> hit(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2], 0);
  for (const auto& t : mesh.triangles) {
    sample_triangle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], 0.5 * cell_, [&](const Vec3& p) {
      const Vec3 x = local(p);
      hit[cell_index(static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2]))] = 1;
    });
  }
  active_.assign(hit.size(), 0);
  for (int i = 1; i + 1 < cells_[0]; ++i) {
    for (int j = 1; j + 1 < cells_[1]; ++j) {
      for (int k = 1; k + 1 < cells_[2]; ++k) {
        if (hit[cell_index(i, j, k)] != 0) {
          for (int n = 0; n < 27; ++n) {
            active_[cell_index(i + n / 9 - 1, j + n / 3 % 3 - 1, k + n % 3 - 1)] = 1;
          }
        }
      }
    }
  }
  active_cells_ = static_cast<int>(std::count(active_.begin(), active_.end(), 1));
}

void CellGrid::number_nodes() {
  const int ny = cells_[1] + 3;
  const int nz = cells_[2] + 3;
  unknown_.assign(static_cast<std::size_t>(cells_[0] + 3) * ny * nz, -1);
  for (int i = 0; i < cells_[0]; ++i) {
    for (int j = 0; j < cells_[1]; ++j) {
      for (int k = 0; k < cells_[2]; ++k) {
        if (is_active(i, j, k)) {
          for (int n = 0; n < 64; ++n) {
            unknown_[((i + n / 16) * ny + j + n / 4 % 4) * nz + k + n % 4] = 0;
          }
        }
      }
    }
  }
  for (std::size_t n = 0; n < unknown_.size(); ++n) {
    if (unknown_[n] == 0) {
      unknown_[n] = static_cast<int>(nodes_.size());
      const int index = static_cast<int>(n);
      nodes_.push_back({index / (ny * nz), index / nz % ny, index % nz});
    }
  }
}

bool CellGrid::locate(const Vec3& local, std::array<int, 3>* position) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(local[axis] >= 0.0 && local[axis] < cells_[axis])) {
      return false;
    }
    (*position)[axis] = static_cast<int>(local[axis]);
  }
  return is_active((*position)[0], (*position)[1], (*position)[2]);
}

bool SplineField::evaluate(const Vec3& point, Value* result) const {
  const Vec3 x = grid_.local(point);
  std::array<int, 3> at;
  if (!grid_.locate(x, &at)) {
    return false;
  }
  const Eigen::Matrix4d bx = cubic_splines(x[0] - at[0]);
  const Eigen::Matrix4d by = cubic_splines(x[1] - at[1]);
  const Eigen::Matrix4d bz = cubic_splines(x[2] - at[2]);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();    // sum(p, q): derivative p in x, q in y, with:
  Eigen::Matrix3d sum_z = Eigen::Matrix3d::Zero();  // one derivative in z
  double zz = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double* c = &coefficients_[grid_.unknown(at[0] + i, at[1] + j, at[2])];
      const Eigen::Vector3d row = bz.topRows<3>() * Eigen::Map<const Eigen::Vector4d>(c);
      const Eigen::Matrix3d xy = bx.col(i).head<3>() * by.col(j).head<3>().transpose();
      sum += row[0] * xy;
      sum_z += row[1] * xy;
      zz += row[2] * xy(0, 0);
    }
  }
  const double h = grid_.cell();
  result->value = h * sum(0, 0);
  result->gradient = {sum(1, 0), sum(0, 1), sum_z(0, 0)};
  result->hessian << sum(2, 0), sum(1, 1), sum_z(1, 0), sum(1, 1), sum(0, 2), sum_z(0, 1), sum_z(1, 0), sum_z(0, 1), zz;
  result->hessian /= h;
  return true;
}

}  // namespace toile::body
