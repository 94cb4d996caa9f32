#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "assumed_shear.hpp"
#include "hourglass.hpp"
#include "layers.hpp"
#include "point_response.hpp"
#include "point_tension.hpp"
#include "principal_stress.hpp"
#include "shell_state.hpp"
#include "soft_shear.hpp"
#include "toile/element/element.hpp"

namespace toile::element {

/// What distinguishes one Reissner-Mindlin shell element from another.
template <int Nodes, int Edges, int Points, int ShearPoints>
struct ShellFormulation {
  Rule<Nodes, Points> rule;             ///< of membrane and bending
  Rule<Nodes, ShearPoints> shear_rule;  ///< of transverse shear, of nodal areas and of the stabilisation
  ShearSampling<Nodes, Edges, ShearPoints> shear;
};

/// Shell with 5 unknowns a node: its position and two rotations of its director since the start of the step.
///
/// Energy = sum over in-plane points and layers of h0 w W(C(z)) dA (see ShellPoint), + linear elastic transverse shear
/// with an assumed field (see AssumedShear), + the energy of `Control` (Hourglass, SoftShear or NoStabilisation).
/// Derivatives are taken by the positions and directors of the nodes, then condensed to rotations (see NodalSystem);
/// the tangent is the exact Hessian at any rotation.
///
/// Frozen values: the thickness stretch at each in-plane point, then those of the control.
///
/// Thread-safe: a batch is worked off in chunks through buffers of the calling thread.
template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
class Shell final : public Element {
 public:
  using Formulation = ShellFormulation<Nodes, Edges, Points, ShearPoints>;

  Shell(const char* name, const char* text, const Formulation& formulation)
      : name_(name), text_(text), formulation_(formulation) {}

  const char* name() const override { return name_; }
  const char* text() const override { return text_; }
  int nodes() const override { return Nodes; }
  int dofs_per_node() const override { return 5; }
  int points() const override { return Points; }
  int frozen_values() const override { return Points + Control::frozen_values; }

  void evaluate(const Batch& batch, const Result& result) const override;
  void freeze(const Batch& batch, double* frozen) const override;
  PointFields fields(const Batch& batch) const override;
  PointTensions tensions(const Batch& batch, const double* map) const override;
  bool stabilised() const override { return has_control; }
  void stabilisation_energy(const Batch& batch, double* energy) const override;
  void nodal_areas(const Batch& batch, double* areas) const override;
  void reference_areas(const Batch& batch, double* areas) const override;
  void gradient_products(const Batch& batch, double* products) const override;

 private:
  static constexpr int dofs = 5 * Nodes;
  static constexpr int largest_chunk = 64;
  static constexpr int chunk_points = 768;
  static constexpr bool has_control = Control::has_energy;
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  using State = ShellState<Nodes, Points, ShearPoints>;

  struct Chunk {
    Layers layers;
    double half_thickness;
    std::array<State, largest_chunk> state;
    PointResponse response;  ///< [elements][Points][layers]

    int per_element() const { return Points * layers.n; }
    double height(int layer) const { return half_thickness * layers.place[layer]; }
  };

  static int chunk_size(const Layers& layers) { return std::min(largest_chunk, chunk_points / (Points * layers.n)); }
  /// The chunk of the calling thread, filled with the elements [first, first + count). `frozen`: of the whole batch;
  /// null: undeformed thickness. `map`: as in tensions().
  const Chunk& fill(const Batch& batch, const Layers& layers, const double* frozen, int first, int count,
                    bool with_tangent, const double* map = nullptr) const;
  /// Worst status of the element's layers.
  static std::uint8_t status(const Chunk& chunk, int k);
  void evaluate_element(const Batch& batch, const Chunk& chunk, int k, std::ptrdiff_t e, const Result& result) const;
  static double add_points(const Chunk& chunk, int k, double thickness, bool with_tangent, NodalSystem<Nodes>& system);
  static void freeze_element(const Chunk& chunk, const PointResponse& natural, int k, double* frozen);
  /// Fields of the in-plane point k of the chunk: of its middle layer, with the worst status of its layers.
  static void write_point(const Chunk& chunk, int k, std::size_t at, PointFields& out);
  /// Tension of the in-plane point k of the chunk: the sum over its layers.
  void write_resultant(const Chunk& chunk, int k, double thickness, std::size_t at, PointTensions& out) const;
  /// Appends the wrinkles at the middle layer of the chunk's `count` elements from `first` on.
  static void add_wrinkles(const Batch& batch, const Chunk& chunk, int first, int count, PointFields& out);
  static void set_nan(const Result& result, std::ptrdiff_t e);

  const char* name_;
  const char* text_;
  Formulation formulation_;
};

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
auto Shell<Nodes, Edges, Points, ShearPoints, Control>::fill(const Batch& batch, const Layers& layers,
                                                             const double* frozen, int first, int count,
                                                             bool with_tangent, const double* map) const
    -> const Chunk& {
  thread_local Chunk chunk;
  chunk.layers = layers;
  chunk.half_thickness = 0.5 * batch.thickness;
  chunk.response.resize(count * chunk.per_element());
  int at = 0;
  for (int k = 0; k < count; ++k) {
    const std::ptrdiff_t e = first + k;
    State& state = chunk.state[k];
    state.set_reference(batch, e, formulation_.rule, formulation_.shear_rule);
    state.nodes.set_positions(batch, e);
    state.nodes.set_directors(batch, e);
    for (int p = 0; p < Points; ++p) {
      state.point[p].deform(state.nodes, frozen ? frozen[e * frozen_values() + p] : 1.0);
      if (map) apply(map + 9 * (e * Points + p), state.point[p].a);
      for (int layer = 0; layer < layers.n; ++layer, ++at) {
        double C[3] = {1.0, 1.0, 0.0};  // of a folded element; status() names it
        if (!state.folded) state.point[p].deformation(chunk.height(layer), C);
        chunk.response.set_C(at, C);
      }
    }
  }
  chunk.response.evaluate(batch, first, chunk.per_element(), with_tangent);
  return chunk;
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
std::uint8_t Shell<Nodes, Edges, Points, ShearPoints, Control>::status(const Chunk& chunk, int k) {
  if (chunk.state[k].folded) return material::point_not_admissible;
  const auto* states = chunk.response.status.data() + k * chunk.per_element();
  return *std::max_element(states, states + chunk.per_element());
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
double Shell<Nodes, Edges, Points, ShearPoints, Control>::add_points(const Chunk& chunk, int k, double thickness,
                                                                     bool with_tangent, NodalSystem<Nodes>& system) {
  const PointResponse& response = chunk.response;
  double energy = 0.0;
  int at = k * chunk.per_element();
  for (const ShellPoint<Nodes>& point : chunk.state[k].point) {
    Resultants resultants;
    if (with_tangent) resultants.clear_stiffness();
    for (int layer = 0; layer < chunk.layers.n; ++layer, ++at) {
      const double scale = thickness * chunk.layers.weight[layer] * point.reference.area, z = chunk.height(layer);
      double p[2][3], S[3], D[6];
      point.base(z, p);
      response.pick(response.S, at, scale, S);
      energy += scale * response.W[at];
      resultants.add_force(z, p, S);
      if (!with_tangent) continue;
      response.pick(response.D, at, scale, D);
      resultants.add_stiffness(z, p, S, D);
    }
    resultants.refer_to_directors(point, with_tangent);
    resultants.spread_force(point, system);
    if (with_tangent) resultants.spread_stiffness(point, system);
  }
  return energy;
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::evaluate_element(const Batch& batch, const Chunk& chunk, int k,
                                                                         std::ptrdiff_t e, const Result& result) const {
  const State& state = chunk.state[k];
  const bool with_tangent = result.tangent != nullptr;
  NodalSystem<Nodes> system;
  if (with_tangent) system.clear_stiffness();
  double energy = add_points(chunk, k, batch.thickness, with_tangent, system);

  const auto add = [&](const auto& part) {
    energy += part.energy();
    part.add_force(system);
    if (with_tangent) part.add_stiffness(system);
  };
  AssumedShear<Nodes, Edges, ShearPoints> shear;
  [[maybe_unused]] const double* frozen = batch.frozen + e * frozen_values() + Points;
  double stiffness[2] = {batch.shear_modulus * batch.thickness, batch.shear_modulus * batch.thickness};
  if constexpr (Control::softens_shear) Control::soften(state.nodes.X, batch.thickness, frozen, stiffness);
  shear.set_reference(formulation_.shear, state.nodes, state.shear_point, stiffness);
  shear.deform(state.nodes);
  add(shear);
  if constexpr (has_control) {
    Control control;
    control.set_reference(state.nodes, state.shear_point, state.point[0], batch.thickness, frozen);
    control.deform(state.nodes, state.point[0]);
    add(control);
  }
  if (result.energy) result.energy[e] = energy;
  if (result.residual) system.condense_force(state.nodes.director, result.residual + e * dofs);
  if (with_tangent) system.condense_stiffness(state.nodes.director, result.tangent + e * dofs * dofs);
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::set_nan(const Result& result, std::ptrdiff_t e) {
  if (result.energy) result.energy[e] = nan;
  if (result.residual) std::fill_n(result.residual + e * dofs, dofs, nan);
  if (result.tangent) std::fill_n(result.tangent + e * dofs * dofs, dofs * dofs, nan);
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::evaluate(const Batch& batch, const Result& result) const {
  assert(batch.n == 0 || (batch.frames && batch.frozen));
  const Layers layers = gauss_layers(batch.layers);
  for (int first = 0, count = 0; first < batch.n; first += count) {
    count = std::min(chunk_size(layers), batch.n - first);
    const Chunk& chunk = fill(batch, layers, batch.frozen, first, count, result.tangent != nullptr);
    for (int k = 0; k < count; ++k) {
      const std::ptrdiff_t e = first + k;
      const std::uint8_t state = status(chunk, k);
      if (result.status) result.status[e] = state;
      if (state == material::point_not_admissible) {
        set_nan(result, e);
      } else {
        evaluate_element(batch, chunk, k, e, result);
      }
    }
  }
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::freeze(const Batch& batch, double* frozen) const {
  const Layers middle = gauss_layers(1);
  PointResponse natural;
  for (int first = 0, count = 0; first < batch.n; first += count) {
    count = std::min(chunk_size(middle), batch.n - first);
    const Chunk& chunk = fill(batch, middle, nullptr, first, count, has_control);
    if constexpr (Control::frozen_values > 0) {
      natural.resize(count);
      for (int k = 0; k < count; ++k) natural.set_C(k, {1.0, 1.0, 0.0});
      natural.evaluate(batch, first, 1, true);
    }
    for (int k = 0; k < count; ++k) {
      freeze_element(chunk, natural, k, frozen + static_cast<std::ptrdiff_t>(first + k) * frozen_values());
    }
  }
}

// An element that the material does not admit keeps the undeformed values; evaluate() names it.
template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::freeze_element(const Chunk& chunk, const PointResponse& natural,
                                                                       int k, double* frozen) {
  const PointResponse& response = chunk.response;
  const bool admissible = status(chunk, k) != material::point_not_admissible;
  for (int p = 0; p < Points; ++p) frozen[p] = admissible ? response.thickness_stretch[k * Points + p] : 1.0;
  [[maybe_unused]] double at_rest[6];
  if constexpr (Control::frozen_values > 0) natural.pick(natural.D, k, 1.0, at_rest);
  if constexpr (Control::softens_shear) Control::freeze(at_rest, frozen + Points);
  if constexpr (has_control) {
    double S[3] = {}, D[6];
    std::copy_n(at_rest, 6, D);
    if (admissible) {
      response.pick(response.S, k, 1.0, S);
      response.pick(response.D, k, 1.0, D);
    }
    Control::freeze(S, D, at_rest, frozen + Points);
  }
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
PointFields Shell<Nodes, Edges, Points, ShearPoints, Control>::fields(const Batch& batch) const {
  const std::size_t total = static_cast<std::size_t>(batch.n) * Points;
  const Layers layers = gauss_layers(batch.layers);
  PointFields out;
  out.C.resize(3 * total);
  out.S.resize(3 * total);
  out.cauchy_principal.resize(2 * total);
  out.energy_density.resize(total);
  out.thickness_stretch.resize(total);
  out.status.resize(total);
  for (int first = 0, count = 0; first < batch.n; first += count) {
    count = std::min(chunk_size(layers), batch.n - first);
    const Chunk& chunk = fill(batch, layers, batch.frozen, first, count, false);
    for (int k = 0; k < count * Points; ++k) {
      write_point(chunk, k, static_cast<std::size_t>(first) * Points + k, out);
    }
    if (batch.response->relaxes()) add_wrinkles(batch, chunk, first, count, out);
  }
  return out;
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::write_point(const Chunk& chunk, int k, std::size_t at,
                                                                    PointFields& out) {
  const PointResponse& response = chunk.response;
  const int layers = chunk.layers.n, middle = k * layers + layers / 2;
  const auto* states = response.status.data() + k * layers;
  const bool folded = chunk.state[k / Points].folded;
  out.status[at] = folded ? std::uint8_t{material::point_not_admissible} : *std::max_element(states, states + layers);
  const double valid = out.status[at] == material::point_not_admissible ? nan : 1.0;
  double C[3], S[3];
  response.pick(response.C, middle, 1.0, C);
  response.pick(response.S, middle, valid, S);
  out.energy_density[at] = valid * response.W[middle];
  out.thickness_stretch[at] = valid * response.thickness_stretch[middle];
  const auto principal = principal_cauchy(C, S, out.thickness_stretch[at]);
  std::copy_n(C, 3, &out.C[3 * at]);
  std::copy_n(S, 3, &out.S[3 * at]);
  std::copy_n(principal.data(), 2, &out.cauchy_principal[2 * at]);
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
PointTensions Shell<Nodes, Edges, Points, ShearPoints, Control>::tensions(const Batch& batch, const double* map) const {
  const Layers layers = gauss_layers(batch.layers);
  PointTensions out;
  resize(static_cast<std::size_t>(batch.n) * Points, Nodes, out);
  for (const auto& values : formulation_.rule.N) out.shape.insert(out.shape.end(), values, values + Nodes);
  for (int first = 0, count = 0; first < batch.n; first += count) {
    count = std::min(chunk_size(layers), batch.n - first);
    const Chunk& chunk = fill(batch, layers, batch.frozen, first, count, false, map);
    for (int k = 0; k < count * Points; ++k)
      write_resultant(chunk, k, batch.thickness, static_cast<std::size_t>(first) * Points + k, out);
  }
  return out;
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::write_resultant(const Chunk& chunk, int k, double thickness,
                                                                        std::size_t at, PointTensions& out) const {
  const State& state = chunk.state[k / Points];
  const ShellPoint<Nodes>& point = state.point[k % Points];
  const bool admissible = status(chunk, k / Points) != material::point_not_admissible;
  PointTension<Nodes> tension;
  std::copy_n(&point.a[0][0], 6, &tension.a[0][0]);
  std::copy_n(&point.reference.g[0][0], 2 * Nodes, &tension.g[0][0]);
  combine(formulation_.rule.N[k % Points], state.nodes.x, tension.position);
  tension.reference_area = point.reference.area;
  Resultants resultants;
  for (int layer = 0; layer < chunk.layers.n; ++layer) {
    const double z = chunk.height(layer), weight = admissible ? thickness * chunk.layers.weight[layer] : nan;
    double p[2][3], S[3];
    point.base(z, p);
    chunk.response.pick(chunk.response.S, k * chunk.layers.n + layer, weight, S);
    resultants.add_force(z, p, S);
  }
  std::copy_n(&resultants.force[0][0][0], 6, &tension.stress[0][0]);
  write_tension(tension, at, out);
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::add_wrinkles(const Batch& batch, const Chunk& chunk, int first,
                                                                     int count, PointFields& out) {
  PointResponse middle;
  middle.resize(count * Points);
  for (int k = 0; k < middle.n; ++k) {
    double C[3];
    chunk.response.pick(chunk.response.C, k * chunk.layers.n + chunk.layers.n / 2, 1.0, C);
    middle.set_C(k, C);
  }
  std::vector<material::WrinkleState> state;
  std::vector<double> direction;
  middle.wrinkles(batch, first, Points, state, direction);
  for (int k = 0; k < middle.n; ++k) {
    out.wrinkle_state.push_back(state[k]);
    add_crest(chunk.state[k / Points].point[k % Points].a, direction[k], direction[middle.n + k], out);
  }
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::stabilisation_energy(const Batch& batch, double* energy) const {
  if constexpr (has_control) {
    for (std::ptrdiff_t e = 0; e < batch.n; ++e) {
      State state;
      state.set_reference(batch, e, formulation_.rule, formulation_.shear_rule);
      state.nodes.set_positions(batch, e);
      state.nodes.set_directors(batch, e);
      state.point[0].deform(state.nodes, batch.frozen[e * frozen_values()]);
      Control control;
      control.set_reference(state.nodes, state.shear_point, state.point[0], batch.thickness,
                            batch.frozen + e * frozen_values() + Points);
      control.deform(state.nodes, state.point[0]);
      energy[e] = control.energy();
    }
  }
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::nodal_areas(const Batch& batch, double* areas) const {
  for (std::ptrdiff_t e = 0; e < batch.n; ++e) {
    State state;
    state.set_reference(batch, e, formulation_.rule, formulation_.shear_rule);
    state.nodes.set_positions(batch, e);
    std::fill_n(areas + e * Nodes, Nodes, 0.0);
    for (int p = 0; p < ShearPoints; ++p) {
      double a[2][3], normal[3];
      for (int b = 0; b < 2; ++b) combine(state.shear_point[p].g[b], state.nodes.x, a[b]);
      cross(a[0], a[1], normal);
      const double area = std::sqrt(dot(normal, normal)) * state.shear_point[p].area;
      for (int i = 0; i < Nodes; ++i) areas[e * Nodes + i] += formulation_.shear_rule.N[p][i] * area;
    }
  }
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::gradient_products(const Batch& batch, double* products) const {
  std::fill_n(products, std::ptrdiff_t{batch.n} * Nodes * Nodes, 0.0);
  for (std::ptrdiff_t e = 0; e < batch.n; ++e, products += Nodes * Nodes) {
    State state;
    state.set_reference(batch, e, formulation_.rule, formulation_.shear_rule);
    for (const ReferencePoint<Nodes>& point : state.shear_point)
      for (int i = 0; i < Nodes; ++i)
        for (int j = 0; j < Nodes; ++j)
          products[Nodes * i + j] += point.area * (point.g[0][i] * point.g[0][j] + point.g[1][i] * point.g[1][j]);
  }
}

template <int Nodes, int Edges, int Points, int ShearPoints, class Control>
void Shell<Nodes, Edges, Points, ShearPoints, Control>::reference_areas(const Batch& batch, double* areas) const {
  for (std::ptrdiff_t e = 0; e < batch.n; ++e) {
    State state;
    state.set_reference(batch, e, formulation_.rule, formulation_.shear_rule);
    std::fill_n(areas + e * Nodes, Nodes, 0.0);
    for (int p = 0; p < ShearPoints; ++p) {
      const double area = state.shear_point[p].area;
      for (int i = 0; i < Nodes; ++i) areas[e * Nodes + i] += formulation_.shear_rule.N[p][i] * area;
    }
  }
}

}  // namespace toile::element
