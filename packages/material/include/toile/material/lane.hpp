#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#if defined(__AVX512F__)
#define TOILE_LANES 8
#elif defined(__AVX2__)
#define TOILE_LANES 4
#else
#define TOILE_LANES 2
#endif

// glibc's vector mathematics library (at most 4 units in the last place), part of libm on x86-64.
#if defined(__GLIBC__) && TOILE_LANES == 8
#define TOILE_VECTOR_MATH(name) _ZGVeN8v_##name
#define TOILE_VECTOR_MATH2(name) _ZGVeN8vv_##name
#elif defined(__GLIBC__) && TOILE_LANES == 4
#define TOILE_VECTOR_MATH(name) _ZGVdN4v_##name
#define TOILE_VECTOR_MATH2(name) _ZGVdN4vv_##name
#endif

namespace toile::material {

/// Number of points that are evaluated at once.
inline constexpr int lanes = TOILE_LANES;

/// One truth value for each lane.
struct LaneMask {
  using Vector __attribute__((vector_size(8 * TOILE_LANES))) = std::int64_t;
  Vector v = {};  ///< each entry is 0 (false) or -1 (true)

  bool operator[](int i) const { return v[i] != 0; }
  friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.v & b.v}; }
  friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.v | b.v}; }
};

/// One double for each of `lanes` points: the innermost scalar of differentiation. Every operation acts lane by lane
/// and gives what double gives, so a point's result does not depend on the points beside it.
struct Lane {
  using Vector __attribute__((vector_size(8 * TOILE_LANES))) = double;
  Vector v = {};

  Lane() = default;
  Lane(double value) : v(value - Vector{}) {}  // NOLINT: numbers are meant to convert
  explicit Lane(Vector values) : v(values) {}

  double operator[](int i) const { return v[i]; }

  /// The first `count` lanes from memory; the others repeat the last of them.
  static Lane load(const double* values, int count) {
    Lane lane;
    if (count == lanes) {
      std::memcpy(&lane.v, values, sizeof lane.v);
    } else {
      for (int i = 0; i < lanes; ++i) lane.v[i] = values[i < count ? i : count - 1];
    }
    return lane;
  }
  /// The first `count` lanes to memory.
  void store(double* values, int count) const {
    if (count == lanes) {
      std::memcpy(values, &v, sizeof v);
    } else {
      for (int i = 0; i < count; ++i) values[i] = v[i];
    }
  }

  Lane& operator+=(Lane b) { return v += b.v, *this; }
  Lane& operator-=(Lane b) { return v -= b.v, *this; }
  Lane& operator*=(Lane b) { return v *= b.v, *this; }
  Lane& operator/=(Lane b) { return v /= b.v, *this; }
  friend Lane operator+(Lane a, Lane b) { return Lane(a.v + b.v); }
  friend Lane operator-(Lane a, Lane b) { return Lane(a.v - b.v); }
  friend Lane operator*(Lane a, Lane b) { return Lane(a.v * b.v); }
  friend Lane operator/(Lane a, Lane b) { return Lane(a.v / b.v); }
  friend Lane operator-(Lane a) { return Lane(-a.v); }
  friend Lane operator+(Lane a) { return a; }
};

inline LaneMask less(Lane a, Lane b) {
  return {a.v < b.v};
}
inline LaneMask less_equal(Lane a, Lane b) {
  return {a.v <= b.v};
}
inline Lane where(LaneMask condition, Lane yes, Lane no) {
  return Lane(condition.v ? yes.v : no.v);
}

/// `function` of each lane.
template <class Function>
Lane each_lane(Lane x, Function function) {
  for (int i = 0; i < lanes; ++i) x.v[i] = function(x.v[i]);
  return x;
}

#ifdef TOILE_VECTOR_MATH
extern "C" Lane::Vector TOILE_VECTOR_MATH(log)(Lane::Vector);
extern "C" Lane::Vector TOILE_VECTOR_MATH(exp)(Lane::Vector);
extern "C" Lane::Vector TOILE_VECTOR_MATH(sin)(Lane::Vector);
extern "C" Lane::Vector TOILE_VECTOR_MATH(cos)(Lane::Vector);
extern "C" Lane::Vector TOILE_VECTOR_MATH2(pow)(Lane::Vector, Lane::Vector);
inline Lane log(Lane x) {
  return Lane(TOILE_VECTOR_MATH(log)(x.v));
}
inline Lane exp(Lane x) {
  return Lane(TOILE_VECTOR_MATH(exp)(x.v));
}
inline Lane sin(Lane x) {
  return Lane(TOILE_VECTOR_MATH(sin)(x.v));
}
inline Lane cos(Lane x) {
  return Lane(TOILE_VECTOR_MATH(cos)(x.v));
}
inline Lane pow(Lane x, Lane exponent) {
  return Lane(TOILE_VECTOR_MATH2(pow)(x.v, exponent.v));
}
#else
inline Lane log(Lane x) {
  return each_lane(x, [](double value) { return std::log(value); });
}
inline Lane exp(Lane x) {
  return each_lane(x, [](double value) { return std::exp(value); });
}
inline Lane sin(Lane x) {
  return each_lane(x, [](double value) { return std::sin(value); });
}
inline Lane cos(Lane x) {
  return each_lane(x, [](double value) { return std::cos(value); });
}
inline Lane pow(Lane x, Lane exponent) {
  for (int i = 0; i < lanes; ++i) x.v[i] = std::pow(x.v[i], exponent.v[i]);
  return x;
}
#endif

/// Vector instruction where there is one: std::sqrt may set errno, so the compiler would go lane by lane. (The unmasked
/// AVX-512 intrinsic draws a false warning about an uninitialised value from GCC 12.)
inline Lane sqrt(Lane x) {
#if TOILE_LANES == 8
  return Lane(Lane::Vector(_mm512_maskz_sqrt_pd(0xff, __m512d(x.v))));
#elif TOILE_LANES == 4
  return Lane(Lane::Vector(_mm256_sqrt_pd(__m256d(x.v))));
#else
  return each_lane(x, [](double value) { return std::sqrt(value); });
#endif
}

}  // namespace toile::material
