#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "toile/element/element.hpp"

namespace toile::element {

/// Material points of a chunk of elements and what the material answers; layouts as in material::MaterialV1.
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
    const double* values = batch.graduated ? params.data() : batch.params;
    batch.response->evaluate(n, C.data(), values, batch.graduated ? 1 : 0, W.data(), S.data(),
                             with_tangent ? D.data() : nullptr, thickness_stretch.data(), status.data());
  }
  /// Scaled entry k of the structure of arrays `values` [Size][n].
  template <int Size>
  void pick(const std::vector<double>& values, int k, double scale, double (&out)[Size]) const {
    for (int q = 0; q < Size; ++q) out[q] = scale * values[q * n + k];
  }

 private:
  void spread_params(const Batch& batch, int first, int per_element) {
    const int n_params = batch.response->n_params();
    params.resize(static_cast<std::size_t>(n_params) * n);
    for (int k = 0; k < n; ++k) {
      const double* values = batch.params + static_cast<std::ptrdiff_t>(first + k / per_element) * n_params;
      for (int q = 0; q < n_params; ++q) params[q * n + k] = values[q];
    }
  }
};

}  // namespace toile::element
