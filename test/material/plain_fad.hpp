#pragma once

#include <Sacado_Fad_SLFad.hpp>

#include "toile/material/differentiate.hpp"

// Plain nested Sacado types as the oracle of differentiation: SLFad is not the type of the product, so that none of its
// overloads applies, and every function is Sacado's own. To be included before the energies.
namespace toile::material {

template <class S, int N>
using PlainFad = Sacado::Fad::SLFad<S, N>;

template <class S, int N>
struct Base<PlainFad<S, N>> {
  using type = typename Base<S>::type;
  static constexpr int level = Base<S>::level + 1;
};

template <class S, int N>
auto base_value(const PlainFad<S, N>& x) {
  if constexpr (Base<S>::level == 0) {
    return x.val();
  } else {
    return base_value(x.val());
  }
}
template <class S, int N>
bool less(const PlainFad<S, N>& a, const same_type<PlainFad<S, N>>& b) {
  return base_value(a) < base_value(b);
}
template <class S, int N>
PlainFad<S, N> where(bool condition, const PlainFad<S, N>& yes, const same_type<PlainFad<S, N>>& no) {
  return condition ? yes : no;
}
template <class S, int N>
PlainFad<S, N> reciprocal(const PlainFad<S, N>& x) {
  return 1.0 / x;
}
template <class S, int N>
PlainFad<S, N> power(const PlainFad<S, N>& x, double a) {
  return pow(x, a);
}
template <class P, class S, int N, class F>
PlainFad<S, N> along(const PlainFad<S, N>& x, const F& f) {
  return f(x);
}

}  // namespace toile::material

#include "toile/material/hencky.hpp"
#include "toile/material/isotropic_elastic.hpp"
#include "toile/material/itskov.hpp"
#include "toile/material/neo_hookean.hpp"
#include "toile/material/rebar.hpp"

namespace toile::material {

using PlainHessian = PlainFad<PlainFad<double, 3>, 3>;

/// Energy of `Law` with its second derivatives by C11, C22, C12.
template <class Law>
PlainHessian plain_energy(const double* C, const double* params) {
  std::array<PlainHessian, 3> c;
  for (int a = 0; a < 3; ++a) c[a] = PlainHessian(3, a, PlainFad<double, 3>(3, a, C[a]));
  return Law::energy(PlaneC<PlainHessian>(c[0], c[1], c[2]), Params<double>(params, params));
}

}  // namespace toile::material
