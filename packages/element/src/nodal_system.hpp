#pragma once

#include <algorithm>

#include "director.hpp"
#include "vector.hpp"

namespace toile::element {

/// Unknown vectors of a node before directors are expressed by rotations: 0 its position, 1 its director.
enum NodeVector { position_vector = 0, director_vector = 1 };

/// First and second derivative of an element's energy with respect to (x_I, d_I), and their condensation to the 5
/// unknowns a node. Only blocks (i, j) with j >= i of the stiffness are stored.
template <int Nodes>
class NodalSystem {
 public:
  using Block = double[6][6];
  double force[Nodes][6] = {};

  /// Before the first addition to the stiffness.
  void clear_stiffness() { std::fill_n(&stiffness_[0][0][0], 36 * pairs, 0.0); }
  /// Block (i, j) of the stiffness with j >= i.
  Block& block(int i, int j) { return stiffness_[pair(i, j)]; }

  /// Adds value times the identity for vector `row` of node i and vector `column` of node j; an entry below the stored
  /// blocks is dropped, its mirror image must be added too.
  void add_identity(int i, NodeVector row, int j, NodeVector column, double value) {
    if (j < i) return;
    for (int c = 0; c < 3; ++c) block(i, j)[3 * row + c][3 * column + c] += value;
  }
  /// Adds u_i v_j^T to block (i, j) with j >= i.
  void add_outer(int i, const double (&u)[6], int j, const double (&v)[6]) {
    Block& K = block(i, j);
    for (int r = 0; r < 6; ++r) {
      for (int c = 0; c < 6; ++c) K[r][c] += u[r] * v[c];
    }
  }

  /// Gradient [Nodes][5] with respect to positions and rotations.
  void condense_force(const Director (&directors)[Nodes], double* residual) const;
  /// Hessian [5 Nodes][5 Nodes].
  void condense_stiffness(const Director (&directors)[Nodes], double* tangent) const;

 private:
  static constexpr int pairs = Nodes * (Nodes + 1) / 2;
  static constexpr int pair(int i, int j) { return i * Nodes - i * (i + 1) / 2 + j; }
  void condense_block(int i, int j, const Director (&directors)[Nodes], double (&K)[5][5]) const;

  double stiffness_[pairs][6][6];
};

template <int Nodes>
void NodalSystem<Nodes>::condense_force(const Director (&directors)[Nodes], double* residual) const {
  for (int i = 0; i < Nodes; ++i) {
    double moment[3];
    std::copy_n(force[i], 3, residual + 5 * i);
    std::copy_n(force[i] + 3, 3, moment);
    for (int a = 0; a < 2; ++a) residual[5 * i + 3 + a] = dot(moment, directors[i].first[a]);
  }
}

template <int Nodes>
void NodalSystem<Nodes>::condense_block(int i, int j, const Director (&directors)[Nodes], double (&K)[5][5]) const {
  double columns[6][5];
  for (int r = 0; r < 6; ++r) {
    const auto& row = stiffness_[pair(i, j)][r];
    for (int c = 0; c < 3; ++c) columns[r][c] = row[c];
    for (int b = 0; b < 2; ++b) {
      const auto& first = directors[j].first[b];
      columns[r][3 + b] = row[3] * first[0] + row[4] * first[1] + row[5] * first[2];
    }
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 5; ++c) K[r][c] = columns[r][c];
  }
  for (int a = 0; a < 2; ++a) {
    const auto& first = directors[i].first[a];
    for (int c = 0; c < 5; ++c) {
      K[3 + a][c] = first[0] * columns[3][c] + first[1] * columns[4][c] + first[2] * columns[5][c];
    }
  }
}

template <int Nodes>
void NodalSystem<Nodes>::condense_stiffness(const Director (&directors)[Nodes], double* tangent) const {
  constexpr int size = 5 * Nodes;
  for (int i = 0; i < Nodes; ++i) {
    for (int j = i; j < Nodes; ++j) {
      double K[5][5];
      condense_block(i, j, directors, K);
      if (i == j) {
        double moment[3];
        std::copy_n(force[i] + 3, 3, moment);
        const auto& second = directors[i].second;
        K[3][3] += dot(moment, second[0]);
        K[4][4] += dot(moment, second[1]);
        K[3][4] += dot(moment, second[2]);
      }
      for (int r = 0; r < 5; ++r) {
        for (int c = i == j ? r : 0; c < 5; ++c) {
          tangent[(5 * i + r) * size + 5 * j + c] = K[r][c];
          tangent[(5 * j + c) * size + 5 * i + r] = K[r][c];
        }
      }
    }
  }
}

}  // namespace toile::element
