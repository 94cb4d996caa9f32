#include "verification/shell_scene.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "toile/run/session.hpp"
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
  run::Session session(list);
  const scene::Scene& scene = session.scene();
  const std::vector<scene::Point>& points = scene.output().points;
  PointHistory history;
  if (mixed) {
    history.statistics =
        MixedProblem(scene.problem()).run(scene, [&](const solve::StepReport& report, const solve::State& state) {
          history.reports.push_back(report);
          history.load.push_back(report.load);
          const std::vector<solve::Vec3> position = solve::node_positions(scene.problem(), state);
          for (const scene::Point& point : points)
            history.displacement[point.title].push_back(position[point.node] - scene.garment().mesh.placed[point.node]);
        });
    return history;
  }
  session.run();
  history.reports = session.record().reports();
  for (const solve::StepReport& report : history.reports) history.load.push_back(report.load);
  for (size_t i = 0; i < points.size(); ++i) history.displacement[points[i].title] = session.record().points()[i];
  history.notes = session.record().notes();
  history.statistics = session.record().statistics();
  return history;
}

base::List shipped_scene(const std::string& file) {
  return base::read_xml(TOILE_SOURCE_DIR "/input/" + file, scene::scene_spec());
}

}  // namespace toile::test
