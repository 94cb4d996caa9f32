// Forward curves of 20 points each per second on one core: homogeneous ones, those of one candidate (wale, course, bias
// and two strip-biaxial curves) at once, as a fit evaluates them, of which at least 50,000 are expected; and clamped
// strips by finite elements (150 x 50 mm, default mesh).
#include <benchmark/benchmark.h>

#include <cmath>

#include "toile/identify/clamped_strip.hpp"
#include "toile/identify/homogeneous.hpp"

namespace {

using toile::identify::ClampedStrip;
using toile::identify::Homogeneous;
using toile::identify::TestKind;
using toile::identify::TestPoint;

constexpr int curve_points = 20;

std::vector<TestPoint> points_of(const std::vector<TestPoint>& curves) {
  std::vector<TestPoint> points;
  for (const TestPoint& curve : curves)
    for (int i = 1; i <= curve_points; ++i) points.push_back({curve.kind, curve.angle, 1.0 + 0.05 * i});
  return points;
}

void run(benchmark::State& state, const char* name, const std::vector<TestPoint>& curves, bool with_gradient) {
  const toile::material::LawV1& law = *toile::material::find(name);
  const double* params = law.sets[0].values;
  const std::vector<TestPoint> points = points_of(curves);
  Homogeneous states(points);
  std::vector<double> stress(points.size()), gradient(points.size() * law.n_params);
  const long before = states.evaluations();
  long calls = 0;
  for (auto _ : state) {
    const int bad = with_gradient ? states.stress_and_gradient(law, params, stress.data(), gradient.data())
                                  : states.stress(law, params, stress.data());
    if (bad != 0) state.SkipWithError("a state was not found");
    benchmark::DoNotOptimize(stress.data());
    ++calls;
  }
  const double n_curves = static_cast<double>(calls) * static_cast<double>(curves.size());
  state.counters["curves/s"] = benchmark::Counter(n_curves, benchmark::Counter::kIsRate);
  state.counters["evaluations/point"] =
      static_cast<double>(states.evaluations() - before) / static_cast<double>(calls * states.size());
}

void run_strip(benchmark::State& state, const char* name, double angle, bool with_gradient) {
  const toile::material::LawV1& law = *toile::material::find(name);
  const double* params = law.sets[0].values;
  std::vector<double> stretches;
  for (int i = 1; i <= curve_points; ++i) stretches.push_back(1.0 + 0.05 * i);
  ClampedStrip strip({150.0, 50.0, 12}, angle, stretches);
  std::vector<double> stress(stretches.size()), gradient(stretches.size() * law.n_params);
  const long before = strip.factorisations();
  for (auto _ : state) {
    const int bad = with_gradient ? strip.stress_and_gradient(law, params, stress.data(), gradient.data())
                                  : strip.stress(law, params, stress.data());
    if (bad != 0) state.SkipWithError("a state was not found");
    benchmark::DoNotOptimize(stress.data());
  }
  const auto curves = static_cast<double>(state.iterations());
  state.counters["curves/s"] = benchmark::Counter(curves, benchmark::Counter::kIsRate);
  state.counters["factorisations/point"] =
      static_cast<double>(strip.factorisations() - before) / (curves * curve_points);
}

const double right = std::acos(0.0);
const std::vector<TestPoint> wale = {{TestKind::uniaxial, 0.0, 1.0}};
const std::vector<TestPoint> bias = {{TestKind::uniaxial, 0.5 * right, 1.0}};
const std::vector<TestPoint> all = {{TestKind::uniaxial, 0.0, 1.0},
                                    {TestKind::uniaxial, right, 1.0},
                                    {TestKind::uniaxial, 0.5 * right, 1.0},
                                    {TestKind::strip_biaxial, 0.0, 1.0},
                                    {TestKind::strip_biaxial, right, 1.0}};

}  // namespace

BENCHMARK_CAPTURE(run, neo_hookean_five_curves, "neo-hookean", all, false);
BENCHMARK_CAPTURE(run, rebar_five_curves, "rebar", all, false);
BENCHMARK_CAPTURE(run, itskov_five_curves, "itskov", all, false);
BENCHMARK_CAPTURE(run, itskov_wale, "itskov", wale, false);
BENCHMARK_CAPTURE(run, itskov_bias, "itskov", bias, false);
BENCHMARK_CAPTURE(run, itskov_five_curves_and_gradient, "itskov", all, true);
BENCHMARK_CAPTURE(run_strip, itskov_clamped_wale, "itskov", 0.0, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_strip, itskov_clamped_bias, "itskov", 0.5 * right, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_strip, itskov_clamped_bias_and_gradient, "itskov", 0.5 * right, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(run_strip, rebar_clamped_bias, "rebar", 0.5 * right, false)->Unit(benchmark::kMillisecond);
