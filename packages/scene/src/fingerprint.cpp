#include "toile/scene/fingerprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "toile/base/values.hpp"

namespace toile::scene {

namespace {

const std::string stages_path = "scene > Stages > ";

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// Sizes and sums that no two garments share by chance.
template <class Points>
std::vector<double> figures_of(const Points& points) {
  double sum = 0.0, weighted = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    sum += points[i].norm();
    weighted += std::cos(static_cast<double>(i)) * points[i].sum();
  }
  return {static_cast<double>(points.size()), sum, weighted};
}

bool is_same(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double round_off = 1e-9;  // of another processor
  const auto same = [](double x, double y) { return std::abs(x - y) <= round_off * (std::abs(x) + std::abs(y) + 1.0); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// What the law of a fabric says at a few strains: its formula or plug-in may be another one under the same name.
std::vector<double> energies_of(const material::Material& fabric) {
  constexpr size_t strains = 3;
  const std::array<double, 3 * strains> C = {1.2, 1.0, 1.15, 1.0, 1.2, 1.1, 0.0, 0.0, 0.1};  // C11, C22, C12
  const std::vector<double> params = fabric.params_at(0.5);
  std::vector<double> W(strains, 0.0);
  std::array<double, 3 * strains> S{};
  std::array<double, strains> thickness_stretch{};
  std::array<std::uint8_t, strains> status{};
  fabric.response().evaluate(strains, C.data(), params.data(), 0, W.data(), S.data(), nullptr, thickness_stretch.data(),
                             status.data());
  for (double& energy : W)
    if (!std::isfinite(energy)) energy = 0.0;  // beyond what the law allows
  return W;
}

/// A value that decides nothing of the steps so far.
bool is_free(const std::string& path, const std::string& running, const std::vector<std::string>& later) {
  for (const char* list : {"scene > Output > ", "scene > Checks > ", "scene > Solver > "})
    if (starts_with(path, list)) return true;
  if (path == "scene > title" || path == "scene > include") return true;
  if (!running.empty())
    for (const char* limit : {"most steps", "most time", "most iterations in all"})
      if (path == stages_path + running + " > " + limit) return true;
  return std::any_of(later.begin(), later.end(),
                     [&](const std::string& stage) { return starts_with(path, stages_path + stage + " > "); });
}

std::string line(const std::string& path, const std::string& before, const std::string& now) {
  constexpr size_t most = 60;  // characters
  const auto shown = [](const std::string& text) {
    return text.size() <= most ? "\"" + text + "\"" : "\"" + text.substr(0, most) + "...\"";
  };
  return path + ": " + shown(before) + " in the run so far, " + shown(now) + " in the scene";
}

}  // namespace

Fingerprint fingerprint(const base::List& list, const base::Spec& spec, const Scene& scene) {
  Fingerprint found;
  found.values = base::values_of(list, spec);
  for (const solve::StageOptions& stage : scene.stages()) found.stages.push_back(stage.name);
  const mesh::Mesh& mesh = scene.garment().mesh;
  found.figures["pattern"] = figures_of(mesh.pattern);
  found.figures["placed garment"] = figures_of(mesh.placed);
  found.figures["seams"] = {static_cast<double>(scene.problem().clusters.size())};
  for (const mesh::Block& block : mesh.blocks) found.figures["elements"].push_back(block.size());
  for (const solve::BlockModel& model : scene.problem().models)
    for (const double energy : energies_of(*model.material)) found.figures["fabrics"].push_back(energy);
  if (scene.surface() == nullptr) return found;
  constexpr size_t probes = 100;
  for (size_t i = 0; i < mesh.placed.size(); i += mesh.placed.size() / probes + 1)
    found.figures["body"].push_back(scene.surface()->closest(mesh.placed[i]).gap);
  return found;
}

std::vector<std::string> differences(const Fingerprint& before, const Fingerprint& now, int stage, bool finished) {
  std::vector<std::string> found;
  const size_t behind = static_cast<size_t>(stage) + 1;  // those that have begun
  for (size_t i = 0; i < behind; ++i) {
    const std::string was = i < before.stages.size() ? before.stages[i] : "",
                      is = i < now.stages.size() ? now.stages[i] : "";
    if (was != is) found.push_back(line("stage number " + std::to_string(i + 1), was, is));
  }
  if (!found.empty()) return found;
  const std::string running = finished ? "" : now.stages[behind - 1];
  std::vector<std::string> later(now.stages.begin() + static_cast<std::ptrdiff_t>(behind), now.stages.end());
  later.insert(later.end(), before.stages.begin() + static_cast<std::ptrdiff_t>(behind), before.stages.end());
  std::map<std::string, std::string> all = before.values;
  all.insert(now.values.begin(), now.values.end());
  const auto value = [](const Fingerprint& of, const std::string& path) {
    const auto at = of.values.find(path);
    return at == of.values.end() ? std::string() : at->second;
  };
  for (const auto& [path, text] : all)
    if (value(before, path) != value(now, path) && !is_free(path, running, later))
      found.push_back(line(path, value(before, path), value(now, path)));
  if (!found.empty()) return found;
  for (const auto& [name, figures] : before.figures) {
    const auto at = now.figures.find(name);
    if (at == now.figures.end() || !is_same(figures, at->second))
      found.push_back("the " + name +
                      ": a file that the scene names has changed, or another version of Toile builds it");
  }
  return found;
}

}  // namespace toile::scene
