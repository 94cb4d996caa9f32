#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "toile/element/element.hpp"

namespace toile::element {

/// Material points of a chunk of elements and what the material answers; layouts as in material::LawV1.
struct PointResponse {
  int n = 0;
  std::vector<double> C, W, S, D, thickness_stretch, params;
  std::vector<std::uint8_t> status;

  void resize(int points) {
    n = points;
    C.resize(3 * points);
    W.resize(points);
    S.resize(3 * points);
    D.resize(6 * points);
    thickness_stretch.resize(points);
    status.resize(points);
  }
  void set_C(int k, const double (&values)[3]) {
    for (int q = 0; q < 3; ++q) C[q * n + k] = values[q];
  }
  /// Evaluates the material of `batch` at all points, `per_element` in a row, of the elements from `first` on.
  void evaluate(const Batch& batch, int first, int per_element, bool with_tangent) {
    if (batch.graduated) spread_params(batch, first, per_element);
    batch.response->evaluate(n, C.data(), params_of(batch), batch.graduated ? 1 : 0, W.data(), S.data(),
                             with_tangent ? D.data() : nullptr, thickness_stretch.data(), status.data());
  }
  /// Wrinkles at the same points: state [n] and direction [2][n] as of material::Response.
  void wrinkles(const Batch& batch, int first, int per_element, std::vector<material::WrinkleState>& state,
                std::vector<double>& direction) {
    if (batch.graduated) spread_params(batch, first, per_element);
    state.resize(n);
    direction.resize(2 * static_cast<std::size_t>(n));
    batch.response->wrinkles(n, C.data(), params_of(batch), batch.graduated ? 1 : 0, state.data(), direction.data());
  }
  /// Scaled entry k of the structure of arrays `values` [Size][n].
  template <int Size>
  void pick(const std::vector<double>& values, int k, double scale, double (&out)[Size]) const {
    for (int q = 0; q < Size; ++q) out[q] = scale * values[q * n + k];
  }

 private:
  const double* params_of(const Batch& batch) const { return batch.graduated ? params.data() : batch.params; }
  void spread_params(const Batch& batch, int first, int per_element) {
    const int n_params = batch.response->n_params();
    params.resize(static_cast<std::size_t>(n_params) * n);
    for (int k = 0; k < n; ++k) {
      const double* values = batch.params + static_cast<std::ptrdiff_t>(first + k / per_element) * n_params;
      for (int q = 0; q < n_params; ++q) params[q * n + k] = values[q];
    }
  }
};

/// Appends the crest of a wrinkle whose direction in the material frame is (d1, d2), as a unit vector in space; zero
/// where there is none. a: columns of F in the material frame.
inline void add_crest(const double (&a)[2][3], double d1, double d2, PointFields& out) {
  double crest[3], squared = 0.0;
  for (int i = 0; i < 3; ++i) {
    crest[i] = d1 * a[0][i] + d2 * a[1][i];
    squared += crest[i] * crest[i];
  }
  for (const double value : crest) out.wrinkle_crest.push_back(squared > 0.0 ? value / std::sqrt(squared) : 0.0);
}

}  // namespace toile::element
