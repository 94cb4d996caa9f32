#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <sstream>

#include "held.hpp"
#include "toile/solve/spec.hpp"

namespace toile::solve {

namespace {

/// Two supports that take the same component of the same node along different paths.
struct Contradiction {
  size_t first, second;
  int node, direction;
};

HeldComponent path(const Problem& problem, size_t support, const Vec3& placed, int direction) {
  return held_component(problem, support, direction, placed);
}

std::optional<Contradiction> contradiction(const Problem& problem, const std::set<std::string>& released) {
  std::vector<int> cluster_of(problem.mesh->nodes());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  const std::array<int, 3> nobody = {-1, -1, -1};
  std::vector<std::array<int, 3>> holder(problem.clusters.size(), nobody);
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    if (released.count(support.name)) continue;
    for (const int node : support.nodes)
      for (int d = 0; d < 3; ++d) {
        if (!support.held[d]) continue;
        int& other = holder[cluster_of[node]][d];
        const Vec3& placed = problem.mesh->placed[problem.clusters[cluster_of[node]].front()];
        if (other >= 0 &&
            !move_alike(problem, path(problem, static_cast<size_t>(other), placed, d), path(problem, s, placed, d)))
          return Contradiction{static_cast<size_t>(other), s, node, d};
        other = static_cast<int>(s);
      }
  }
  return std::nullopt;
}

/// How far a support moves a component in all, and on what.
std::string movement_text(const Problem& problem, size_t support, const Contradiction& c) {
  const HeldComponent h = path(problem, support, problem.mesh->placed[c.node], c.direction);
  std::ostringstream text;
  text << "by " << h.position(1.0) - h.base << " mm";
  if (problem.supports[support].turn) text << " (on a circle)";
  return text.str();
}

std::string explain(const Problem& problem, const Contradiction& c) {
  const Support &first = problem.supports[c.first], &second = problem.supports[c.second];
  const Vec3& at = problem.mesh->placed[c.node];
  const char direction = "xyz"[c.direction];
  const bool other_loads = !(first.path == second.path);
  std::ostringstream text;
  text << "contradicts support \"" << first.name << "\": both hold the node at (" << at[0] << ", " << at[1] << ", "
       << at[2] << ") mm in " << direction << ", but \"" << second.name << "\" moves it "
       << movement_text(problem, c.second, c) << " and \"" << first.name << "\" " << movement_text(problem, c.first, c)
       << (other_loads ? ", at other loads" : "") << "; give both the same movement"
       << (other_loads ? ", loads and shares" : "") << " in " << direction << ", or hold it by one of them only";
  return text.str();
}

bool turn_alike(const Support& a, const Support& b) {
  if (!a.turn || !b.turn) return !a.turn && !b.turn;
  return (a.turn->axis - b.turn->axis).norm() < 1e-9 && a.turn->angle == b.turn->angle && a.path == b.path;
}

/// Refuses two clamps of one node of which one turns its director and the other does not do the same.
void check_directors(const Problem& problem, const std::set<std::string>& released, const base::List& supports) {
  std::vector<int> holder(problem.mesh->nodes(), -1);
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    if (support.director != DirectorSupport::held || released.count(support.name)) continue;
    for (const int node : support.nodes) {
      const int other = holder[node];
      if (other >= 0 && !turn_alike(problem.supports[other], support))
        supports.entries()[s].fail("director", "contradicts support \"" + problem.supports[other].name +
                                                   "\": both hold directors of the same nodes, but turn them "
                                                   "differently; hold them by one of the supports only");
      holder[node] = static_cast<int>(s);
    }
  }
}

void check_released(const base::List& stage, const base::Texts& names) {
  for (const std::string& name : stage.words("release")) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string near = base::nearest_name(name, names);
    std::string all;
    for (const std::string& n : names) all += (all.empty() ? "" : ", ") + n;
    stage.fail("release", "no support is named \"" + name + "\"" +
                              (near.empty() ? "." : "; did you mean \"" + near + "\"?") +
                              (all.empty() ? " The scene has no supports" : " Valid here: " + all));
  }
}

}  // namespace

void check_supports(const base::List* supports, const base::List& stages, const Problem& problem) {
  base::Texts names;
  for (const Support& support : problem.supports) names.push_back(support.name);
  std::set<std::string> released;
  for (const base::List& stage : stages.entries()) {
    check_released(stage, names);
    released.insert(stage.words("release").begin(), stage.words("release").end());
    if (const auto found = contradiction(problem, released))
      supports->entries()[found->second].fail(problem.supports[found->second].turn ? "turn by" : "move by",
                                              explain(problem, *found));
    if (supports != nullptr) check_directors(problem, released, *supports);
  }
}

}  // namespace toile::solve
