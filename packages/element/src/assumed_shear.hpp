#pragma once

#include "nodal_system.hpp"
#include "reference_point.hpp"
#include "vector.hpp"

namespace toile::element {

/// Where an element samples its transverse shear, and how the samples make up the assumed field.
///
/// The sample on the edge from node i to node j is factor (x_j - x_i).(d_i + d_j), minus the same of the reference: the
/// covariant shear strain at the middle of the edge, times the parent length of the edge. The covariant components
/// at a point are interpolation[point][r] . samples. Every node lies on two edges.
template <int Nodes, int Edges, int Points>
struct ShearSampling {
  int edge[Edges][2];
  double factor;
  double interpolation[Points][2][Edges];
};

/// Transverse shear energy 1/2 sum of k_a gamma_a^2 over the two material axes of an element with the assumed field of
/// its edge samples: a quadratic form of the samples whose matrix depends on the reference only.
template <int Nodes, int Edges, int Points>
class AssumedShear {
 public:
  using Sampling = ShearSampling<Nodes, Edges, Points>;

  /// `stiffness`: k_a along the two material axes, N/mm; G h0 unless the element softens it.
  void set_reference(const Sampling& sampling, const ShellNodes<Nodes>& nodes,
                     const ReferencePoint<Nodes> (&points)[Points], const double (&stiffness)[2]);
  void deform(const ShellNodes<Nodes>& nodes);
  double energy() const;
  void add_force(NodalSystem<Nodes>& system) const;
  void add_stiffness(NodalSystem<Nodes>& system) const;

 private:
  /// Edge m (0 or 1) of node i, and the derivative of its sample by (x_i, d_i).
  struct Incidence {
    int edge;
    double slope[6];
  };
  static double sample(const Sampling& sampling, int k, const double (&x)[Nodes][3], const double (&d)[Nodes][3]);
  void set_incidence(const ShellNodes<Nodes>& nodes);

  const Sampling* sampling_ = nullptr;
  double matrix_[Edges][Edges];
  double reference_[Edges];
  double strain_[Edges];
  double stress_[Edges];  ///< matrix times strain
  Incidence incidence_[Nodes][2];
};

template <int Nodes, int Edges, int Points>
double AssumedShear<Nodes, Edges, Points>::sample(const Sampling& sampling, int k, const double (&x)[Nodes][3],
                                                  const double (&d)[Nodes][3]) {
  const auto [i, j] = sampling.edge[k];
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) sum += (x[j][c] - x[i][c]) * (d[i][c] + d[j][c]);
  return sampling.factor * sum;
}

template <int Nodes, int Edges, int Points>
void AssumedShear<Nodes, Edges, Points>::set_reference(const Sampling& sampling, const ShellNodes<Nodes>& nodes,
                                                       const ReferencePoint<Nodes> (&points)[Points],
                                                       const double (&stiffness)[2]) {
  sampling_ = &sampling;
  for (int k = 0; k < Edges; ++k) reference_[k] = sample(sampling, k, nodes.X, nodes.D);
  std::fill_n(&matrix_[0][0], Edges * Edges, 0.0);
  for (int p = 0; p < Points; ++p) {
    const auto& [along_1, along_2] = sampling.interpolation[p];
    const auto& T = points[p].to_material;
    for (int a = 0; a < 2; ++a) {
      double row[Edges];
      for (int k = 0; k < Edges; ++k) row[k] = T[0][a] * along_1[k] + T[1][a] * along_2[k];
      for (int k = 0; k < Edges; ++k) {
        for (int m = 0; m < Edges; ++m) matrix_[k][m] += stiffness[a] * points[p].area * row[k] * row[m];
      }
    }
  }
}

template <int Nodes, int Edges, int Points>
void AssumedShear<Nodes, Edges, Points>::deform(const ShellNodes<Nodes>& nodes) {
  for (int k = 0; k < Edges; ++k) strain_[k] = sample(*sampling_, k, nodes.x, nodes.d) - reference_[k];
  for (int k = 0; k < Edges; ++k) {
    stress_[k] = 0.0;
    for (int m = 0; m < Edges; ++m) stress_[k] += matrix_[k][m] * strain_[m];
  }
  set_incidence(nodes);
}

template <int Nodes, int Edges, int Points>
void AssumedShear<Nodes, Edges, Points>::set_incidence(const ShellNodes<Nodes>& nodes) {
  int count[Nodes] = {};
  for (int k = 0; k < Edges; ++k) {
    const auto [i, j] = sampling_->edge[k];
    Incidence& start = incidence_[i][count[i]++];
    Incidence& end = incidence_[j][count[j]++];
    start.edge = end.edge = k;
    for (int c = 0; c < 3; ++c) {
      end.slope[c] = sampling_->factor * (nodes.d[i][c] + nodes.d[j][c]);
      start.slope[c] = -end.slope[c];
      start.slope[3 + c] = end.slope[3 + c] = sampling_->factor * (nodes.x[j][c] - nodes.x[i][c]);
    }
  }
}

template <int Nodes, int Edges, int Points>
double AssumedShear<Nodes, Edges, Points>::energy() const {
  double sum = 0.0;
  for (int k = 0; k < Edges; ++k) sum += 0.5 * stress_[k] * strain_[k];
  return sum;
}

template <int Nodes, int Edges, int Points>
void AssumedShear<Nodes, Edges, Points>::add_force(NodalSystem<Nodes>& system) const {
  for (int i = 0; i < Nodes; ++i) {
    for (const auto& [edge, slope] : incidence_[i]) {
      for (int c = 0; c < 6; ++c) system.force[i][c] += stress_[edge] * slope[c];
    }
  }
}

template <int Nodes, int Edges, int Points>
void AssumedShear<Nodes, Edges, Points>::add_stiffness(NodalSystem<Nodes>& system) const {
  for (int j = 0; j < Nodes; ++j) {
    double response[Edges][6];  // of the stress in each edge to the unknowns of node j
    for (int k = 0; k < Edges; ++k) {
      for (int c = 0; c < 6; ++c) {
        response[k][c] = matrix_[k][incidence_[j][0].edge] * incidence_[j][0].slope[c] +
                         matrix_[k][incidence_[j][1].edge] * incidence_[j][1].slope[c];
      }
    }
    for (int i = 0; i <= j; ++i) {
      for (const auto& [edge, slope] : incidence_[i]) system.add_outer(i, slope, j, response[edge]);
    }
  }
  for (int k = 0; k < Edges; ++k) {
    const double value = sampling_->factor * stress_[k];
    const int start = sampling_->edge[k][0], end = sampling_->edge[k][1];
    for (const int other : {start, end}) {
      system.add_identity(end, position_vector, other, director_vector, value);
      system.add_identity(other, director_vector, end, position_vector, value);
      system.add_identity(start, position_vector, other, director_vector, -value);
      system.add_identity(other, director_vector, start, position_vector, -value);
    }
  }
}

}  // namespace toile::element
