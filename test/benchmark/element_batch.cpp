// Time of residual and tangent of a batch of elements, and how much of it is the material's.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "toile/element/element.hpp"
#include "toile/material/material.hpp"
#include "toile/material/response.hpp"

namespace {

using namespace toile;
using Clock = std::chrono::steady_clock;
constexpr int count = 4096;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<double> pantyhose(const material::LawV1& law) {
  for (int s = 0; s < law.n_sets; ++s) {
    if (std::string(law.sets[s].name) == "pantyhose") return {law.sets[s].values, law.sets[s].values + law.n_params};
  }
  return {};
}

/// Distorted elements of 10 mm, stretched by about 1.2 (wale) and 1.8 (course) and bent; shells with 3 layers.
struct Garment {
  std::vector<double> pattern, x, wale_angle, frames, frozen;

  explicit Garment(const element::Element& element) : wale_angle(count, 0.1) {
    const double corners[4][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    for (int e = 0; e < count; ++e) {
      for (int i = 0; i < element.nodes(); ++i) {
        const double X = corners[i][0] + std::sin(e + i), Y = corners[i][1] + std::cos(2.0 * e + i);
        pattern.insert(pattern.end(), {X, Y});
        x.insert(x.end(), {1.2 * X + 0.1 * Y, 1.8 * Y, 0.02 * X * Y});
        if (element.dofs_per_node() == 5) x.insert(x.end(), {0.1 * std::sin(e), 0.1 * std::cos(i)});
        frames.insert(frames.end(), {1, 0, 0, 0, 1, 0, 0, 0, 1});
      }
    }
  }

  element::Batch batch(const element::Element& element, const material::Response& response, const double* params) {
    element::Batch all;
    all.n = count;
    all.pattern = pattern.data();
    all.x = x.data();
    all.wale_angle = wale_angle.data();
    all.response = &response;
    all.params = params;
    all.frames = frames.data();
    all.shear_modulus = 0.02;
    frozen.resize(count * element.frozen_values());
    element.freeze(all, frozen.data());
    all.frozen = frozen.data();
    return all;
  }
};

/// Residual and tangent of all elements; the material alone, at the same C (of a shell: of its mid-surface for each
/// layer), is timed apart.
void residual_and_tangent(benchmark::State& state, const char* element_name, const char* material_name) {
  const element::Element& element = *element::find(element_name);
  const material::LawV1& law = *material::find(material_name);
  const std::vector<double> params = pantyhose(law);
  const material::PlainResponse response(law);
  Garment garment(element);
  const element::Batch batch = garment.batch(element, response, params.data());
  std::vector<double> residual(count * element.ndof()), tangent(count * element.ndof() * element.ndof());

  const int chunk = 64 * element.points();
  const std::vector<double> C = element.fields(batch).C;
  std::vector<double> soa(3 * chunk), W(chunk), S(3 * chunk), D(6 * chunk), stretch(chunk);
  std::vector<std::uint8_t> status(chunk);
  const int layers = element.dofs_per_node() == 5 ? batch.layers : 1;
  double material_time = 0.0, total_time = 0.0;
  for (auto _ : state) {
    const auto start = Clock::now();
    element.evaluate(batch, {nullptr, residual.data(), tangent.data(), nullptr});
    const double time = seconds_since(start);
    state.SetIterationTime(time);
    total_time += time;
    for (int first = 0; first < count * element.points(); first += chunk) {
      for (int k = 0; k < 3 * chunk; ++k) soa[k % 3 * chunk + k / 3] = C[3 * first + k];
      const auto begin = Clock::now();
      law.evaluate(law.context, chunk, soa.data(), params.data(), 0, W.data(), S.data(), D.data(), stretch.data(),
                   nullptr, status.data());
      material_time += layers * seconds_since(begin);
    }
    benchmark::DoNotOptimize(tangent.data());
    benchmark::DoNotOptimize(D.data());
  }
  state.counters["us_per_element"] = 1e6 * total_time / (static_cast<double>(state.iterations()) * count);
  state.counters["material_share"] = material_time / total_time;
}

BENCHMARK_CAPTURE(residual_and_tangent, membrane4_neo_hookean, "membrane4", "neo-hookean")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, membrane4_itskov, "membrane4", "itskov")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, membrane4_rebar, "membrane4", "rebar")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, membrane3_neo_hookean, "membrane3", "neo-hookean")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, membrane3_itskov, "membrane3", "itskov")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, shell4_neo_hookean, "shell4", "neo-hookean")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, shell4_itskov, "shell4", "itskov")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, shell4r_neo_hookean, "shell4r", "neo-hookean")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, shell4r_itskov, "shell4r", "itskov")->UseManualTime();
BENCHMARK_CAPTURE(residual_and_tangent, shell3_neo_hookean, "shell3", "neo-hookean")->UseManualTime();

}  // namespace
