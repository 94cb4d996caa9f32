#pragma once

#include <Sacado_Fad_SFad.hpp>
#include <array>
#include <cmath>
#include <type_traits>

#include "toile/material/lane.hpp"
#include "toile/material/second_order.hpp"

namespace Sacado {
// Number literals in an energy stay plain doubles; they are not widened to a Fad with zero derivatives.
template <>
struct ScalarType<toile::material::Lane> {
  using type = double;
};
}  // namespace Sacado

namespace toile::material {

/// Forward differentiation in N directions. Nested, Fad<Fad<S, 3>, 3> holds the second derivatives too.
template <class S, int N>
using Fad = Sacado::Fad::SFad<S, N>;

/// The number at the bottom of nested Fads: double or Lane.
template <class T>
struct Base {
  using type = T;
  static constexpr int level = 0;
};
template <class S, int N>
struct Base<Fad<S, N>> {
  using type = typename Base<S>::type;
  static constexpr int level = Base<S>::level + 1;
};
template <class S>
struct Base<SecondOrder<S>> {
  using type = S;
  static constexpr int level = 2;
};
template <class T>
using base_type = typename Base<T>::type;

template <class T>
struct Same {
  using type = T;
};
/// T, where the compiler shall not deduce T from the argument (so that a number converts).
template <class T>
using same_type = typename Same<T>::type;

inline double base_value(double x) {
  return x;
}
inline Lane base_value(Lane x) {
  return x;
}
template <class S, int N>
base_type<S> base_value(const Fad<S, N>& x) {
  return base_value(x.val());
}
template <class S>
S base_value(const SecondOrder<S>& x) {
  return x.value;
}

/// less(x, bound): the comparison of the values, as the condition of where().
inline bool less(double a, double b) {
  return a < b;
}
template <class S, int N>
auto less(const Fad<S, N>& a, const same_type<Fad<S, N>>& b) {
  return less(base_value(a), base_value(b));
}
template <class S>
auto less(const SecondOrder<S>& a, const same_type<SecondOrder<S>>& b) {
  return less(a.value, b.value);
}
template <class T>
using mask_type = decltype(less(std::declval<T>(), std::declval<T>()));

/// where(condition, yes, no): `yes` where the condition holds, else `no`, with their derivatives. Both are evaluated;
/// what is not chosen may be NaN.
inline double where(bool condition, double yes, double no) {
  return condition ? yes : no;
}
template <class S, int N>
Fad<S, N> where(const mask_type<S>& condition, const Fad<S, N>& yes, const same_type<Fad<S, N>>& no) {
  Fad<S, N> result;
  result.val() = where(condition, yes.val(), no.val());
  for (int i = 0; i < N; ++i) result.fastAccessDx(i) = where(condition, yes.fastAccessDx(i), no.fastAccessDx(i));
  return result;
}
template <class S>
SecondOrder<S> where(const mask_type<S>& condition, const SecondOrder<S>& yes, const same_type<SecondOrder<S>>& no) {
  const auto either = [&](const S& a, const S& b) { return where(condition, a, b); };
  return {either(yes.value, no.value),
          {either(yes.d1, no.d1), either(yes.d2, no.d2), either(yes.d3, no.d3)},
          {either(yes.d11, no.d11), either(yes.d22, no.d22), either(yes.d33, no.d33), either(yes.d12, no.d12),
           either(yes.d13, no.d13), either(yes.d23, no.d23)}};
}

/// f(x) by the chain rule from the base values f[k] = d^k f/dx^k at x: each is evaluated once, however deep the
/// nesting.
template <std::size_t K>
double chain(double, const std::array<double, K>& f, int order = 0) {
  return f[order];
}
template <std::size_t K>
Lane chain(Lane, const std::array<Lane, K>& f, int order = 0) {
  return f[order];
}
template <class S, int N, std::size_t K>
Fad<S, N> chain(const Fad<S, N>& x, const std::array<base_type<S>, K>& f, int order = 0) {
  static_assert(K > Base<Fad<S, N>>::level, "one more derivative is needed than there are levels");
  const S slope = chain(x.val(), f, order + 1);
  Fad<S, N> result;
  result.val() = chain(x.val(), f, order);
  for (int i = 0; i < N; ++i) result.fastAccessDx(i) = slope * x.fastAccessDx(i);
  return result;
}

template <class T>
struct IsVariable : std::false_type {};
template <class S, int N>
struct IsVariable<Fad<S, N>> : std::true_type {};
template <class S>
struct IsVariable<SecondOrder<S>> : std::true_type {};
/// T, for the types whose functions are chained below.
template <class T>
using variable = std::enable_if_t<IsVariable<T>::value, T>;

inline double reciprocal(double x) {
  return 1.0 / x;
}
inline Lane reciprocal(Lane x) {
  return 1.0 / x;
}
template <class T>
variable<T> reciprocal(const T& x) {
  const base_type<T> r = 1.0 / base_value(x);
  return chain(x, std::array<base_type<T>, 3>{r, -r * r, 2.0 * r * r * r});
}

inline double log(double x) {
  return std::log(x);
}
template <class T>
variable<T> log(const T& x) {
  const base_type<T> value = base_value(x);
  const base_type<T> r = 1.0 / value;
  return chain(x, std::array<base_type<T>, 3>{log(value), r, -r * r});
}

inline double exp(double x) {
  return std::exp(x);
}
template <class T>
variable<T> exp(const T& x) {
  const base_type<T> value = exp(base_value(x));
  return chain(x, std::array<base_type<T>, 3>{value, value, value});
}

inline double sin(double x) {
  return std::sin(x);
}
inline double cos(double x) {
  return std::cos(x);
}
template <class T>
variable<T> sin(const T& x) {
  const base_type<T> s = sin(base_value(x)), c = cos(base_value(x));
  return chain(x, std::array<base_type<T>, 3>{s, c, -s});
}
template <class T>
variable<T> cos(const T& x) {
  const base_type<T> s = sin(base_value(x)), c = cos(base_value(x));
  return chain(x, std::array<base_type<T>, 3>{c, -s, -c});
}

inline double sqrt(double x) {
  return std::sqrt(x);
}
template <class T>
variable<T> sqrt(const T& x) {
  const base_type<T> value = base_value(x);
  const base_type<T> root = sqrt(value);
  const base_type<T> slope = 0.5 / root;
  return chain(x, std::array<base_type<T>, 3>{root, slope, -0.5 * slope / value});
}

/// power(x, a) = x^a for x >= 0. The exponent is a number or a parameter. At x = 0, which max(.., 0) leads to,
/// derivatives are those of the slack side, zero, wherever the power itself has none (second derivatives for 1 <= a <
/// 2).
inline double power(double x, double a) {
  return std::pow(x, a);
}
inline Lane power(Lane x, Lane a) {
  return pow(x, a);
}
template <class T>
variable<T> power(const T& x, const base_type<T>& a) {
  using B = base_type<T>;
  const B value = base_value(x);
  B p = power(value, B(a - 2.0));
  p = where(less(B(0.0), value), p, where(less(a, B(1.0)), p, where(less(a, B(2.0)), B(0.0), p)));
  return chain(x, std::array<B, 3>{p * value * value, a * p * value, a * (a - 1.0) * p});
}
/// Derivatives by the exponent too: both are parameters.
template <class B, int N>
std::enable_if_t<Base<B>::level == 0, Fad<B, N>> power(const Fad<B, N>& x, const Fad<B, N>& a) {
  const B p = power(x.val(), a.val());
  const B slope = a.val() * power(x.val(), B(a.val() - 1.0));
  const auto is_positive = less(B(0.0), x.val());
  const B by_x = where(is_positive, slope, where(less(a.val(), B(1.0)), B(0.0), slope));
  const B by_a = where(is_positive, p * log(x.val()), B(0.0));
  Fad<B, N> result;
  result.val() = p;
  for (int i = 0; i < N; ++i) result.fastAccessDx(i) = by_x * x.fastAccessDx(i) + by_a * a.fastAccessDx(i);
  return result;
}
/// Derivatives by C of a power whose exponent is a parameter that is differentiated by.
template <class B, int M, int N>
Fad<Fad<B, M>, N> power(const Fad<Fad<B, M>, N>& x, const Fad<B, M>& a) {
  Fad<Fad<B, M>, N> result;
  result.val() = power(x.val(), a);
  const Fad<B, M> exponent = a - 1.0;
  const Fad<B, M> slope = a * power(x.val(), exponent);
  for (int i = 0; i < N; ++i) result.fastAccessDx(i) = slope * x.fastAccessDx(i);
  return result;
}

/// f(x) of one variable, for a costly f (a polynomial, say): differentiated along x alone, then by the chain rule.
/// P is the type of the parameters that f uses; f is a generic function, f(u) has the type of u.
template <class P, class F>
double along(double x, const F& f) {
  return f(x);
}
template <class P, class T, class F>
variable<T> along(const T& x, const F& f) {
  if constexpr (Base<T>::level == Base<P>::level + 1) {
    const Fad<P, 1> value = f(Fad<P, 1>(1, 0, x.val()));
    T result;
    result.val() = value.val();
    for (int i = 0; i < x.size(); ++i) result.fastAccessDx(i) = value.fastAccessDx(0) * x.fastAccessDx(i);
    return result;
  } else {
    using B = base_type<T>;
    Fad<Fad<B, 1>, 1> u(1, 0, Fad<B, 1>(1, 0, base_value(x)));
    u.fastAccessDx(0) = Fad<B, 1>(1.0);
    u = f(u);
    return chain(x, std::array<B, 3>{u.val().val(), u.val().fastAccessDx(0), u.fastAccessDx(0).fastAccessDx(0)});
  }
}

}  // namespace toile::material
