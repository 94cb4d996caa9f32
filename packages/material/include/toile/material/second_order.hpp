#pragma once

#include <array>
#include <type_traits>

namespace toile::material {

/// Value, gradient and Hessian of a function of three variables: forward differentiation to second order. Against
/// Sacado's nested Fad, which holds 16 numbers, its 10 are each computed once, and as plain members, not arrays, the
/// compiler keeps them in registers. An energy does not see the difference.
///
/// S: Lane, or double in tests.
template <class S>
struct SecondOrder {
  S value = S(0.0);
  S d1 = S(0.0), d2 = S(0.0), d3 = S(0.0);
  S d11 = S(0.0), d22 = S(0.0), d33 = S(0.0), d12 = S(0.0), d13 = S(0.0), d23 = S(0.0);

  SecondOrder() = default;
  /// A constant: anything that a lane can be made of.
  template <class A, class = std::enable_if_t<std::is_convertible_v<A, S>>>
  SecondOrder(const A& constant) : value(constant) {}  // NOLINT: numbers are meant to convert
  SecondOrder(const S& v, const std::array<S, 3>& gradient, const std::array<S, 6>& hessian)
      : value(v),
        d1(gradient[0]),
        d2(gradient[1]),
        d3(gradient[2]),
        d11(hessian[0]),
        d22(hessian[1]),
        d33(hessian[2]),
        d12(hessian[3]),
        d13(hessian[4]),
        d23(hessian[5]) {}

  std::array<S, 3> gradient() const { return {d1, d2, d3}; }
  /// 11, 22, 33, 12, 13, 23.
  std::array<S, 6> hessian() const { return {d11, d22, d33, d12, d13, d23}; }

  template <class A>
  SecondOrder& operator+=(const A& b) {
    return *this = *this + b;
  }
  template <class A>
  SecondOrder& operator-=(const A& b) {
    return *this = *this - b;
  }
  template <class A>
  SecondOrder& operator*=(const A& b) {
    return *this = *this * b;
  }
  template <class A>
  SecondOrder& operator/=(const A& b) {
    return *this = *this / b;
  }
};

/// The second operand of an operation with a constant: whatever S can be made of.
template <class A, class S>
using constant_with = std::enable_if_t<std::is_convertible_v<A, S>>;

/// Linear combination of the derivatives and value of a and b.
template <class S>
SecondOrder<S> operator+(const SecondOrder<S>& a, const SecondOrder<S>& b) {
  return {a.value + b.value,
          {a.d1 + b.d1, a.d2 + b.d2, a.d3 + b.d3},
          {a.d11 + b.d11, a.d22 + b.d22, a.d33 + b.d33, a.d12 + b.d12, a.d13 + b.d13, a.d23 + b.d23}};
}
template <class S>
SecondOrder<S> operator-(const SecondOrder<S>& a, const SecondOrder<S>& b) {
  return {a.value - b.value,
          {a.d1 - b.d1, a.d2 - b.d2, a.d3 - b.d3},
          {a.d11 - b.d11, a.d22 - b.d22, a.d33 - b.d33, a.d12 - b.d12, a.d13 - b.d13, a.d23 - b.d23}};
}
template <class S>
SecondOrder<S> operator-(const SecondOrder<S>& a) {
  return {-a.value, {-a.d1, -a.d2, -a.d3}, {-a.d11, -a.d22, -a.d33, -a.d12, -a.d13, -a.d23}};
}
template <class S>
SecondOrder<S> operator*(const SecondOrder<S>& a, const SecondOrder<S>& b) {
  return {
      a.value * b.value,
      {a.value * b.d1 + a.d1 * b.value, a.value * b.d2 + a.d2 * b.value, a.value * b.d3 + a.d3 * b.value},
      {a.value * b.d11 + a.d11 * b.value + 2.0 * (a.d1 * b.d1), a.value * b.d22 + a.d22 * b.value + 2.0 * (a.d2 * b.d2),
       a.value * b.d33 + a.d33 * b.value + 2.0 * (a.d3 * b.d3),
       a.value * b.d12 + a.d12 * b.value + (a.d1 * b.d2 + a.d2 * b.d1),
       a.value * b.d13 + a.d13 * b.value + (a.d1 * b.d3 + a.d3 * b.d1),
       a.value * b.d23 + a.d23 * b.value + (a.d2 * b.d3 + a.d3 * b.d2)}};
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator+(SecondOrder<S> a, const A& b) {
  a.value = a.value + S(b);
  return a;
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator+(const A& a, SecondOrder<S> b) {
  b.value = S(a) + b.value;
  return b;
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator-(SecondOrder<S> a, const A& b) {
  a.value = a.value - S(b);
  return a;
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator-(const A& a, const SecondOrder<S>& b) {
  return a + -b;
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator*(const SecondOrder<S>& a, const A& b) {
  const S f(b);
  return {
      a.value * f, {a.d1 * f, a.d2 * f, a.d3 * f}, {a.d11 * f, a.d22 * f, a.d33 * f, a.d12 * f, a.d13 * f, a.d23 * f}};
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator*(const A& a, const SecondOrder<S>& b) {
  return b * a;
}

/// f(x) by the chain rule from f = {f, f', f''} at x.
template <class S>
SecondOrder<S> chain(const SecondOrder<S>& x, const std::array<S, 3>& f) {
  const S a = f[1], b = f[2];
  const S b1 = b * x.d1, b2 = b * x.d2, b3 = b * x.d3;
  return {f[0],
          {a * x.d1, a * x.d2, a * x.d3},
          {a * x.d11 + b1 * x.d1, a * x.d22 + b2 * x.d2, a * x.d33 + b3 * x.d3, a * x.d12 + b1 * x.d2,
           a * x.d13 + b1 * x.d3, a * x.d23 + b2 * x.d3}};
}
template <class S>
SecondOrder<S> operator/(const SecondOrder<S>& a, const SecondOrder<S>& b) {
  const S r = 1.0 / b.value;
  return a * chain(b, std::array<S, 3>{r, -r * r, 2.0 * r * r * r});
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator/(const SecondOrder<S>& a, const A& b) {
  return a * (1.0 / S(b));
}
template <class S, class A, class = constant_with<A, S>>
SecondOrder<S> operator/(const A& a, const SecondOrder<S>& b) {
  const S r = 1.0 / b.value;
  return chain(b, std::array<S, 3>{r, -r * r, 2.0 * r * r * r}) * a;
}

}  // namespace toile::material
