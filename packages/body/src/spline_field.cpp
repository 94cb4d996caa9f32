#include "spline_field.hpp"

#include <utility>

namespace toile::body {

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

SplineField::SplineField(std::shared_ptr<const SheetGrid> grid, const std::vector<double>& coefficients)
    : grid_(std::move(grid)), coefficients_(grid_->cells().size()) {
  for (std::size_t c = 0; c < coefficients_.size(); ++c) {
    for (int n = 0; n < 64; ++n) {
      coefficients_[c](n % 4, n / 4) = coefficients[grid_->cells()[c].unknowns[n]];
    }
  }
}

SplineField::Value SplineField::evaluate(int cell, const Vec3& point) const {
  const auto& at = grid_->cells()[cell].at;
  const Vec3 t = grid_->local(point) - Vec3(at[0], at[1], at[2]);
  const Eigen::Matrix4d bx = cubic_splines(t[0]), by = cubic_splines(t[1]), bz = cubic_splines(t[2]);
  // Derivatives of order p, q, r in x, y, z, one direction after the other.
  const Eigen::Matrix<double, 3, 16> z = bz.topRows<3>() * coefficients_[cell];
  Eigen::Matrix<double, 6, 4> yz;  // (q, r) = 00 01 02 10 11 20; column: spline in x
  for (int i = 0; i < 4; ++i) {
    const Eigen::Matrix3d products = z.middleCols<4>(4 * i) * by.topRows<3>().transpose();  // (r, q)
    yz.col(i) << products(0, 0), products(1, 0), products(2, 0), products(0, 1), products(1, 1), products(0, 2);
  }
  const Eigen::Matrix<double, 6, 3> all = yz * bx.topRows<3>().transpose();
  const double h = grid_->cell();
  Value result;
  result.value = h * all(0, 0);
  result.gradient = {all(0, 1), all(3, 0), all(1, 0)};
  result.hessian << all(0, 2), all(3, 1), all(1, 1),  //
      all(3, 1), all(5, 0), all(4, 0),                //
      all(1, 1), all(4, 0), all(2, 0);
  result.hessian /= h;
  return result;
}

}  // namespace toile::body
