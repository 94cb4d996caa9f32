#include "wrinkle_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::material {
namespace {

constexpr int most_evaluations = 200;
constexpr int most_starts = 25;
/// A Newton step below this part of q (or of 1) ends the search: it is added to first order.
constexpr double last_step = 1e-8;
constexpr double smallest_step = 1e-14;
/// Stresses below this part of D0 count as zero.
constexpr double zero_stress = 1e-12;

double dot(const Voigt& a, const Voigt& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Voigt times(const Tangent& D, const Voigt& e) {
  return {D[0] * e[0] + D[3] * e[1] + D[4] * e[2], D[3] * e[0] + D[1] * e[1] + D[5] * e[2],
          D[4] * e[0] + D[5] * e[1] + D[2] * e[2]};
}

/// n n^T and its change (n m^T + m n^T)/2 as n turns towards m = (-n2, n1), as strains.
Voigt along(const Direction& n) {
  return {n[0] * n[0], n[1] * n[1], 2.0 * n[0] * n[1]};
}
Voigt turning(const Direction& n) {
  return {-n[0] * n[1], n[0] * n[1], n[0] * n[0] - n[1] * n[1]};
}

/// n turned towards m by `angle`, up to its third power.
Direction turned(const Direction& n, double angle) {
  const double scale = 1.0 / std::sqrt(1.0 + angle * angle);
  return {scale * (n[0] - angle * n[1]), scale * (n[1] + angle * n[0])};
}

Voigt scaled(double factor, Voigt a) {
  for (double& value : a) value *= factor;
  return a;
}

/// L diag(d) L^T of the leading size x size block of H; a pivot that is not clearly positive is turned into one that
/// is, so that Newton's direction descends.
void factorise(int size, const std::array<Voigt, 3>& H, std::array<std::array<double, 3>, 3>& L, Voigt& d) {
  for (int j = 0; j < size; ++j) {
    d[j] = H[j][j];
    for (int k = 0; k < j; ++k) d[j] -= L[j][k] * L[j][k] * d[k];
    d[j] = std::max({std::abs(d[j]), 1e-10 * std::abs(H[j][j]), 1e-300});
    for (int i = j + 1; i < size; ++i) {
      L[i][j] = H[i][j];
      for (int k = 0; k < j; ++k) L[i][j] -= L[i][k] * L[j][k] * d[k];
      L[i][j] /= d[j];
    }
  }
}

}  // namespace

Minor minor_of(double t11, double t22, double t12) {
  const double half = 0.5 * (t11 - t22), radius = std::sqrt(half * half + t12 * t12);
  // Of the two rows of t - value I, the one without cancellation is orthogonal to the eigenvector.
  const Direction n = half > 0.0 ? Direction{-t12, half + radius} : Direction{radius - half, -t12};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1]);
  const double value = 0.5 * (t11 + t22) - radius;
  return {value, length > 0.0 ? Direction{n[0] / length, n[1] / length} : Direction{1.0, 0.0}};
}

void WrinkleSearch::start_rank_one(const Direction& n, double q, double bound) {
  start(Family::rank_one, scaled(0.5 * q, along(n)));
  energy_ = bound;
  trial_.n = n;
  trial_.q = q;
}

void WrinkleSearch::start(Family family, const Voigt& half_A) {
  family_ = family;
  first_ = true;
  done_ = false;
  received_ = 0;
  trial_.half = half_A;
  energy_ = std::numeric_limits<double>::infinity();
}

WrinkleSearch::Basis WrinkleSearch::basis() const {
  const Voigt& T = answer_.S;
  Basis b;
  std::array<Voigt, 3> H = {};
  if (family_ == Family::rank_one) {
    b.size = 2;
    b.column = {along(A_.n), turning(A_.n), {}};
    // Curvature of the path: A = q n n^T is not linear in n.
    H[1][0] = 2.0 * dot(T, b.column[1]) / A_.q;
    H[1][1] = (T[0] + T[1] - 2.0 * dot(T, b.column[0])) / A_.q;
  } else {
    constexpr std::array<Voigt, 3> unit = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    for (int a = 0; a < 3; ++a) {
      const bool is_free = family_ == Family::full || (a < 2 && (A_.half[a] > 0.0 || T[a] < 0.0));
      if (is_free) b.column[b.size++] = unit[a];
    }
  }
  for (int j = 0; j < b.size; ++j) {
    const Voigt Dc = times(answer_.D, b.column[j]);
    for (int i = j; i < b.size; ++i) H[i][j] += dot(b.column[i], Dc);
  }
  factorise(b.size, H, b.L, b.d);
  return b;
}

double WrinkleSearch::longest_step() const {
  if (family_ != Family::rank_one) return 1.0;
  const double shrinking = -2.0 * step_.length[0] / (0.8 * A_.q), turn = std::abs(step_.length[1]) / (0.5 * A_.q);
  return 1.0 / std::max({1.0, shrinking, turn});
}

WrinkleSearch::WrinkleStrain WrinkleSearch::moved(double part) const {
  WrinkleStrain result = A_;
  if (family_ == Family::rank_one) {
    result.q = std::max(A_.q + 2.0 * part * step_.length[0], 0.1 * A_.q);
    result.n = turned(A_.n, part * step_.length[1] / A_.q);
    result.half = scaled(0.5 * result.q, along(result.n));
    return result;
  }
  for (int k = 0; k < basis_.size; ++k)
    for (int a = 0; a < 3; ++a) result.half[a] += part * step_.length[k] * basis_.column[k][a];
  if (family_ == Family::axes)
    for (int a = 0; a < 2; ++a) result.half[a] = std::max(result.half[a], 0.0);
  return result;
}

void WrinkleSearch::plan() {
  const Voigt& T = answer_.S;
  basis_ = basis();
  const int n = basis_.size;
  double longest = 0.0;
  step_.slope = 0.0;
  std::array<double, 3> y = {};
  for (int i = 0; i < n; ++i) {
    y[i] = -dot(T, basis_.column[i]);
    for (int k = 0; k < i; ++k) y[i] -= basis_.L[i][k] * y[k];
    step_.slope -= y[i] * y[i] / basis_.d[i];
  }
  for (int i = n - 1; i >= 0; --i) {
    step_.length[i] = y[i] / basis_.d[i];
    for (int k = i + 1; k < n; ++k) step_.length[i] -= basis_.L[k][i] * step_.length[k];
    longest = std::max(longest, std::abs(step_.length[i]));
  }
  const double size = family_ == Family::rank_one ? A_.q : 1.0;
  if (longest <= last_step * size + smallest_step || received_ >= most_evaluations) return finish();
  step_.part = longest_step();
  trial_ = moved(step_.part);
}

void WrinkleSearch::receive(const Answer& answer) {
  ++received_;
  const double value = answer.W;
  const double rounding = 1e-14 * (natural_[0] + natural_[1] + std::abs(value));
  const double bound = first_ ? energy_ : energy_ + 1e-4 * step_.part * step_.slope;
  if (answer.status != point_not_admissible && value <= bound + rounding) {
    first_ = false;
    A_ = trial_;
    answer_ = answer;
    energy_ = value;
    return plan();
  }
  retreat();
}

void WrinkleSearch::retreat() {
  if (first_) {
    done_ = family_ != Family::rank_one || received_ >= most_starts;
    trial_.q *= 0.25;
    trial_.half = scaled(0.5 * trial_.q, along(trial_.n));
  } else {
    step_.part *= 0.5;
    done_ = step_.part < 1e-12 || received_ >= most_evaluations;
    trial_ = moved(step_.part);
  }
}

/// Adds the last step to first order (of its length to second order), if it is small enough.
void WrinkleSearch::finish() {
  done_ = true;
  if (received_ >= most_evaluations) return;
  const Voigt before = A_.half;
  A_ = moved(1.0);
  Voigt change;
  for (int a = 0; a < 3; ++a) change[a] = A_.half[a] - before[a];
  const Voigt dS = times(answer_.D, change);
  for (int a = 0; a < 3; ++a) answer_.S[a] += dS[a];
  basis_ = basis();
}

bool WrinkleSearch::is_minimum() const {
  const double zero = zero_stress * (natural_[0] + natural_[1]);
  if (family_ == Family::axes) return true;
  if (family_ == Family::full) return minor_of(2.0 * A_.half[0], 2.0 * A_.half[1], A_.half[2]).value >= 0.0;
  return answer_.S[0] + answer_.S[1] - dot(answer_.S, along(A_.n)) >= -zero;
}

Tangent WrinkleSearch::tangent() const {
  Tangent result = answer_.D;
  std::array<Voigt, 3> y;  // L^-1 B^T D
  for (int i = 0; i < basis_.size; ++i) {
    y[i] = times(answer_.D, basis_.column[i]);
    for (int k = 0; k < i; ++k)
      for (int a = 0; a < 3; ++a) y[i][a] -= basis_.L[i][k] * y[k][a];
  }
  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < basis_.size; ++i) result[k] -= y[i][pairs[k][0]] * y[i][pairs[k][1]] / basis_.d[i];
  return result;
}

WrinkleState WrinkleSearch::state() const {
  if (family_ == Family::rank_one) return WrinkleState::wrinkled;
  if (family_ == Family::full) return WrinkleState::slack;
  const int shortened = (A_.half[0] > 0.0 ? 1 : 0) + (A_.half[1] > 0.0 ? 1 : 0);
  return static_cast<WrinkleState>(shortened);
}

Direction WrinkleSearch::crest() const {
  if (state() != WrinkleState::wrinkled) return {0.0, 0.0};
  if (family_ == Family::rank_one) return {-A_.n[1], A_.n[0]};
  return A_.half[0] > 0.0 ? Direction{0.0, 1.0} : Direction{1.0, 0.0};
}

}  // namespace toile::material
