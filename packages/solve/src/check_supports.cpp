#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <sstream>

#include "toile/solve/spec.hpp"

namespace toile::solve {

namespace {

/// Two supports that move the same component of the same node differently.
struct Contradiction {
  size_t first, second;
  int node, direction;
};

bool same_motion(const Support& a, const Support& b, int direction) {
  return a.displacement[direction] == b.displacement[direction] &&
         (a.displacement[direction] == 0.0 || a.path == b.path);
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
        if (other >= 0 && !same_motion(problem.supports[other], support, d))
          return Contradiction{static_cast<size_t>(other), s, node, d};
        other = static_cast<int>(s);
      }
  }
  return std::nullopt;
}

std::string explain(const Problem& problem, const Contradiction& c) {
  const Support &first = problem.supports[c.first], &second = problem.supports[c.second];
  const Vec3& at = problem.mesh->placed[c.node];
  const char direction = "xyz"[c.direction];
  const bool same_size = first.displacement[c.direction] == second.displacement[c.direction];
  std::ostringstream text;
  text << "contradicts support \"" << first.name << "\": both hold the node at (" << at[0] << ", " << at[1] << ", "
       << at[2] << ") mm in " << direction << ", but \"" << second.name << "\" moves it by "
       << second.displacement[c.direction] << " mm and \"" << first.name << "\" by " << first.displacement[c.direction]
       << " mm" << (same_size ? " at other loads" : "") << "; give both the same "
       << (same_size ? "loads and shares" : "displacement") << " in " << direction
       << ", or hold it by one of them only";
  return text.str();
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
      supports->entries()[found->second].fail("move by", explain(problem, *found));
  }
}

}  // namespace toile::solve
