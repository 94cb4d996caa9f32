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

StripEquations::Elements::Elements(const mesh::Grid& grid, double wale_angle)
    : kind(*element::find("membrane4")), connectivity(grid.connectivity) {
  const std::size_t n = connectivity.size() / corners;
  for (const int node : connectivity) {
    pattern.push_back(grid.nodes[node].x());
    pattern.push_back(grid.nodes[node].y());
  }
  angles.assign(n, 0.5 * std::acos(-1.0) + wale_angle);
  x.assign(3 * corners * n, 0.0);
  energies.resize(n);
  residuals.resize(3 * corners * n);
  tangents.resize(9 * corners * corners * n);
  std::vector<double> areas(corners * n);
  kind.reference_areas(batch(nullptr, nullptr), areas.data());
  // Elements are rectangles: all points of one have the same share.
  for (std::size_t e = 0; e < n; ++e)
    weight.push_back(std::accumulate(&areas[corners * e], &areas[corners * e] + corners, 0.0) / kind.points());
}

element::Batch StripEquations::Elements::batch(const material::Response* response, const double* params) const {
  element::Batch b;
  b.n = static_cast<int>(energies.size());
  b.pattern = pattern.data();
  b.x = x.data();
  b.wale_angle = angles.data();
  b.response = response;
  b.params = params;
  return b;
}

void StripEquations::Elements::gather(const Vector& positions) {
  for (std::size_t i = 0; i < connectivity.size(); ++i) {
    x[3 * i] = positions[2 * connectivity[i]];
    x[3 * i + 1] = positions[2 * connectivity[i] + 1];
  }
}

int StripEquations::Elements::dof(std::size_t e, int i) const {
  return 2 * connectivity[corners * e + static_cast<std::size_t>(i) / 2] + i % 2;
}

StripEquations::StripEquations(const StripSpecimen& specimen, double wale_angle)
    : StripEquations(strip_grid(specimen), wale_angle, specimen.length / specimen.width) {}

StripEquations::StripEquations(const mesh::Grid& grid, double wale_angle, double length)
    : length_(length), elements_(grid, wale_angle) {
  number_unknowns(grid);
  tangent_.find_places(elements_, free_);
}

void StripEquations::number_unknowns(const mesh::Grid& grid) {
  const auto dofs = static_cast<Eigen::Index>(2 * grid.nodes.size());
  at_rest_.resize(dofs);
  pull_ = Vector::Zero(dofs);
  gradient_.resize(dofs);
  for (std::size_t i = 0; i < grid.nodes.size(); ++i)
    at_rest_.segment<2>(2 * static_cast<Eigen::Index>(i)) = grid.nodes[i];
  free_.number.assign(2 * grid.nodes.size(), 0);
  for (const int row : {0, grid.along})
    for (const int node : grid.row(row)) free_.number[2 * node] = free_.number[2 * node + 1] = -1;
  for (const int node : grid.row(grid.along)) pull_[2 * node + 1] = 1.0;
  for (int& number : free_.number)
    if (number == 0) number = free_.count++;
  pulled_.resize(dofs);
}

void StripEquations::Tangent::find_places(const Elements& elements, const Free& free) {
  const std::size_t n = elements.energies.size();
  const auto for_each = [&](const auto& use) {  // entry of an element that is in the lower triangle
    for (std::size_t e = 0; e < n; ++e)
      for (int r = 0; r < plane_dofs; ++r)
        for (int c = 0; c < plane_dofs; ++c) {
          const int row = free.number[elements.dof(e, r)], column = free.number[elements.dof(e, c)];
          if (column >= 0 && row >= column) use((e * plane_dofs + r) * plane_dofs + c, row, column);
        }
  };
  std::vector<Eigen::Triplet<double>> triplets;
  for_each([&](std::size_t, int row, int column) { triplets.emplace_back(row, column, 0.0); });
  K.resize(free.count, free.count);
  K.setFromTriplets(triplets.begin(), triplets.end());
  factors.analyzePattern(K);
  place.assign(n * plane_dofs * plane_dofs, -1);
  for_each([&](std::size_t entry, int row, int column) {
    const int* first = K.innerIndexPtr();
    const int* found = std::lower_bound(first + K.outerIndexPtr()[column], first + K.outerIndexPtr()[column + 1], row);
    place[entry] = static_cast<int>(found - first);
  });
}

void StripEquations::set_law(const material::LawV1& law, const double* params) {
  law_ = &law;
  params_ = params;
}

double StripEquations::evaluate(const Vector& x) {
  elements_.gather(x);
  const material::PlainResponse response(*law_);
  element::Result result;
  result.energy = elements_.energies.data();
  result.residual = elements_.residuals.data();
  result.tangent = elements_.tangents.data();
  elements_.kind.evaluate(elements_.batch(&response, params_), result);
  assemble();
  return std::accumulate(elements_.energies.begin(), elements_.energies.end(), 0.0);
}

void StripEquations::assemble() {
  gradient_.setZero();
  pulled_.setZero();
  double* values = tangent_.K.valuePtr();
  std::fill_n(values, tangent_.K.nonZeros(), 0.0);
  constexpr int dofs = 3 * corners;
  for (std::size_t e = 0; e < elements_.energies.size(); ++e) {
    const double* R = &elements_.residuals[e * dofs];
    const double* K = &elements_.tangents[e * dofs * dofs];
    const int* place = &tangent_.place[e * plane_dofs * plane_dofs];
    for (int r = 0; r < plane_dofs; ++r) {
      const int row = elements_.dof(e, r);
      gradient_[row] += R[in_space(r)];
      for (int c = 0; c < plane_dofs; ++c) {
        const double value = K[in_space(r) * dofs + in_space(c)];
        if (place[r * plane_dofs + c] >= 0) values[place[r * plane_dofs + c]] += value;
        pulled_[row] += value * pull_[elements_.dof(e, c)];
      }
    }
  }
}

bool StripEquations::factorise(double shift) {
  ++factorisations_;
  tangent_.factors.setShift(shift * tangent_.K.diagonal().mean());
  tangent_.factors.factorize(tangent_.K);
  return tangent_.factors.info() == Eigen::Success && tangent_.factors.vectorD().minCoeff() > 0.0;
}

StripEquations::Vector StripEquations::solve(const Vector& load) const {
  const std::vector<int>& number = free_.number;
  Vector free(free_.count);
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) free[number[i]] = load[static_cast<Eigen::Index>(i)];
  const Vector solution = tangent_.factors.solve(free);
  Vector all = Vector::Zero(load.size());
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0) all[static_cast<Eigen::Index>(i)] = -solution[number[i]];
  return all;
}

std::vector<double> StripEquations::cauchy_green(const Vector& x) {
  elements_.gather(x);
  const NoStress response;
  const std::vector<double> by_point = elements_.kind.fields(elements_.batch(&response, params_)).C;
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
  const std::vector<double>& weight = elements_.weight;
  const std::size_t points = n / weight.size();
  for (std::size_t i = 0; i < dE.size(); ++i)
    dE[i] = (i < 2 * n ? 0.25 : 0.5) * (dE[i] - back[i]) * weight[(i % n) / points];
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
