#include "fit_level_set.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "local_smoothing.hpp"
#include "mesh_geometry.hpp"
#include "normal_equations.hpp"
#include "surface_samples.hpp"

namespace toile::body {
namespace {

constexpr double normal_weight = 0.03 * 0.03;  ///< of |grad f - n|^2 beside f^2, lengths in cells
constexpr double ridge = 1e-9;                 ///< keeps coefficients that no datum fixes near zero
/// Of the logarithm of the smoothing: what the surface changes by over it is as large as the error of its curvature, be
/// that noise of the vertices or the smoothing's own (test_body_doubt).
constexpr double doubted = 1.8;
/// The integral of the third derivatives counts as if it were taken over this many cells of thickness everywhere,
/// whatever the layers of active cells that the surface happens to have.
constexpr double thickness = 4.0;

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

struct Datum {
  Vec3 point;
  Vec3 normal;
  double weight = 0.0;            ///< of f^2
  double weight_of_normal = 0.0;  ///< of |grad f - normal|^2
};

void add_datum(const SheetGrid& grid, int cell, const Datum& datum, NormalEquations* equations) {
  const auto& at = grid.cells()[cell].at;
  const Vec3 t = grid.local(datum.point) - Vec3(at[0], at[1], at[2]);
  const std::array<Eigen::Matrix4d, 3> b{cubic_splines(t[0]), cubic_splines(t[1]), cubic_splines(t[2])};
  Eigen::Matrix<double, 64, 4> rows;  // f and its gradient as functions of the coefficients
  for (int n = 0; n < 64; ++n) {
    for (int r = 0; r < 4; ++r) {
      rows(n, r) = b[0](r == 1, n / 16) * b[1](r == 2, n / 4 % 4) * b[2](r == 3, n % 4);
    }
  }
  const Eigen::Vector4d weights(datum.weight, datum.weight_of_normal, datum.weight_of_normal, datum.weight_of_normal);
  const Eigen::Vector4d wanted(0.0, datum.normal.x(), datum.normal.y(), datum.normal.z());
  equations->add(cell, Matrix64((rows * weights.asDiagonal()).lazyProduct(rows.transpose())));
  equations->add(cell, Vector64(rows * weights.cwiseProduct(wanted)));
}

}  // namespace

LevelSetFit fit_level_set(const TriangleMesh& mesh, const SurfaceSamples& samples, double cell, double smoothing) {
  const auto shared = std::make_shared<const SheetGrid>(samples, cell);
  const SheetGrid& grid = *shared;
  NormalEquations equations(grid);
  const auto areas = vertex_areas(mesh);
  const auto border = border_vertices(mesh);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0) / (cell * cell);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const int sample = static_cast<int>(i);
    const int at = grid.cell_of(grid.local(mesh.vertices[i]), sample);
    if (at < 0 || areas[i] == 0.0) continue;  // a vertex that no triangle uses
    const double weight = areas[i] / (cell * cell);
    // On a border the facets of one side only would tilt the normal.
    add_datum(grid, at, {mesh.vertices[i], samples.normals[i], weight, border[i] ? 0.0 : normal_weight * weight},
              &equations);
  }
  const double layers = static_cast<double>(grid.cells().size()) / area;
  const Matrix64 third_derivatives = thickness / layers * smoothing_matrix();
  const auto weights = local_smoothing(grid, samples, mean_edge_length(mesh), smoothing);
  for (std::size_t c = 0; c < grid.cells().size(); ++c) {
    equations.add(static_cast<int>(c), Matrix64(weights[c] * third_derivatives));
  }
  // (D + lambda K) c = b for all lambda, so (D + lambda K) dc/d(log lambda) = -lambda K c.
  const auto by_smoothing = [&](const std::vector<double>& coefficients) {
    std::vector<double> right(coefficients.size(), 0.0);
    for (std::size_t c = 0; c < grid.cells().size(); ++c) {
      const auto& unknowns = grid.cells()[c].unknowns;
      Vector64 values;
      for (int a = 0; a < 64; ++a) values[a] = coefficients[unknowns[a]];
      const Vector64 product = -doubted * weights[c] * (third_derivatives * values);
      for (int a = 0; a < 64; ++a) right[unknowns[a]] += product[a];
    }
    return right;
  };
  const auto [coefficients, doubts] = equations.solve(ridge, by_smoothing);
  return {{shared, coefficients}, {shared, doubts}};
}

}  // namespace toile::body
