#include "verification/shell_scene.hpp"

#include <Tpetra_Core.hpp>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "toile/base/timer.hpp"
#include "verification/mixed_problem.hpp"

namespace toile::test {

std::map<std::string, std::vector<double>> read_table(const std::string& file) {
  const std::string path = std::string(TOILE_SOURCE_DIR "/test/data/") + file;
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("missing " + path);
  std::vector<std::string> titles;
  std::map<std::string, std::vector<double>> table;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("#", 0) == 0) continue;
    std::istringstream words(line);
    std::string word;
    if (titles.empty()) {
      while (std::getline(words, word, ',')) titles.push_back(word);
      continue;
    }
    for (const std::string& title : titles) {
      std::getline(words, word, ',');
      table[title].push_back(std::stod(word));
    }
  }
  return table;
}

size_t PointHistory::step_at(double wanted) const {
  for (size_t k = 0; k < load.size(); ++k)
    if (std::abs(load[k] - wanted) < 1e-9) return k;
  throw std::runtime_error("no step at load " + std::to_string(wanted));
}

PointHistory follow_points(const base::List& list, bool mixed) {
  PointHistory history;
  base::Timer timer;
  const scene::Scene scene(list, Tpetra::getDefaultComm()->getSize(), timer);
  const mesh::Mesh& mesh = scene.garment().mesh;
  std::optional<MixedProblem> cut;
  if (mixed) cut.emplace(scene.problem());
  solve::Simulation simulation(cut ? cut->problem : scene.problem(), scene.solver());
  std::vector<int> cluster_of(mesh.nodes());
  for (size_t c = 0; c < scene.problem().clusters.size(); ++c)
    for (const int n : scene.problem().clusters[c]) cluster_of[n] = static_cast<int>(c);
  simulation.observe([&](const solve::StepReport& report, const solve::State& state) {
    history.reports.push_back(report);
    history.load.push_back(report.load);
    for (const scene::Point& point : scene.output().points)
      history.displacement[point.title].push_back(
          node_position(scene.problem(), state, cluster_of[point.node], point.node) - mesh.placed[point.node]);
  });
  simulation.set_start(scene.start());
  for (const solve::StageOptions& stage : scene.stages()) simulation.run(stage);
  history.notes = simulation.notes();
  history.statistics = simulation.statistics();
  return history;
}

base::List shipped_scene(const std::string& file) {
  return base::read_xml(TOILE_SOURCE_DIR "/input/" + file, scene::scene_spec());
}

}  // namespace toile::test
