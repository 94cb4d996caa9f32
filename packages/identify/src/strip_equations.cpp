#include "strip_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "toile/material/response.hpp"

namespace toile::identify {
namespace {

constexpr int corners = 4;
constexpr int plane_dofs = 2 * corners;
/// Exponent of the grading, see GridOptions: the displacement at a corner behaves as r^0.69 in an isotropic fabric and
/// about r^0.46 in the bias of the Itskov pantyhose fabric (with an exponent of 2 the force converges as h^1.84 there).
constexpr double grading = 2.5;

mesh::Grid strip_grid(const StripSpecimen& specimen) {
  mesh::GridOptions options;
  options.across = specimen.elements_across;
  options.along = specimen.elements_along();
  options.grading_across = options.grading_along = grading;
  return mesh::mesh_four_sided("strip", mesh::rectangle(1.0, specimen.length / specimen.width), options);
}

/// Degree of freedom of a membrane, which has three a node.
constexpr int in_space(int dof) {
  return 3 * (dof / 2) + dof % 2;
}

/// For strains alone: asks no law.
class NoStress final : public material::Response {
 public:
  int n_params() const override { return 0; }
  int evaluate(int n, const double*, const double*, int, double* W, double* S, double* D, double* thickness_stretch,
               std::uint8_t* status) const override {
    std::fill_n(W, n, 0.0);
    std::fill_n(S, 3 * n, 0.0);
    if (D != nullptr) std::fill_n(D, 6 * n, 0.0);
    std::fill_n(thickness_stretch, n, 1.0);
    std::fill_n(status, n, material::point_ok);
    return 0;
  }
  double natural_shear_modulus(const double*) const override { return 0.0; }
};

}  // namespace

StripEquations::StripEquations(const StripSpecimen& specimen, double wale_angle)
    : length_(specimen.length / specimen.width), element_(*element::find("membrane4")) {
  const mesh::Grid grid = strip_grid(specimen);
  connectivity_ = grid.connectivity;
  const std::size_t n = connectivity_.size() / corners;
  for (const int node : connectivity_) {
    pattern_.push_back(grid.nodes[node].x());
    pattern_.push_back(grid.nodes[node].y());
  }
  angles_.assign(n, 0.5 * std::acos(-1.0) + wale_angle);
  x_.assign(3 * corners * n, 0.0);
  energies_.resize(n);
  residuals_.resize(3 * corners * n);
  tangents_.resize(9 * corners * corners * n);
  batch_.n = static_cast<int>(n);
  batch_.pattern = pattern_.data();
  batch_.x = x_.data();
  batch_.wale_angle = angles_.data();
  std::vector<double> areas(corners * n);
  element_.reference_areas(batch_, areas.data());
  // Elements are rectangles: all points of one have the same share.
  for (std::size_t e = 0; e < n; ++e)
    weight_.push_back(std::accumulate(&areas[corners * e], &areas[corners * e] + corners, 0.0) / element_.points());
  number_unknowns(grid);
  build_pattern();
}

void StripEquations::number_unknowns(const mesh::Grid& grid) {
  const auto dofs = static_cast<Eigen::Index>(2 * grid.nodes.size());
  at_rest_.resize(dofs);
  pull_ = Vector::Zero(dofs);
  gradient_.resize(dofs);
  for (std::size_t i = 0; i < grid.nodes.size(); ++i)
    at_rest_.segment<2>(2 * static_cast<Eigen::Index>(i)) = grid.nodes[i];
  free_.assign(2 * grid.nodes.size(), 0);
  for (const int row : {0, grid.along})
    for (const int node : grid.row(row)) free_[2 * node] = free_[2 * node + 1] = -1;
  for (const int node : grid.row(grid.along)) pull_[2 * node + 1] = 1.0;
  for (int& number : free_)
    if (number == 0) number = n_free_++;
  pulled_.resize(dofs);
}

void StripEquations::build_pattern() {
  const auto dof = [&](std::size_t e, int i) { return 2 * connectivity_[corners * e + i / 2] + i % 2; };
  const auto n = static_cast<std::size_t>(batch_.n);
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t e = 0; e < n; ++e)
    for (int r = 0; r < plane_dofs; ++r)
      for (int c = 0; c < plane_dofs; ++c) {
        const int row = free_[dof(e, r)], column = free_[dof(e, c)];
        if (column >= 0 && row >= column) triplets.emplace_back(row, column, 0.0);
      }
  K_.resize(n_free_, n_free_);
  K_.setFromTriplets(triplets.begin(), triplets.end());
  factors_.analyzePattern(K_);
  entry_.assign(n * plane_dofs * plane_dofs, -1);
  for (std::size_t e = 0; e < n; ++e)
    for (int r = 0; r < plane_dofs; ++r)
      for (int c = 0; c < plane_dofs; ++c) {
        const int row = free_[dof(e, r)], column = free_[dof(e, c)];
        if (column < 0 || row < column) continue;
        const int* first = K_.innerIndexPtr();
        const int* place =
            std::lower_bound(first + K_.outerIndexPtr()[column], first + K_.outerIndexPtr()[column + 1], row);
        entry_[(e * plane_dofs + r) * plane_dofs + c] = static_cast<int>(place - first);
      }
}

void StripEquations::set_law(const material::LawV1& law, const double* params) {
  law_ = &law;
  params_ = params;
}

void StripEquations::gather(const Vector& x) {
  for (std::size_t i = 0; i < connectivity_.size(); ++i) {
    x_[3 * i] = x[2 * connectivity_[i]];
    x_[3 * i + 1] = x[2 * connectivity_[i] + 1];
  }
}

double StripEquations::evaluate(const Vector& x) {
  gather(x);
  const material::PlainResponse response(*law_);
  batch_.response = &response;
  batch_.params = params_;
  element::Result result;
  result.energy = energies_.data();
  result.residual = residuals_.data();
  result.tangent = tangents_.data();
  element_.evaluate(batch_, result);
  assemble();
  return std::accumulate(energies_.begin(), energies_.end(), 0.0);
}

void StripEquations::assemble() {
  gradient_.setZero();
  pulled_.setZero();
  std::fill_n(K_.valuePtr(), K_.nonZeros(), 0.0);
  constexpr int dofs = 3 * corners;
  for (std::size_t e = 0; e < static_cast<std::size_t>(batch_.n); ++e) {
    const double* R = &residuals_[e * dofs];
    const double* K = &tangents_[e * dofs * dofs];
    const int* entry = &entry_[e * plane_dofs * plane_dofs];
    for (int r = 0; r < plane_dofs; ++r) {
      const int row = 2 * connectivity_[corners * e + r / 2] + r % 2;
      gradient_[row] += R[in_space(r)];
      for (int c = 0; c < plane_dofs; ++c) {
        const double value = K[in_space(r) * dofs + in_space(c)];
        const int column = 2 * connectivity_[corners * e + c / 2] + c % 2;
        if (entry[r * plane_dofs + c] >= 0) K_.valuePtr()[entry[r * plane_dofs + c]] += value;
        pulled_[row] += value * pull_[column];
      }
    }
  }
}

bool StripEquations::factorise(double shift) {
  ++factorisations_;
  factors_.setShift(shift * K_.diagonal().mean());
  factors_.factorize(K_);
  return factors_.info() == Eigen::Success && factors_.vectorD().minCoeff() > 0.0;
}

StripEquations::Vector StripEquations::solve(const Vector& load) const {
  Vector free(n_free_);
  for (std::size_t i = 0; i < free_.size(); ++i)
    if (free_[i] >= 0) free[free_[i]] = load[static_cast<Eigen::Index>(i)];
  const Vector solution = factors_.solve(free);
  Vector all = Vector::Zero(load.size());
  for (std::size_t i = 0; i < free_.size(); ++i)
    if (free_[i] >= 0) all[static_cast<Eigen::Index>(i)] = -solution[free_[i]];
  return all;
}

std::vector<double> StripEquations::cauchy_green(const Vector& x) {
  gather(x);
  const NoStress response;
  batch_.response = &response;
  const std::vector<double> by_point = element_.fields(batch_).C;
  const std::size_t n = by_point.size() / 3;
  std::vector<double> C(by_point.size());
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t i = 0; i < 3; ++i) C[i * n + p] = by_point[3 * p + i];
  return C;
}

void StripEquations::sensitivities(const Vector& x, const Vector& v, double* out, std::size_t stride) {
  const std::vector<double> C = cauchy_green(x);
  // C is quadratic in the positions: its derivative along v is a difference without error.
  std::vector<double> dE = cauchy_green(x + v);
  const std::vector<double> back = cauchy_green(x - v);
  const std::size_t n = C.size() / 3, n_params = static_cast<std::size_t>(law_->n_params);
  const std::size_t points = n / weight_.size();
  for (std::size_t i = 0; i < dE.size(); ++i)
    dE[i] = (i < 2 * n ? 0.25 : 0.5) * (dE[i] - back[i]) * weight_[(i % n) / points];
  std::vector<double> W(n), S(3 * n), D(6 * n), thickness(n), dSdp(3 * n_params * n);
  std::vector<std::uint8_t> status(n);
  law_->evaluate(law_->context, static_cast<int>(n), C.data(), params_, 0, W.data(), S.data(), D.data(),
                 thickness.data(), dSdp.data(), status.data());
  for (std::size_t k = 0; k < n_params; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += std::inner_product(&dE[i * n], &dE[i * n] + n, &dSdp[(i * n_params + k) * n], 0.0);
    out[k * stride] = sum;
  }
}

}  // namespace toile::identify
