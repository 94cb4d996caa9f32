#include "verification/plane_scene.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "reals.hpp"

namespace toile::test {
namespace {

using Teuchos::ParameterList;

constexpr double cook_modulus = 80.1938;  // MPa

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

void add_support(ParameterList& scene, const std::string& name, const std::string& on, const std::string& hold) {
  ParameterList& support = scene.sublist("Supports").sublist(name);
  support.set("on", Teuchos::Array<std::string>(1, on));
  support.set("hold", hold);
}

/// Fabric, panel "sheet" with its mesh, held in its plane with its left side clamped.
ParameterList flat_scene(const PlaneCase& row, const PlaneMesh& mesh) {
  ParameterList scene("scene");
  ParameterList& fabric = scene.sublist("Materials").sublist("fabric");
  fabric.set("type", row.material);
  fabric.set("set", "pantyhose");
  ParameterList& panel = scene.sublist("Panels").sublist("sheet");
  panel.set("material", "fabric");
  panel.set("wale angle", row["wale"]);
  panel.set("elements across", mesh.across);
  panel.set("elements along", mesh.along);
  panel.set("grading across", mesh.grading);
  panel.set("grading along", mesh.grading);
  add_support(scene, "plane", "sheet", "z");
  add_support(scene, "left", "sheet.left", "xyz");
  ParameterList& pull = scene.sublist("Stages").sublist("pull");
  pull.set("type", "load");
  pull.set("first step", 0.125);
  return scene;
}

}  // namespace

std::vector<PlaneCase> plane_cases(const std::string& file) {
  const std::string path = TOILE_SOURCE_DIR "/test/data/plane_stress/" + file + ".csv";
  std::ifstream stream(path);
  if (!stream) throw std::runtime_error("missing " + path);
  std::vector<std::string> titles;
  std::vector<PlaneCase> rows;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("#", 0) == 0) continue;
    const std::vector<std::string> words = split(line);
    if (titles.empty()) {
      titles = words;
      continue;
    }
    PlaneCase row{words.front(), {}};
    for (size_t c = 1; c < titles.size(); ++c) row.value[titles[c]] = std::stod(words.at(c));
    rows.push_back(row);
  }
  return rows;
}

ParameterList cook_list(const PlaneCase& row, const PlaneMesh& mesh) {
  ParameterList scene = flat_scene(row, mesh);
  ParameterList& fabric = scene.sublist("Materials").sublist("fabric");
  if (row.material == "neo-hookean") fabric.set("C10", 0.5 * cook_modulus);
  ParameterList& panel = scene.sublist("Panels").sublist("sheet");
  panel.set("shape", "four-sided");
  panel.set("bottom", reals({0, 0, 48, 44}));
  panel.set("right", reals({48, 44, 48, 60}));
  panel.set("top", reals({0, 44, 48, 60}));
  panel.set("left", reals({0, 0, 0, 44}));
  ParameterList& load = scene.sublist("Loads").sublist("shear");
  load.set("on", "sheet.right");
  load.set("traction", reals({0, row["F"] / 16.0, 0}));
  return scene;
}

ParameterList strip_list(const PlaneCase& row, const PlaneMesh& mesh) {
  ParameterList scene = flat_scene(row, mesh);
  ParameterList& panel = scene.sublist("Panels").sublist("sheet");
  panel.set("shape", "rectangle");
  panel.set("width", 150.0);
  panel.set("height", 50.0);
  add_support(scene, "right", "sheet.right", "xyz");
  scene.sublist("Supports").sublist("right").set("move by", reals({150.0 * (row["stretch"] - 1.0), 0, 0}));
  return scene;
}

solve::Vec3 PlaneRun::displacement(int node) const {
  return states.back().position[node] - scene->garment().mesh.placed[node];
}

const std::vector<int>& PlaneRun::edge(const std::string& name) const {
  return scene->garment().mesh.edges.at(name);
}

solve::Vec3 PlaneRun::reaction(const std::string& support, size_t step) const {
  const std::vector<solve::Support>& supports = scene->problem().supports;
  for (size_t s = 0; s < supports.size(); ++s)
    if (supports[s].name == support) return reports[step].balance.support[s];
  throw std::runtime_error("no support " + support);
}

namespace {

/// Keeps what is known of every step.
class Steps : public run::Observer {
 public:
  explicit Steps(PlaneRun& found) : found_(found) {}
  bool on_every_rank() const override { return true; }
  void step(const run::Record& record) override {
    found_.reports.push_back(record.last());
    found_.states.push_back(record.state());
  }

 private:
  PlaneRun& found_;
};

PlaneRun run_problem(std::unique_ptr<run::Session> session, bool mixed) {
  PlaneRun found;
  found.session = std::move(session);
  found.scene = &found.session->scene();
  if (mixed) {
    found.mixed = std::make_unique<MixedProblem>(found.scene->problem());
    found.mixed->run(*found.scene, [&found](const solve::StepReport& report, const solve::State& state) {
      found.reports.push_back(report);
      found.states.push_back(state);
    });
  } else {
    found.session->add(std::make_unique<Steps>(found));
    found.session->run();
  }
  return found;
}

}  // namespace

size_t final_step(const PlaneRun& run, double load) {
  for (size_t k = 0; k < run.reports.size(); ++k)
    if (run.reports[k].undamped && std::abs(run.reports[k].load - load) < 1e-9) return k;
  throw std::runtime_error("no final state at load " + std::to_string(load));
}

PlaneRun run(const base::List& list) {
  return run_problem(std::make_unique<run::Session>(list), false);
}

PlaneRun run(const ParameterList& list) {
  return run_problem(std::make_unique<run::Session>(list, "plane.xml"), false);
}

PlaneRun run_shipped(const std::string& file) {
  return run_problem(std::make_unique<run::Session>(TOILE_SOURCE_DIR "/input/" + file), false);
}

PlaneRun run_freely(ParameterList list, const FreeMeshing& meshing) {
  ParameterList& panel = list.sublist("Panels").sublist("sheet");
  for (const char* name : {"elements across", "elements along", "grading across", "grading along"}) panel.remove(name);
  panel.set("mesher", "free");
  panel.set("element size", meshing.size);
  panel.set("elements", meshing.kind == "triangles" ? "triangle" : "quadrilateral");
  for (size_t k = 0; k < meshing.corners.size(); k += 2) {
    ParameterList& finer = panel.sublist("Sizes").sublist("corner " + std::to_string(k / 2));
    finer.set("at point", reals({meshing.corners[k], meshing.corners[k + 1]}));
    finer.set("size", meshing.corner_size);
    finer.set("distance", 16.0);
  }
  return run_problem(std::make_unique<run::Session>(list, "plane.xml"), meshing.kind == "mixed");
}

}  // namespace toile::test
