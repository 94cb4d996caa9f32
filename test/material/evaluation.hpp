#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "toile/material/response.hpp"

namespace toile::material::test {

/// All outputs of one point.
struct Point {
  double W = 0.0;
  std::array<double, 3> S = {};
  std::array<double, 6> D = {};
  double thickness_stretch = 0.0;
  std::uint8_t status = 0;
  int bad = 0;

  /// Entry of the symmetric tangent.
  double tangent(int a, int b) const {
    constexpr int index[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    return D[index[a][b]];
  }
};

using State = std::array<double, 3>;  ///< C11, C22, C12

inline Point evaluate(const LawV1& law, const std::vector<double>& params, const State& C) {
  Point p;
  p.bad = law.evaluate(law.context, 1, C.data(), params.data(), 0, &p.W, p.S.data(), p.D.data(), &p.thickness_stretch,
                       nullptr, &p.status);
  return p;
}

inline Point evaluate(const Response& response, const std::vector<double>& params, const State& C) {
  Point p;
  p.bad =
      response.evaluate(1, C.data(), params.data(), 0, &p.W, p.S.data(), p.D.data(), &p.thickness_stretch, &p.status);
  return p;
}

inline const LawV1& law(const std::string& name) {
  const LawV1* found = find(name);
  if (!found) throw std::runtime_error("no material " + name);
  return *found;
}

/// Values of the published set `set` of the material `name`.
inline std::vector<double> values(const std::string& name, const std::string& set) {
  const LawV1& found = law(name);
  for (int i = 0; i < found.n_sets; ++i)
    if (set == found.sets[i].name) return {found.sets[i].values, found.sets[i].values + found.n_params};
  throw std::runtime_error("no set " + set);
}

inline int index_of(const LawV1& material, const std::string& param) {
  for (int i = 0; i < material.n_params; ++i)
    if (param == material.info[i].name) return i;
  throw std::runtime_error("no parameter " + param);
}

/// `params` with one value replaced.
inline std::vector<double> with(const LawV1& material, std::vector<double> params, const std::string& name,
                                double value) {
  params[index_of(material, name)] = value;
  return params;
}

/// A material with values, and a name for messages.
struct Case {
  std::string name;
  const LawV1* law;
  std::vector<double> params;
};

inline bool accepts(const LawV1& material, const std::vector<double>& params) {
  std::array<char, 512> message;
  return material.check == nullptr || material.check(material.context, params.data(), message.data(), 512) == 0;
}

/// Values of a law from the ranges that it declares, for one without published sets: its defaults, and where it has
/// none `share` of the way through the range, or 0.08 above the least value if there is no greatest one.
inline std::vector<double> declared_values(const LawV1& material, double share) {
  std::vector<double> params;
  for (int i = 0; i < material.n_params; ++i) {
    const ParamInfo& info = material.info[i];
    const double lower = std::isfinite(info.lower) ? info.lower : 0.0;
    const double between = std::isfinite(info.upper) ? lower + share * (info.upper - lower) : lower + 0.08;
    params.push_back(std::isnan(info.fallback) ? between : info.fallback);
  }
  return params;
}

/// Every material with every published set that it accepts, or if it has none with values at `shares` of its ranges.
inline std::vector<Case> registered_cases(const std::vector<double>& shares = {0.4, 0.85, 1.0}) {
  std::vector<Case> all;
  for (const LawV1* material : registry()) {
    const std::size_t before = all.size();
    for (int i = 0; i < material->n_sets; ++i) {
      const std::vector<double> params = values(material->name, material->sets[i].name);
      if (accepts(*material, params))
        all.push_back({std::string(material->name) + " " + material->sets[i].name, material, params});
    }
    for (const double share : shares) {
      const std::vector<double> params = declared_values(*material, share);
      if (material->n_sets == 0 && accepts(*material, params))
        all.push_back({std::string(material->name) + " at " + std::to_string(share), material, params});
    }
    if (all.size() == before) throw std::runtime_error(std::string("no values for the material ") + material->name);
  }
  return all;
}

/// These, every reading of the rebar model, and swapped axes.
inline std::vector<Case> cases() {
  std::vector<Case> all = registered_cases();
  const LawV1& rebar = law("rebar");
  for (double strain : {0.0, 1.0, 2.0})
    for (double modulus : {0.0, 1.0}) {
      auto params = with(rebar, values("rebar", "pantyhose"), "strain", strain);
      params = with(rebar, with(rebar, params, "modulus", modulus), "fibres in compression", modulus);
      all.push_back(
          {"rebar, strain " + std::to_string(strain) + ", modulus " + std::to_string(modulus), &rebar, params});
    }
  const LawV1& itskov = law("itskov");
  all.push_back({"itskov swapped", &itskov, with(itskov, values("itskov", "t-shirt"), "swap axes", 1.0)});
  return all;
}

/// C = F^T F of random sheared deformations; principal stretches of F's factors between `low` and `high`.
inline std::vector<State> random_states(int n, double low, double high, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> stretch(low, high), shear(-0.6, 0.6);
  std::vector<State> states;
  for (int i = 0; i < n; ++i) {
    const double f11 = stretch(generator), f22 = stretch(generator), f12 = shear(generator);
    states.push_back({f11 * f11, f12 * f12 + f22 * f22, f11 * f12});
  }
  return states;
}

}  // namespace toile::material::test
