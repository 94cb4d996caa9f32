#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string_view>

#include "toile/material/differentiate.hpp"
#include "toile/material/material.hpp"

/// What the author of a material includes. A material is a struct `Law` with
///   static constexpr const char *name, *text;
///   static constexpr std::array<ParamInfo, n> info;          every parameter: name, unit, text, default, range
///   template <class T, class P> static T energy(const PlaneC<T>& c, const Params<P>& p);
/// and, if wanted, `static constexpr std::array<ParamSet, m> sets`, `static int check(const double*, char*, int)` and
///   template <class T, class P> static T thickness_stretch(const PlaneC<T>& c, const Params<P>& p);   h/h0, if the
/// material is not incompressible.
/// `energy` is written once, without `if` on a T (use where()) and with power(), log(), exp(), sqrt(), reciprocal(),
/// sin(), cos() of variables (not of expressions); keep intermediate results in variables of type T or P, never in
/// `auto`. make_law<Law>() is then the LawV1: W, S and dS/dp come from Sacado's Fad, D
/// from SecondOrder, over `lanes` points at once.
namespace toile::material {

/// Right Cauchy-Green tensor in the material frame, its thickness entry eliminated by det C = 1:
/// C33 = 1 / (C11 C22 - C12^2) (doc/theory.md, "Incompressible plane stress"). A compressible law does not use C33 and
/// cof.
template <class T>
struct PlaneC {
  T C11, C22, C12;
  T det;  ///< C11 C22 - C12^2: of the in-plane part
  T C33;

  PlaneC(const T& c11, const T& c22, const T& c12) : PlaneC(c11, c22, c12, c11 * c22 - c12 * c12) {}
  /// `determinant`: c11 c22 - c12^2, for one who knows its derivatives.
  PlaneC(const T& c11, const T& c22, const T& c12, const T& determinant)
      : C11(c11), C22(c22), C12(c12), det(determinant), C33(reciprocal(det)) {}

  /// Entries of cof C = C^-1 (det C = 1).
  T cof11() const { return C22 * C33; }
  T cof22() const { return C11 * C33; }
  T cof33() const { return det; }
  T cof12() const { return -C12 * C33; }

  /// Tells that the law is continued at this point, outside its calibrated range.
  void extrapolated_where(const mask_type<base_type<T>>& condition) const { extrapolated = extrapolated | condition; }
  mutable mask_type<base_type<T>> extrapolated = {};
};

/// Parameters of one evaluation, by their index in Law::info.
template <class P>
class Params {
 public:
  /// values [n_params]; first [n_params] with stride `stride`: numbers of the first point, for choices.
  Params(const P* values, const double* first, int stride = 1) : values_(values), first_(first), stride_(stride) {}
  const P& operator[](int index) const { return values_[index]; }
  /// A parameter that is one of a few words: the word's index. The same for all points of a batch, so `if` is allowed.
  int choice(int index) const { return static_cast<int>(first_[index * stride_]); }

 private:
  const P* values_;
  const double* first_;
  int stride_;
};

inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// Default of a parameter that must be given.
inline constexpr double no_default = std::numeric_limits<double>::quiet_NaN();
/// Smallest principal stretch (in the plane and through the thickness) at which an energy is evaluated.
inline constexpr double stretch_floor = 0.05;

namespace detail {

using Gradient = Fad<Lane, 3>;
using Hessian = SecondOrder<Lane>;

/// Points first..first+count-1 of a batch in lanes; unused lanes repeat the last point, lanes that are not admissible
/// hold the natural state.
struct Block {
  int first, count;
  std::array<Lane, 3> C;
  LaneMask admissible;
};

inline Block load(int n, int first, const double* C) {
  Block block{first, std::min(lanes, n - first), {}, {}};
  for (int a = 0; a < 3; ++a) block.C[a] = Lane::load(C + static_cast<long>(a) * n + first, block.count);
  const auto& [c11, c22, c12] = block.C;
  const double floor = stretch_floor * stretch_floor;
  const Lane det = c11 * c22 - c12 * c12;
  // Both eigenvalues of the in-plane C are at least `floor`: its shifted trace and determinant are not negative.
  block.admissible = less(0.0, det) & less_equal(floor, c11) & less_equal(floor, c22) &
                     less_equal(0.0, (c11 - floor) * (c22 - floor) - c12 * c12) & less_equal(det * floor, 1.0);
  block.C = {where(block.admissible, c11, 1.0), where(block.admissible, c22, 1.0), where(block.admissible, c12, 0.0)};
  return block;
}

template <std::size_t N>
void load_params(int n, const Block& block, const double* params, std::array<Lane, N>& values) {
  for (std::size_t k = 0; k < N; ++k)
    values[k] = Lane::load(params + static_cast<long>(k) * n + block.first, block.count);
}

/// out[first + i] = value of lane i, NaN where the point is not admissible.
inline void store(const Block& block, Lane value, double* out) {
  where(block.admissible, value, std::numeric_limits<double>::quiet_NaN()).store(out + block.first, block.count);
}

/// C as the variables of differentiation. The determinant gets its derivatives from their closed form: by the product
/// rule they cost more than all the rest of a short energy, mostly multiplications by zero.
template <class T>
PlaneC<T> seeded(const std::array<Lane, 3>& C) {
  const Lane det = C[0] * C[1] - C[2] * C[2];
  const std::array<Lane, 3> slope = {C[1], C[0], -2.0 * C[2]};
  if constexpr (std::is_same_v<T, Hessian>) {
    return {{C[0], {1.0, 0.0, 0.0}, {}},
            {C[1], {0.0, 1.0, 0.0}, {}},
            {C[2], {0.0, 0.0, 1.0}, {}},
            {det, slope, {0.0, 0.0, -2.0, 1.0, 0.0, 0.0}}};
  } else {
    T determinant = det;
    for (int a = 0; a < 3; ++a) determinant.fastAccessDx(a) = slope[a];
    return {T(3, 0, C[0]), T(3, 1, C[1]), T(3, 2, C[2]), determinant};
  }
}

/// E = (C11/2, C22/2, C12), so d/dE = factor d/dC.
inline constexpr std::array<double, 3> strain_factor = {2.0, 2.0, 1.0};

/// What of an energy W and its derivatives is written, and zero where all of it is finite, else NaN.
inline Lane zero_if_finite(const Gradient& W) {
  return 0.0 * W.val() + 0.0 * W.fastAccessDx(0) + 0.0 * W.fastAccessDx(1) + 0.0 * W.fastAccessDx(2);
}
inline Lane zero_if_finite(const Hessian& W) {
  return (0.0 * W.value + 0.0 * W.d1 + 0.0 * W.d2 + 0.0 * W.d3) + (0.0 * W.d11 + 0.0 * W.d22 + 0.0 * W.d33) +
         (0.0 * W.d12 + 0.0 * W.d13 + 0.0 * W.d23);
}
inline void store_derivatives(const Block& block, long n, const Gradient& W, double* S, double*) {
  store(block, 2.0 * W.fastAccessDx(0), S);
  store(block, 2.0 * W.fastAccessDx(1), S + n);
  store(block, W.fastAccessDx(2), S + 2 * n);
}
inline void store_derivatives(const Block& block, long n, const Hessian& W, double* S, double* D) {
  store(block, 2.0 * W.d1, S);
  store(block, 2.0 * W.d2, S + n);
  store(block, W.d3, S + 2 * n);
  store(block, 4.0 * W.d11, D);
  store(block, 4.0 * W.d22, D + n);
  store(block, W.d33, D + 2 * n);
  store(block, 4.0 * W.d12, D + 3 * n);
  store(block, 2.0 * W.d13, D + 4 * n);
  store(block, 2.0 * W.d23, D + 5 * n);
}

template <class Law, class = void>
struct Thickness {
  template <class T, class P>
  static Lane stretch(const PlaneC<T>& c, const P&) {
    return sqrt(base_value(c.C33));
  }
};
template <class Law>
struct Thickness<Law, std::void_t<decltype(&Law::template thickness_stretch<Lane, Lane>)>> {
  template <class T, class P>
  static Lane stretch(const PlaneC<T>& c, const P& params) {
    return Law::thickness_stretch(PlaneC<Lane>(base_value(c.C11), base_value(c.C22), base_value(c.C12)), params);
  }
};

/// W, S, (with T = Hessian) D and the thickness stretch of one block; a point where one of W, S and D is not finite (an
/// exponential that overflows) becomes not admissible. Returns where the law is continued.
template <class T, class Law, class P>
[[gnu::always_inline]] inline LaneMask evaluate_block(const Law& law, int n, Block& block, const P& params, double* W,
                                                      double* S, double* D, double* thickness_stretch) {
  const PlaneC<T> c = seeded<T>(block.C);
  const T energy = law.energy(c, params);
  block.admissible = block.admissible & less_equal(zero_if_finite(energy), 0.0);
  store(block, base_value(energy), W);
  store_derivatives(block, n, energy, S, D);
  store(block, Thickness<Law>::stretch(c, params), thickness_stretch);
  return c.extrapolated;
}

/// dSdp by one more nested direction a parameter: T = Fad<Fad<Lane, n_params>, 3>.
template <class Law, std::size_t N>
[[gnu::noinline]] void evaluate_sensitivity(int n, const Block& block, const std::array<Lane, N>& values,
                                            const Params<Lane>& plain, double* dSdp) {
  constexpr int n_params = static_cast<int>(N);
  using P = Fad<Lane, n_params>;
  using T = Fad<P, 3>;
  std::array<P, N> params;
  std::array<double, N> choices;
  for (int k = 0; k < n_params; ++k) {
    params[k] = P(n_params, k, values[k]);
    choices[k] = plain.choice(k);
  }
  const auto variable = [&](int a) { return T(3, a, P(block.C[a])); };
  const PlaneC<T> c(variable(0), variable(1), variable(2));
  const T energy = Law::energy(c, Params<P>(params.data(), choices.data()));
  for (int a = 0; a < 3; ++a)
    for (int k = 0; k < n_params; ++k)
      store(block, strain_factor[a] * energy.fastAccessDx(a).fastAccessDx(k),
            dSdp + (static_cast<long>(a) * n_params + k) * n);
}

using LaneCodes __attribute__((vector_size(TOILE_LANES))) = std::uint8_t;

inline int store_status(const Block& block, LaneMask extrapolated, std::uint8_t* status) {
  const auto all = [](std::int64_t code) { return code + LaneMask::Vector{}; };
  const LaneMask::Vector worst =
      block.admissible.v ? (extrapolated.v ? all(point_extrapolated) : all(point_ok)) : all(point_not_admissible);
  const auto codes = __builtin_convertvector(worst, LaneCodes);
  std::memcpy(status + block.first, &codes, block.count);
  int bad = 0;
  for (int i = 0; i < block.count; ++i) bad += status[block.first + i] == point_not_admissible;
  return bad;
}

/// LawV1::evaluate of `Law`.
template <class Law>
[[gnu::flatten]] int evaluate(const void*, int n, const double* C, const double* params, int param_stride, double* W,
                              double* S, double* D, double* thickness_stretch, double* dSdp, std::uint8_t* status) {
  constexpr std::size_t n_params = Law::info.size();
  std::array<Lane, n_params> values;
  if (param_stride == 0) std::copy(params, params + n_params, values.begin());
  const Params<Lane> law_params(values.data(), params, param_stride == 0 ? 1 : n);
  int bad = 0;
  for (int first = 0; first < n; first += lanes) {
    Block block = load(n, first, C);
    if (param_stride != 0) load_params(n, block, params, values);
    const LaneMask extrapolated =
        D ? evaluate_block<Hessian>(Law(), n, block, law_params, W, S, D, thickness_stretch)
          : evaluate_block<Gradient>(Law(), n, block, law_params, W, S, nullptr, thickness_stretch);
    if (dSdp) evaluate_sensitivity<Law>(n, block, values, law_params, dSdp);
    bad += store_status(block, extrapolated, status);
  }
  return bad;
}

template <class Law, class = void>
struct Sets {
  static constexpr std::array<ParamSet, 0> value = {};
};
template <class Law>
struct Sets<Law, std::void_t<decltype(Law::sets)>> {
  static constexpr const auto& value = Law::sets;
};

template <class Law, class = void>
struct Check {
  static int run(const double*, char*, int) { return 0; }
};
template <class Law>
struct Check<Law, std::void_t<decltype(&Law::check)>> {
  static int run(const double* params, char* message, int length) { return Law::check(params, message, length); }
};

/// No entry lacks its name, unit or text: one that is declared but not written is all zero.
template <std::size_t N>
constexpr bool all_written(const std::array<ParamInfo, N>& info) {
  for (const ParamInfo& one : info)
    if (one.name == nullptr || one.unit == nullptr || one.text == nullptr) return false;
  return true;
}

template <std::size_t N>
constexpr bool names_differ(const std::array<ParamInfo, N>& info) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::string_view(info[i].name) == info[j].name) return false;
  return true;
}

/// 1 + the index of the first parameter that is outside its range, with the message; 0: none.
inline int check_ranges(const ParamInfo* params_info, int n_params, const double* params, char* message, int length) {
  for (int k = 0; k < n_params; ++k) {
    const ParamInfo& info = params_info[k];
    const bool above = info.lower_open ? params[k] > info.lower : params[k] >= info.lower;
    if (above && params[k] <= info.upper) continue;
    char upper[32] = "";
    if (info.upper < infinity) std::snprintf(upper, sizeof upper, " and <= %.6g", info.upper);
    std::snprintf(message, length, "%.6g is out of range: allowed is %s %.6g%s", params[k],
                  info.lower_open ? ">" : ">=", info.lower, upper);
    return k + 1;
  }
  return 0;
}

/// LawV1::check of `Law`: the range of each parameter, then the law's own conditions.
template <class Law>
int check(const void*, const double* params, char* message, int length) {
  const int outside = check_ranges(Law::info.data(), static_cast<int>(Law::info.size()), params, message, length);
  return outside != 0 ? outside : Check<Law>::run(params, message, length);
}

}  // namespace detail

/// The C interface of `Law`.
template <class Law>
constexpr LawV1 make_law() {
  constexpr bool all_written = detail::all_written(Law::info);
  static_assert(all_written, "`info` is declared with more entries than are written, each with name, unit and text");
  if constexpr (all_written) static_assert(detail::names_differ(Law::info), "two entries of `info` have the same name");
  return {material_abi,
          Law::name,
          Law::text,
          static_cast<int>(Law::info.size()),
          Law::info.data(),
          &detail::check<Law>,
          &detail::evaluate<Law>,
          static_cast<int>(detail::Sets<Law>::value.size()),
          detail::Sets<Law>::value.data()};
}

}  // namespace toile::material
