#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "membrane_point.hpp"
#include "point_response.hpp"
#include "point_tension.hpp"
#include "principal_stress.hpp"
#include "toile/element/element.hpp"

namespace toile::element {

/// Membrane with 3 unknowns a node (its position) for any isoparametric parent element.
///
/// The flat pattern is the reference. The energy is the sum over points of h0 W(C) detJ w; residual and tangent follow
/// by the chain rule from the material's S and D (see MembranePoint).
///
/// Thread-safe: a batch is worked off in chunks through buffers of the calling thread.
template <int Nodes, int Points>
class Membrane final : public Element {
 public:
  Membrane(const char* name, const char* text, const Rule<Nodes, Points>& rule)
      : name_(name), text_(text), rule_(rule) {}

  const char* name() const override { return name_; }
  const char* text() const override { return text_; }
  int nodes() const override { return Nodes; }
  int dofs_per_node() const override { return 3; }
  int points() const override { return Points; }

  void evaluate(const Batch& batch, const Result& result) const override;
  PointFields fields(const Batch& batch) const override;
  PointTensions tensions(const Batch& batch, const double* map) const override;
  void nodal_areas(const Batch& batch, double* areas) const override;
  void reference_areas(const Batch& batch, double* areas) const override;
  void gradient_products(const Batch& batch, double* products) const override;

 private:
  using Point = MembranePoint<Nodes>;
  static constexpr int dofs = Point::dofs;
  static constexpr int chunk_elements = 64;
  static constexpr int chunk_points = chunk_elements * Points;
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  /// Points of up to chunk_elements elements, and what the material answers (see LawV1 for the layouts).
  struct Chunk {
    int n = 0;  ///< points
    std::array<Point, chunk_points> point;
    std::array<double, 3 * chunk_points> C;
    std::array<double, chunk_points> W;
    std::array<double, 3 * chunk_points> S;
    std::array<double, 6 * chunk_points> D;
    std::array<double, chunk_points> thickness_stretch;
    std::array<std::uint8_t, chunk_points> status;
    std::vector<double> params;  ///< [n_params][n], only if graduated
  };

  /// The chunk of the calling thread, filled with the elements [first, first + count). `map`: as in tensions().
  const Chunk& fill(const Batch& batch, int first, int count, bool with_tangent, const double* map = nullptr) const;
  void kinematics(const Batch& batch, int first, int count, const double* map, Chunk& chunk) const;
  static void spread_params(const Batch& batch, int first, Chunk& chunk);
  static const double* params_of(const Batch& batch, const Chunk& chunk) {
    return batch.graduated ? chunk.params.data() : batch.params;
  }
  static void respond(const Batch& batch, int first, bool with_tangent, Chunk& chunk);

  /// Appends the wrinkles of the chunk's points.
  static void add_wrinkles(const Batch& batch, const Chunk& chunk, PointFields& out);

  static double energy(const Chunk& chunk, int begin);
  static void residual(const Chunk& chunk, int begin, double thickness, double* result);
  static void tangent(const Chunk& chunk, int begin, double thickness, double* result);
  static void set_nan(const Result& result, std::ptrdiff_t e) {
    if (result.energy) result.energy[e] = nan;
    if (result.residual) std::fill_n(result.residual + e * dofs, dofs, nan);
    if (result.tangent) std::fill_n(result.tangent + e * dofs * dofs, dofs * dofs, nan);
  }
  /// Scaled row k of the structure of arrays `values` [Size][n].
  template <int Size, std::size_t N>
  static void pick(const Chunk& chunk, const std::array<double, N>& values, int k, double scale, double (&out)[Size]) {
    for (int q = 0; q < Size; ++q) out[q] = scale * values[q * chunk.n + k];
  }

  const char* name_;
  const char* text_;
  Rule<Nodes, Points> rule_;
};

template <int Nodes, int Points>
auto Membrane<Nodes, Points>::fill(const Batch& batch, int first, int count, bool with_tangent, const double* map) const
    -> const Chunk& {
  thread_local Chunk chunk;
  kinematics(batch, first, count, map, chunk);
  respond(batch, first, with_tangent, chunk);
  return chunk;
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::kinematics(const Batch& batch, int first, int count, const double* map,
                                         Chunk& chunk) const {
  const auto dot = [](const double(&u)[3], const double(&v)[3]) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  chunk.n = count * Points;
  int k = 0;
  for (std::ptrdiff_t e = first; e < first + count; ++e) {
    const double cosine = std::cos(batch.wale_angle[e]), sine = std::sin(batch.wale_angle[e]);
    for (int p = 0; p < Points; ++p, ++k) {
      Point& point = chunk.point[k];
      point.set_reference(batch.pattern + 2 * Nodes * e, rule_.dN[p], rule_.weight[p]);
      point.rotate(cosine, sine);
      point.deform(batch.x + dofs * e);
      if (map) apply(map + 9 * (e * Points + p), point.a);
      // A folded pattern gets its status in respond(); the material sees an undeformed point instead of garbage.
      const bool valid = point.area > 0.0;
      chunk.C[k] = valid ? dot(point.a[0], point.a[0]) : 1.0;
      chunk.C[chunk.n + k] = valid ? dot(point.a[1], point.a[1]) : 1.0;
      chunk.C[2 * chunk.n + k] = valid ? dot(point.a[0], point.a[1]) : 0.0;
    }
  }
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::spread_params(const Batch& batch, int first, Chunk& chunk) {
  const int n_params = batch.response->n_params();
  chunk.params.resize(static_cast<std::size_t>(n_params) * chunk_points);
  for (int k = 0; k < chunk.n; ++k) {
    const double* values = batch.params + static_cast<std::ptrdiff_t>(first + k / Points) * n_params;
    for (int q = 0; q < n_params; ++q) chunk.params[q * chunk.n + k] = values[q];
  }
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::respond(const Batch& batch, int first, bool with_tangent, Chunk& chunk) {
  if (batch.graduated) spread_params(batch, first, chunk);
  batch.response->evaluate(chunk.n, chunk.C.data(), params_of(batch, chunk), batch.graduated ? 1 : 0, chunk.W.data(),
                           chunk.S.data(), with_tangent ? chunk.D.data() : nullptr, chunk.thickness_stretch.data(),
                           chunk.status.data());
  for (int k = 0; k < chunk.n; ++k) {
    if (!(chunk.point[k].area > 0.0)) chunk.status[k] = material::point_not_admissible;
  }
}

template <int Nodes, int Points>
double Membrane<Nodes, Points>::energy(const Chunk& chunk, int begin) {
  double sum = 0.0;
  for (int k = begin; k < begin + Points; ++k) sum += chunk.W[k] * chunk.point[k].area;
  return sum;
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::residual(const Chunk& chunk, int begin, double thickness, double* result) {
  double r[dofs] = {};
  for (int k = begin; k < begin + Points; ++k) {
    double S[3];
    pick(chunk, chunk.S, k, thickness * chunk.point[k].area, S);
    chunk.point[k].add_residual(S, r);
  }
  std::copy_n(r, dofs, result);
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::tangent(const Chunk& chunk, int begin, double thickness, double* result) {
  double K[dofs][dofs] = {};
  for (int k = begin; k < begin + Points; ++k) {
    const double scale = thickness * chunk.point[k].area;
    double S[3], D[6];
    pick(chunk, chunk.S, k, scale, S);
    pick(chunk, chunk.D, k, scale, D);
    chunk.point[k].add_tangent(S, D, K);
  }
  for (int r = 0; r < dofs; ++r) {
    for (int c = 0; c < dofs; ++c) result[r * dofs + c] = c / 3 >= r / 3 ? K[r][c] : K[c][r];
  }
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::evaluate(const Batch& batch, const Result& result) const {
  for (int first = 0; first < batch.n; first += chunk_elements) {
    const int count = std::min(chunk_elements, batch.n - first);
    const Chunk& chunk = fill(batch, first, count, result.tangent != nullptr);
    for (int k = 0; k < count; ++k) {
      const std::ptrdiff_t e = first + k;
      const int begin = k * Points;
      const auto* states = chunk.status.data() + begin;
      const std::uint8_t status = *std::max_element(states, states + Points);
      if (result.status) result.status[e] = status;
      if (status == material::point_not_admissible) {
        set_nan(result, e);
        continue;
      }
      if (result.energy) result.energy[e] = batch.thickness * energy(chunk, begin);
      if (result.residual) residual(chunk, begin, batch.thickness, result.residual + e * dofs);
      if (result.tangent) tangent(chunk, begin, batch.thickness, result.tangent + e * dofs * dofs);
    }
  }
}

template <int Nodes, int Points>
PointFields Membrane<Nodes, Points>::fields(const Batch& batch) const {
  const std::size_t total = static_cast<std::size_t>(batch.n) * Points;
  PointFields out;
  out.C.resize(3 * total);
  out.S.resize(3 * total);
  out.cauchy_principal.resize(2 * total);
  out.energy_density.resize(total);
  out.thickness_stretch.resize(total);
  out.status.resize(total);
  for (int first = 0; first < batch.n; first += chunk_elements) {
    const Chunk& chunk = fill(batch, first, std::min(chunk_elements, batch.n - first), false);
    for (int k = 0; k < chunk.n; ++k) {
      const std::size_t at = static_cast<std::size_t>(first) * Points + k;
      const double valid = chunk.status[k] == material::point_not_admissible ? nan : 1.0;
      double C[3], S[3];
      pick(chunk, chunk.C, k, 1.0, C);
      pick(chunk, chunk.S, k, valid, S);
      out.energy_density[at] = valid * chunk.W[k];
      out.thickness_stretch[at] = valid * chunk.thickness_stretch[k];
      out.status[at] = chunk.status[k];
      const auto principal = principal_cauchy(C, S, out.thickness_stretch[at]);
      std::copy_n(C, 3, &out.C[3 * at]);
      std::copy_n(S, 3, &out.S[3 * at]);
      std::copy_n(principal.data(), 2, &out.cauchy_principal[2 * at]);
    }
    if (batch.response->relaxes()) add_wrinkles(batch, chunk, out);
  }
  return out;
}

template <int Nodes, int Points>
PointTensions Membrane<Nodes, Points>::tensions(const Batch& batch, const double* map) const {
  PointTensions out;
  resize(static_cast<std::size_t>(batch.n) * Points, Nodes, out);
  for (const auto& values : rule_.N) out.shape.insert(out.shape.end(), values, values + Nodes);
  for (int first = 0; first < batch.n; first += chunk_elements) {
    const Chunk& chunk = fill(batch, first, std::min(chunk_elements, batch.n - first), false, map);
    for (int k = 0; k < chunk.n; ++k) {
      const Point& point = chunk.point[k];
      const double valid = chunk.status[k] == material::point_not_admissible ? nan : batch.thickness;
      const double* x = batch.x + dofs * static_cast<std::ptrdiff_t>(first + k / Points);
      double S[3];
      pick(chunk, chunk.S, k, valid, S);
      PointTension<Nodes> tension;
      tension.reference_area = point.area;
      for (int c = 0; c < 3; ++c) {
        tension.position[c] = 0.0;
        for (int i = 0; i < Nodes; ++i) tension.position[c] += rule_.N[k % Points][i] * x[3 * i + c];
        tension.stress[0][c] = S[0] * point.a[0][c] + S[2] * point.a[1][c];
        tension.stress[1][c] = S[2] * point.a[0][c] + S[1] * point.a[1][c];
      }
      for (int b = 0; b < 2; ++b) {
        std::copy_n(point.a[b], 3, tension.a[b]);
        for (int i = 0; i < Nodes; ++i) tension.g[b][i] = point.g[i][b];
      }
      write_tension(tension, static_cast<std::size_t>(first) * Points + k, out);
    }
  }
  return out;
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::add_wrinkles(const Batch& batch, const Chunk& chunk, PointFields& out) {
  std::array<material::WrinkleState, chunk_points> state;
  std::array<double, 2 * chunk_points> direction;
  batch.response->wrinkles(chunk.n, chunk.C.data(), params_of(batch, chunk), batch.graduated ? 1 : 0, state.data(),
                           direction.data());
  for (int k = 0; k < chunk.n; ++k) {
    out.wrinkle_state.push_back(state[k]);
    add_crest(chunk.point[k].a, direction[k], direction[chunk.n + k], out);
  }
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::nodal_areas(const Batch& batch, double* areas) const {
  for (std::ptrdiff_t e = 0; e < batch.n; ++e) {
    std::fill_n(areas + e * Nodes, Nodes, 0.0);
    for (int p = 0; p < Points; ++p) {
      Point point;
      point.set_reference(batch.pattern + 2 * Nodes * e, rule_.dN[p], rule_.weight[p]);
      point.deform(batch.x + dofs * e);
      const double area = point.area_stretch() * point.area;
      for (int i = 0; i < Nodes; ++i) areas[e * Nodes + i] += rule_.N[p][i] * area;
    }
  }
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::reference_areas(const Batch& batch, double* areas) const {
  for (std::ptrdiff_t e = 0; e < batch.n; ++e) {
    std::fill_n(areas + e * Nodes, Nodes, 0.0);
    for (int p = 0; p < Points; ++p) {
      Point point;
      point.set_reference(batch.pattern + 2 * Nodes * e, rule_.dN[p], rule_.weight[p]);
      for (int i = 0; i < Nodes; ++i) areas[e * Nodes + i] += rule_.N[p][i] * point.area;
    }
  }
}

template <int Nodes, int Points>
void Membrane<Nodes, Points>::gradient_products(const Batch& batch, double* products) const {
  std::fill_n(products, std::ptrdiff_t{batch.n} * Nodes * Nodes, 0.0);
  for (std::ptrdiff_t e = 0; e < batch.n; ++e, products += Nodes * Nodes)
    for (int p = 0; p < Points; ++p) {
      Point point;
      point.set_reference(batch.pattern + 2 * Nodes * e, rule_.dN[p], rule_.weight[p]);
      for (int i = 0; i < Nodes; ++i)
        for (int j = 0; j < Nodes; ++j)
          products[Nodes * i + j] += point.area * (point.g[i][0] * point.g[j][0] + point.g[i][1] * point.g[j][1]);
    }
}

}  // namespace toile::element
