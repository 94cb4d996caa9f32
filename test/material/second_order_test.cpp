#include "plain_fad.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

// Value, gradient and Hessian of SecondOrder are those of plain nested Sacado types, for every operation that an energy
// may use.
namespace toile::material {
namespace {

using Second = SecondOrder<double>;

/// `f` is a generic function of three variables.
template <class F>
void expect_equal_derivatives(const char* name, const F& f) {
  const std::array<double, 3> x = {1.3, 0.7, 0.4};
  const Second s =
      f(Second(x[0], {1.0, 0.0, 0.0}, {}), Second(x[1], {0.0, 1.0, 0.0}, {}), Second(x[2], {0.0, 0.0, 1.0}, {}));
  std::array<PlainHessian, 3> v;
  for (int a = 0; a < 3; ++a) v[a] = PlainHessian(3, a, PlainFad<double, 3>(3, a, x[a]));
  const PlainHessian p = f(v[0], v[1], v[2]);

  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  EXPECT_NEAR(s.value, p.val().val(), 1e-14) << name;
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(s.gradient()[a], p.dx(a).val(), 1e-13) << name << a;
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(s.hessian()[k], p.dx(pairs[k][0]).dx(pairs[k][1]), 1e-12) << name << k;
}

template <class T>
T mixed(const T& x, const T& y, const T& z) {
  const T product = x * y * z;
  return product + x * x;
}

TEST(SecondOrder, arithmetic_of_variables) {
  expect_equal_derivatives("product", [](auto x, auto y, auto z) -> decltype(x) { return x * y * z * x; });
  expect_equal_derivatives("quotient", [](auto x, auto y, auto z) -> decltype(x) { return x * z / (y + z * z); });
  expect_equal_derivatives("sum", [](auto x, auto y, auto z) -> decltype(x) { return -(x * y) + y * z - z * z + x; });
  expect_equal_derivatives("assigned", [](auto x, auto y, auto z) -> decltype(x) {
    x *= y;
    x += z * z;
    x -= y * y;
    x /= z;
    return x;
  });
}

TEST(SecondOrder, arithmetic_with_numbers) {
  expect_equal_derivatives("left", [](auto x, auto y, auto z) -> decltype(x) { return (2.0 - x * y) * (3.0 + z * y); });
  expect_equal_derivatives("right",
                           [](auto x, auto y, auto z) -> decltype(x) { return (x * z - 2.0) * (y * y + 3.0); });
  expect_equal_derivatives("factors",
                           [](auto x, auto y, auto z) -> decltype(x) { return 2.0 * (x * y) * 3.0 / 7.0 + z; });
  expect_equal_derivatives("numerator", [](auto x, auto y, auto z) -> decltype(x) { return 2.0 / (x * y + z); });
}

TEST(SecondOrder, functions) {
  expect_equal_derivatives("log", [](auto x, auto y, auto z) -> decltype(x) { return log(mixed(x, y, z)); });
  expect_equal_derivatives("exp", [](auto x, auto y, auto z) -> decltype(x) { return exp(mixed(x, y, z)); });
  expect_equal_derivatives("sqrt", [](auto x, auto y, auto z) -> decltype(x) { return sqrt(mixed(x, y, z)); });
  expect_equal_derivatives("sin", [](auto x, auto y, auto z) -> decltype(x) { return sin(mixed(x, y, z)); });
  expect_equal_derivatives("cos", [](auto x, auto y, auto z) -> decltype(x) { return cos(mixed(x, y, z)); });
  expect_equal_derivatives("reciprocal",
                           [](auto x, auto y, auto z) -> decltype(x) { return reciprocal(mixed(x, y, z)); });
  expect_equal_derivatives("power", [](auto x, auto y, auto z) -> decltype(x) { return power(mixed(x, y, z), 3.7); });
}

TEST(SecondOrder, choice_and_function_of_one_variable) {
  expect_equal_derivatives("yes", [](auto x, auto y, auto z) -> decltype(x) {
    const decltype(x) yes = x * y, no = z * z;
    return where(less(y, x), yes, no);
  });
  expect_equal_derivatives("no", [](auto x, auto y, auto z) -> decltype(x) {
    const decltype(x) yes = x * y, no = z * z;
    return where(less(x, y), yes, no);
  });
  expect_equal_derivatives("along", [](auto x, auto y, auto z) -> decltype(x) {
    const decltype(x) u = mixed(x, y, z);
    return along<double>(u, [](const auto& v) -> std::decay_t<decltype(v)> { return v * v * (2.0 + v); });
  });
}

}  // namespace
}  // namespace toile::material
