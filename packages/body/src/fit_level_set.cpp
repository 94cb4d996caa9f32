#include <cblas.h>
#include <cholmod.h>
#include <omp.h>

#include <array>
#include <cmath>

#include "mesh_geometry.hpp"
#include "spline_field.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr double normal_weight = 0.03 * 0.03;  ///< of |grad f - n|^2 beside f^2, lengths in cells
constexpr double ridge = 1e-9;                 ///< keeps coefficients that no datum fixes near zero
constexpr int offsets = 343;                   ///< couplings of a node: (-3..3)^3
constexpr int stored = 172;                    ///< of them, the node itself and those behind it in the numbering

using Matrix64 = Eigen::Matrix<double, 64, 64>;
using Vector64 = Eigen::Matrix<double, 64, 1>;

/// Integral over a cell of the squared third derivatives of f, as a quadratic form in the cell's 64 coefficients:
/// sum over p + q + r = 3 of 3!/(p! q! r!) M_p (x) M_q (x) M_r with M_p the integrals of products of p-th derivatives.
Matrix64 smoothing_matrix() {
  constexpr std::array<double, 4> points{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
  constexpr std::array<double, 4> weights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                          0.3478548451374538};
  std::array<Eigen::Matrix4d, 4> m;
  m.fill(Eigen::Matrix4d::Zero());
  for (int g = 0; g < 4; ++g) {
    const Eigen::Matrix4d b = cubic_splines(0.5 + 0.5 * points[g]);
    for (int p = 0; p < 4; ++p) {
      m[p] += 0.5 * weights[g] * b.row(p).transpose() * b.row(p);
    }
  }
  constexpr std::array<double, 4> factorial{1.0, 1.0, 2.0, 6.0};
  Matrix64 k = Matrix64::Zero();
  for (int p = 0; p <= 3; ++p) {
    for (int q = 0; p + q <= 3; ++q) {
      const int r = 3 - p - q;
      const double multiplicity = 6.0 / (factorial[p] * factorial[q] * factorial[r]);
      for (int a = 0; a < 64; ++a) {
        for (int b = 0; b < 64; ++b) {
          k(a, b) += multiplicity * m[p](a / 16, b / 16) * m[q](a / 4 % 4, b / 4 % 4) * m[r](a % 4, b % 4);
        }
      }
    }
  }
  return k;
}

/// Normal equations. The column of each unknown holds its couplings with the nodes at grid offsets (di, dj, dk) that
/// come after it in the numbering, which runs through the grid in the order (i, j, k).
class NormalEquations {
 public:
  explicit NormalEquations(const CellGrid& grid)
      : grid_(grid), right_(grid.unknowns(), 0.0), values_(static_cast<std::size_t>(grid.unknowns()) * stored, 0.0) {}

  void add(const std::array<int, 3>& at, const Matrix64& matrix) {
    const auto unknowns = cell_unknowns(at);
    for (int a = 0; a < 64; ++a) {
      double* column = &values_[static_cast<std::size_t>(unknowns[a]) * stored];
      for (int b = a; b < 64; ++b) {
        const int offset = ((b / 16 - a / 16) * 7 + b / 4 % 4 - a / 4 % 4) * 7 + b % 4 - a % 4;
        column[offset] += matrix(a, b);
      }
    }
  }
  void add(const std::array<int, 3>& at, const Vector64& vector) {
    const auto unknowns = cell_unknowns(at);
    for (int a = 0; a < 64; ++a) {
      right_[unknowns[a]] += vector[a];
    }
  }
  std::vector<double> solve() const;

 private:
  std::array<int, 64> cell_unknowns(const std::array<int, 3>& at) const {
    std::array<int, 64> unknowns;
    for (int n = 0; n < 64; ++n) {
      unknowns[n] = grid_.unknown(at[0] + n / 16, at[1] + n / 4 % 4, at[2] + n % 4);
    }
    return unknowns;
  }
  /// Unknown at the stored offset from `node`, -1 if there is none.
  int neighbour(const std::array<int, 3>& node, int offset) const;
  void fill(cholmod_sparse* matrix) const;

  const CellGrid& grid_;
  std::vector<double> right_;
  std::vector<double> values_;
};

int NormalEquations::neighbour(const std::array<int, 3>& node, int offset) const {
  const int full = offset + offsets / 2;
  const std::array<int, 3> at{node[0] + full / 49 - 3, node[1] + full / 7 % 7 - 3, node[2] + full % 7 - 3};
  for (int axis = 0; axis < 3; ++axis) {
    if (at[axis] < 0 || at[axis] >= grid_.cells()[axis] + 3) {
      return -1;
    }
  }
  return grid_.unknown(at[0], at[1], at[2]);
}

void NormalEquations::fill(cholmod_sparse* matrix) const {
  auto* starts = static_cast<int*>(matrix->p);
  auto* rows = static_cast<int*>(matrix->i);
  auto* entries = static_cast<double*>(matrix->x);
  int count = 0;
  for (int column = 0; column < grid_.unknowns(); ++column) {
    starts[column] = count;
    for (int offset = 0; offset < stored; ++offset) {
      const double value = values_[static_cast<std::size_t>(column) * stored + offset];
      if (value != 0.0) {
        rows[count] = neighbour(grid_.nodes()[column], offset);
        entries[count++] = value + (offset == 0 ? ridge : 0.0);
      }
    }
  }
  starts[grid_.unknowns()] = count;
}

/// Keeps CHOLMOD and BLAS on one thread while it lives. CHOLMOD asks for four threads whatever OMP_NUM_THREADS says,
/// and they spin: with as many ranks or programs as cores, the fit took 50 times longer.
class OneThread {
 public:
  OneThread() : levels_(omp_get_max_active_levels()) {
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
  }
  ~OneThread() { omp_set_max_active_levels(levels_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_;
};

std::vector<double> NormalEquations::solve() const {
  const std::size_t n = right_.size();
  const std::size_t nonzeros = values_.size() - std::count(values_.begin(), values_.end(), 0.0);
  const OneThread one_thread;
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.print = 0;
  cholmod_sparse* matrix = cholmod_allocate_sparse(n, n, nonzeros, 1, 1, -1, CHOLMOD_REAL, &common);
  fill(matrix);
  cholmod_factor* factor = cholmod_analyze(matrix, &common);
  cholmod_factorize(matrix, factor, &common);
  const bool good = common.status == CHOLMOD_OK;
  std::vector<double> solution;
  if (good) {
    cholmod_dense* right = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &common);
    std::copy(right_.begin(), right_.end(), static_cast<double*>(right->x));
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, right, &common);
    const auto* values = static_cast<const double*>(x->x);
    solution.assign(values, values + n);
    cholmod_free_dense(&right, &common);
    cholmod_free_dense(&x, &common);
  }
  cholmod_free_factor(&factor, &common);
  cholmod_free_sparse(&matrix, &common);
  cholmod_finish(&common);
  if (!good) {
    throw base::InputError(
        "the smooth surface of the body cannot be fitted: its system of equations is singular; "
        "a larger cell or more smoothing (list Body, parameters cell and smoothing) helps");
  }
  return solution;
}

void add_vertex(const CellGrid& grid, const Vec3& vertex, const Vec3& normal, double weight, double weight_of_normal,
                NormalEquations* equations) {
  const Vec3 x = grid.local(vertex);
  std::array<int, 3> at;
  if (!grid.locate(x, &at)) {
    return;  // a vertex that no triangle uses
  }
  const std::array<Eigen::Matrix4d, 3> b{cubic_splines(x[0] - at[0]), cubic_splines(x[1] - at[1]),
                                         cubic_splines(x[2] - at[2])};
  Eigen::Matrix<double, 64, 4> rows;  // f and its gradient as functions of the coefficients
  for (int n = 0; n < 64; ++n) {
    for (int r = 0; r < 4; ++r) {
      rows(n, r) = b[0](r == 1, n / 16) * b[1](r == 2, n / 4 % 4) * b[2](r == 3, n % 4);
    }
  }
  const Eigen::Vector4d weights(weight, weight_of_normal, weight_of_normal, weight_of_normal);
  const Eigen::Vector4d wanted(0.0, normal.x(), normal.y(), normal.z());
  equations->add(at, Matrix64((rows * weights.asDiagonal()).lazyProduct(rows.transpose())));
  equations->add(at, Vector64(rows * weights.cwiseProduct(wanted)));
}

}  // namespace

SplineField fit_level_set(const TriangleMesh& mesh, double cell, double smoothing) {
  CellGrid grid(mesh, cell);
  NormalEquations equations(grid);
  const auto normals = vertex_normals(mesh);
  const auto areas = vertex_areas(mesh);
  const auto border = border_vertices(mesh);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const double weight = areas[i] / (cell * cell);
    // On a border the facets of one side only would tilt the normal.
    add_vertex(grid, mesh.vertices[i], normals[i], weight, border[i] ? 0.0 : normal_weight * weight, &equations);
  }
  const Matrix64 third_derivatives = smoothing * smoothing_matrix();
  for (int i = 0; i < grid.cells()[0]; ++i) {
    for (int j = 0; j < grid.cells()[1]; ++j) {
      for (int k = 0; k < grid.cells()[2]; ++k) {
        if (grid.is_active(i, j, k)) {
          equations.add({i, j, k}, third_derivatives);
        }
      }
    }
  }
  std::vector<double> coefficients = equations.solve();
  return {std::move(grid), std::move(coefficients)};
}

}  // namespace toile::body
