#include "fit_spline.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "normal_equations.hpp"

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

/// f and its gradient at the datum, lengths in cells, as functions of the cell's coefficients.
Eigen::Matrix<double, 64, 4> splines_at(const SheetGrid& grid, const LevelSetDatum& datum) {
  const auto& at = grid.cells()[datum.cell].at;
  const Vec3 t = grid.local(datum.point) - Vec3(at[0], at[1], at[2]);
  const std::array<Eigen::Matrix4d, 3> b{cubic_splines(t[0]), cubic_splines(t[1]), cubic_splines(t[2])};
  Eigen::Matrix<double, 64, 4> rows;
  for (int n = 0; n < 64; ++n) {
    for (int r = 0; r < 4; ++r) {
      rows(n, r) = b[0](r == 1, n / 16) * b[1](r == 2, n / 4 % 4) * b[2](r == 3, n % 4);
    }
  }
  return rows;
}

Eigen::Vector4d weights_of(const SheetGrid& grid, const LevelSetDatum& datum) {
  const double weight = datum.area / (grid.cell() * grid.cell());
  const double of_gradient = datum.has_gradient ? normal_weight * weight : 0.0;
  return {weight, of_gradient, of_gradient, of_gradient};
}

/// Lengths in cells.
Eigen::Vector4d in_cells(const SheetGrid& grid, const Eigen::Vector4d& value_and_gradient) {
  return {value_and_gradient[0] / grid.cell(), value_and_gradient[1], value_and_gradient[2], value_and_gradient[3]};
}

}  // namespace

FittedSplines fit_spline(std::shared_ptr<const SheetGrid> shared, const std::vector<LevelSetDatum>& data,
                         const std::vector<double>& smoothing, double area, const std::vector<char>& held) {
  const SheetGrid& grid = *shared;
  NormalEquations equations(grid, held);
  std::vector<double> wanted(grid.unknowns(), 0.0), changes(grid.unknowns(), 0.0);
  const auto add = [&grid](int cell, const Vector64& values, std::vector<double>* right) {
    for (int a = 0; a < 64; ++a) (*right)[grid.cells()[cell].unknowns[a]] += values[a];
  };
  for (const LevelSetDatum& datum : data) {
    const auto rows = splines_at(grid, datum);
    const Eigen::Vector4d weights = weights_of(grid, datum);
    equations.add(datum.cell, Matrix64((rows * weights.asDiagonal()).lazyProduct(rows.transpose())));
    add(datum.cell, rows * weights.cwiseProduct(in_cells(grid, datum.wanted)), &wanted);
    add(datum.cell, rows * weights.cwiseProduct(in_cells(grid, datum.change)), &changes);
  }
  const double layers = static_cast<double>(grid.cells().size()) / (area / (grid.cell() * grid.cell()));
  const Matrix64 third_derivatives = thickness / layers * smoothing_matrix();
  for (std::size_t c = 0; c < grid.cells().size(); ++c) {
    equations.add(static_cast<int>(c), Matrix64(smoothing[c] * third_derivatives));
  }
  // (D + lambda K) c = b for all lambda, so (D + lambda K) dc/d(log lambda) = db/d(log lambda) - lambda K c.
  const auto by_smoothing = [&](const std::vector<double>& coefficients) {
    std::vector<double> right = changes;
    for (std::size_t c = 0; c < grid.cells().size(); ++c) {
      Vector64 values;
      for (int a = 0; a < 64; ++a) values[a] = coefficients[grid.cells()[c].unknowns[a]];
      add(static_cast<int>(c), -doubted * smoothing[c] * (third_derivatives * values), &right);
    }
    return right;
  };
  const auto [values, doubts] = equations.solve(ridge, wanted, by_smoothing);
  return {{shared, values}, {shared, doubts}};
}

}  // namespace toile::body
