#include "rules.hpp"

#include <cmath>

namespace toile::element {
namespace {

constexpr double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

template <int Points>
void set_bilinear(int p, double xi, double eta, double weight, Rule<4, Points>& rule) {
  rule.weight[p] = weight;
  for (int i = 0; i < 4; ++i) {
    const double along_xi = 1.0 + corner[i][0] * xi, along_eta = 1.0 + corner[i][1] * eta;
    rule.N[p][i] = 0.25 * along_xi * along_eta;
    rule.dN[p][i][0] = 0.25 * corner[i][0] * along_eta;
    rule.dN[p][i][1] = 0.25 * corner[i][1] * along_xi;
  }
}

template <int Points>
void set_linear(int p, double r, double s, double weight, Rule<3, Points>& rule) {
  constexpr double slope[3][2] = {{-1.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}};
  const double N[3] = {1.0 - r - s, r, s};
  rule.weight[p] = weight;
  for (int i = 0; i < 3; ++i) {
    rule.N[p][i] = N[i];
    for (int axis = 0; axis < 2; ++axis) rule.dN[p][i][axis] = slope[i][axis];
  }
}

}  // namespace

double bilinear_place(int point, int axis) {
  return corner[point][axis] / std::sqrt(3.0);
}

double linear_place(int point, int axis) {
  return point == axis + 1 ? 2.0 / 3.0 : 1.0 / 6.0;
}

Rule<4, 4> bilinear() {
  Rule<4, 4> rule;
  for (int p = 0; p < 4; ++p) set_bilinear(p, bilinear_place(p, 0), bilinear_place(p, 1), 1.0, rule);
  return rule;
}

Rule<4, 1> bilinear_centre() {
  Rule<4, 1> rule;
  set_bilinear(0, 0.0, 0.0, 4.0, rule);
  return rule;
}

Rule<3, 1> linear() {
  Rule<3, 1> rule;
  set_linear(0, 1.0 / 3.0, 1.0 / 3.0, 0.5, rule);
  return rule;
}

Rule<3, 3> linear_three_points() {
  Rule<3, 3> rule;
  for (int p = 0; p < 3; ++p) set_linear(p, linear_place(p, 0), linear_place(p, 1), 1.0 / 6.0, rule);
  return rule;
}

}  // namespace toile::element
