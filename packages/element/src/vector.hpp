#pragma once

namespace toile::element {

inline double dot(const double (&u)[3], const double (&v)[3]) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

inline void cross(const double (&u)[3], const double (&v)[3], double (&out)[3]) {
  out[0] = u[1] * v[2] - u[2] * v[1];
  out[1] = u[2] * v[0] - u[0] * v[2];
  out[2] = u[0] * v[1] - u[1] * v[0];
}

/// out = sum_i weight_i v_i.
template <int Nodes, int Size>
void combine(const double (&weight)[Nodes], const double (&v)[Nodes][Size], double (&out)[Size]) {
  double sum[Size] = {};
  for (int i = 0; i < Nodes; ++i) {
    for (int c = 0; c < Size; ++c) sum[c] += weight[i] * v[i][c];
  }
  for (int c = 0; c < Size; ++c) out[c] = sum[c];
}

}  // namespace toile::element
