#include "../material/formulas.hpp"
#include "../material/plain_fad.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "material_hand_written.hpp"

// Energy, stress and tangent of a batch of 256 points: the registered material, the same as a formula, hand-written
// code, plain nested Fad, and the nested Fad with our power() and log() on one number at a time. Ends with status 1 if
// a registered material costs more than 1.5 times its hand-written twin.
namespace {

using namespace toile::material;
namespace hand = toile::benchmarks;

constexpr int n = 256;

struct Batch {
  std::vector<double> C, W, S, D, h;
  std::vector<std::uint8_t> status;

  Batch() : C(3 * n), W(n), S(3 * n), D(6 * n), h(n), status(n) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> stretch(1.05, 1.9), shear(-0.2, 0.2);
    for (int i = 0; i < n; ++i) {
      const double f11 = stretch(generator), f22 = stretch(generator), f12 = shear(generator);
      C[i] = f11 * f11;
      C[n + i] = f12 * f12 + f22 * f22;
      C[2 * n + i] = f11 * f12;
    }
  }
};

/// Those of the pantyhose, or of a law without published sets Young's modulus 1 MPa and Poisson's ratio 0.3.
const double* params_of(const LawV1& law) {
  static const double isotropic[] = {1.0, 0.3};
  return law.n_sets > 0 ? law.sets[0].values : isotropic;
}

void report(benchmark::State& state) {
  state.counters["ns/point"] =
      benchmark::Counter(1e-9 * n, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void registered(benchmark::State& state, const char* name) {
  const LawV1& law = *find(name);
  Batch b;
  for (auto _ : state) {
    law.evaluate(law.context, n, b.C.data(), params_of(law), 0, b.W.data(), b.S.data(), b.D.data(), b.h.data(), nullptr,
                 b.status.data());
    benchmark::ClobberMemory();
  }
  report(state);
}

/// The numbers that are compared are the same numbers: stops the benchmark if hand-written and registered differ.
void require_agreement(const Batch& a, const LawV1& law) {
  Batch b;
  law.evaluate(law.context, n, b.C.data(), params_of(law), 0, b.W.data(), b.S.data(), b.D.data(), b.h.data(), nullptr,
               b.status.data());
  double error = 0.0, scale = 0.0;
  for (int i = 0; i < 6 * n; ++i) {
    error = std::max(error, std::abs(a.D[i] - b.D[i]));
    if (i < 3 * n) error = std::max(error, std::abs(a.S[i] - b.S[i]));
    if (i < n) error = std::max(error, std::abs(a.W[i] - b.W[i]));
    scale = std::max(scale, std::abs(b.D[i]));
  }
  if (!(error <= 1e-12 * scale)) {
    std::cerr << "hand-written and registered " << law.name << " differ by " << error / scale << "\n";
    std::exit(1);
  }
}

/// The same energy as a typed formula.
void formula(benchmark::State& state, const char* name, int n_params, const std::string& energy) {
  const LawV1& law = *find(name);
  const Laws::Law typed = test::formula_like(name, n_params, energy);
  Batch b;
  for (auto _ : state) {
    typed->evaluate(typed->context, n, b.C.data(), params_of(law), 0, b.W.data(), b.S.data(), b.D.data(), b.h.data(),
                    nullptr, b.status.data());
    benchmark::ClobberMemory();
  }
  require_agreement(b, law);
  report(state);
}

using HandWritten = hand::Point (*)(double, double, double, const double*);

template <HandWritten function>
void hand_written(Batch& b, const double* params) {
  for (int i = 0; i < n; ++i) {
    const hand::Point p = function(b.C[i], b.C[n + i], b.C[2 * n + i], params);
    b.W[i] = p.W;
    for (int a = 0; a < 3; ++a) b.S[a * n + i] = p.S[a];
    for (int a = 0; a < 6; ++a) b.D[a * n + i] = p.D[a];
  }
}

template <HandWritten function>
void by_hand(benchmark::State& state, const char* name) {
  const LawV1& law = *find(name);
  Batch b;
  for (auto _ : state) {
    hand_written<function>(b, params_of(law));
    benchmark::ClobberMemory();
  }
  require_agreement(b, law);
  report(state);
}

template <class Law, class T>
void nested(benchmark::State& state) {
  const double* params = params_of(*find(Law::name));
  using Inner = std::decay_t<decltype(T().val())>;
  Batch b;
  for (auto _ : state) {
    for (int i = 0; i < n; ++i) {
      std::array<T, 3> c;
      for (int a = 0; a < 3; ++a) {
        c[a] = T(3, a, Inner(3, a, b.C[a * n + i]));
        c[a].fastAccessDx(a) = Inner(1.0);
      }
      const T w = Law::energy(PlaneC<T>(c[0], c[1], c[2]), Params<double>(params, params));
      for (int a = 0, k = 0; a < 3; ++a) {
        b.S[a * n + i] = w.dx(a).val();
        for (int d = a; d < 3; ++d) b.D[k++ * n + i] = w.dx(a).dx(d);
      }
    }
    benchmark::ClobberMemory();
  }
  report(state);
}

constexpr auto by_hand_neo_hookean = by_hand<hand::neo_hookean>;
constexpr auto by_hand_rebar = by_hand<hand::rebar>;
constexpr auto by_hand_itskov = by_hand<hand::itskov>;
constexpr auto by_hand_hencky = by_hand<hand::hencky>;
constexpr auto by_hand_isotropic_elastic = by_hand<hand::isotropic_elastic>;

BENCHMARK_CAPTURE(registered, neo_hookean, "neo-hookean")->Name("registered/neo-hookean");
BENCHMARK_CAPTURE(formula, neo_hookean, "neo-hookean", 1, test::neo_hookean_formula)->Name("formula/neo-hookean");
BENCHMARK_CAPTURE(by_hand_neo_hookean, neo_hookean, "neo-hookean")->Name("by_hand/neo-hookean");
BENCHMARK_TEMPLATE(nested, neo_hookean::Law, PlainHessian)->Name("plain_nested_fad/neo-hookean");
BENCHMARK_TEMPLATE(nested, neo_hookean::Law, Fad<Fad<double, 3>, 3>)->Name("nested_fad_with_power/neo-hookean");
BENCHMARK_CAPTURE(registered, rebar, "rebar");
BENCHMARK_CAPTURE(formula, rebar, "rebar", 13, test::rebar_formula);
BENCHMARK_CAPTURE(by_hand_rebar, rebar, "rebar")->Name("by_hand/rebar");
BENCHMARK_TEMPLATE(nested, rebar::Law, PlainHessian)->Name("plain_nested_fad/rebar");
BENCHMARK_TEMPLATE(nested, rebar::Law, Fad<Fad<double, 3>, 3>)->Name("nested_fad_with_power/rebar");
BENCHMARK_CAPTURE(registered, itskov, "itskov");
BENCHMARK_CAPTURE(formula, itskov, "itskov", 15, test::itskov_formula());
BENCHMARK_CAPTURE(by_hand_itskov, itskov, "itskov")->Name("by_hand/itskov");
BENCHMARK_TEMPLATE(nested, itskov::Law, PlainHessian)->Name("plain_nested_fad/itskov");
BENCHMARK_TEMPLATE(nested, itskov::Law, Fad<Fad<double, 3>, 3>)->Name("nested_fad_with_power/itskov");

BENCHMARK_CAPTURE(registered, hencky, "hencky");
BENCHMARK_CAPTURE(by_hand_hencky, hencky, "hencky")->Name("by_hand/hencky");
BENCHMARK_CAPTURE(registered, isotropic_elastic, "isotropic-elastic")->Name("registered/isotropic-elastic");
BENCHMARK_CAPTURE(by_hand_isotropic_elastic, isotropic_elastic, "isotropic-elastic")->Name("by_hand/isotropic-elastic");

/// Prints as usual and keeps the least time of each benchmark: other work on the machine only adds to it.
class Times : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name != "median") continue;
      const auto known = least_.try_emplace(run.run_name.function_name, run.GetAdjustedCPUTime()).first;
      known->second = std::min(known->second, run.GetAdjustedCPUTime());
    }
    ConsoleReporter::ReportRuns(runs);
  }
  /// NaN if it did not run.
  double of(const std::string& name) const {
    const auto found = least_.find(name);
    return found == least_.end() ? NAN : found->second;
  }

 private:
  std::map<std::string, double> least_;
};

/// Every registered material must be measured and cost at most `most` times its hand-written twin.
bool costs_at_most(double most, const Times& times) {
  bool good = true;
  for (const LawV1* law : registry()) {
    const std::string name = law->name;
    const double ratio = times.of("registered/" + name) / times.of("by_hand/" + name);
    std::cout << name << ": " << ratio << " times the hand-written cost, allowed " << most << "\n";
    good = good && ratio <= most;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  Times times;
  benchmark::RunSpecifiedBenchmarks(&times);
  return costs_at_most(1.5, times) ? 0 : 1;
}
