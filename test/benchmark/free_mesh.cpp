// Time to mesh a tee freely with at least 20,000 quadrilaterals, by panel and as a whole with common nodes on its
// seams. The median of three is what the README of package mesh tells.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "toile/garment/panel.hpp"
#include "toile/garment/pattern.hpp"
#include "toile/garment/seam.hpp"
#include "toile/mesh/quality.hpp"
#include "toile/pattern/file.hpp"

namespace {

using namespace toile;

const std::string tee = TOILE_SOURCE_DIR "/test/data/patterns/gpg_tee.json";
constexpr double size = 5.95;  // mm: of the sides of elements
constexpr int wanted = 20000;

/// Of the processes that have ended, seconds: Gmsh runs in one of its own.
double processor_time() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * t.tv_usec; };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Meshes all panels of a file.
void mesh_panels(benchmark::State& state, const std::string& file, int at_least) {
  base::Spec spec("scene", "");
  spec.list(garment::pattern_spec()).list(garment::panels_spec(), true).list(garment::seams_spec());
  spec.completed_by(garment::add_pattern);
  Teuchos::ParameterList scene("scene");
  Teuchos::ParameterList& pattern = scene.sublist("Pattern");
  pattern.set("file", file);
  pattern.set("material", std::string("knit"));
  pattern.set("element size", size);
  const base::List list = base::validate(scene, spec, "scene.xml");
  std::optional<base::List> seams;
  if (list.has_list("Seams")) seams = list.list("Seams");
  int elements = 0;
  double worst = 90.0;
  const double before = processor_time();
  for (auto _ : state) {
    elements = 0;
    for (const garment::Panel& panel : garment::build_panels(list.list("Panels"), seams ? &*seams : nullptr)) {
      for (const mesh::PanelPart& part : panel.mesh.parts)
        if (part.nodes_per_element == 4) elements += static_cast<int>(part.connectivity.size()) / 4;
      worst = std::min(worst, quality_of(panel.mesh).smallest_angle);
    }
  }
  state.counters["quadrilaterals"] = elements;
  state.counters["smallest_angle"] = worst;
  state.counters["gmsh_seconds"] = processor_time() - before;
  if (elements < at_least) state.SkipWithError("fewer elements than the benchmark promises");
}

void add(const std::string& name, const std::string& file, int at_least) {
  const auto run = [file, at_least](benchmark::State& state) { mesh_panels(state, file, at_least); };
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->Iterations(1)
      ->Repetitions(3)
      ->UseRealTime()
      ->ReportAggregatesOnly()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("toile-free-mesh-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  for (const pattern::Panel& panel : pattern::read_pattern(tee).panels) {
    const std::string file = (folder / (panel.name + ".json")).string();
    pattern::write_pattern({{panel}, {}}, file);
    add(panel.name, file, 1);
  }
  add("whole", tee, wanted);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  std::filesystem::remove_all(folder);
  return 0;
}
