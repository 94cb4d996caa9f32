#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include "equilibrium/held.hpp"
#include "toile/solve/spec.hpp"

namespace toile::solve {

namespace {

std::string direction_text(const Vec3& direction) {
  for (Eigen::Index i = 0; i < 3; ++i)
    if (direction == Vec3::Unit(i)) return std::string("in ") + "xyz"[i];
  std::ostringstream text;
  text << "along (" << direction[0] << ", " << direction[1] << ", " << direction[2] << ")";
  return text.str();
}

std::string explain(const Problem& problem, const Contradiction& c) {
  const Support &first = problem.supports[c.first], &second = problem.supports[c.second];
  const Vec3& at = problem.mesh->placed[c.node];
  const std::string direction = direction_text(c.direction);
  std::ostringstream text;
  text << "contradicts support \"" << first.name << "\": both hold the node at (" << at[0] << ", " << at[1] << ", "
       << at[2] << ") mm ";
  if (c.nearly_parallel) {
    text << "along nearly the same direction, (" << c.direction[0] << ", " << c.direction[1] << ", " << c.direction[2]
         << ") of \"" << second.name << "\"; hold it along one of them only";
    return text.str();
  }
  const auto moves = [](const Support& support, double by) {
    std::ostringstream part;
    part << "by " << by << " mm" << (support.turn ? " (on a circle)" : "");
    return part.str();
  };
  const bool other_loads = !(first.path == second.path);
  text << direction << ", but \"" << second.name << "\" moves it " << moves(second, c.second_moves) << " and \""
       << first.name << "\" " << moves(first, c.first_moves) << (other_loads ? ", at other loads" : "")
       << "; give both the same movement" << (other_loads ? ", loads and shares" : "") << " " << direction
       << ", or hold it by one of them only";
  return text.str();
}

/// The parameter of the second support that is to be changed.
const char* parameter_of(const Problem& problem, const Contradiction& c) {
  const Support& support = problem.supports[c.second];
  if (c.nearly_parallel) return "hold";
  return support.turn ? "turn by" : support.axes.empty() ? "move by" : "move along";
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

}  // namespace

void check_released(const base::List& stages, const base::Texts& supports) {
  for (const base::List& stage : stages.entries())
    for (const std::string& name : stage.words("release"))
      if (std::find(supports.begin(), supports.end(), name) == supports.end())
        stage.fail("release", "no support is named \"" + name + "\"" +
                                  (supports.empty() ? ". The scene has no supports" : base::hint(name, supports)));
}

void check_supports(const base::List* supports, const base::List& stages, const Problem& problem) {
  std::set<std::string> released;
  for (const base::List& stage : stages.entries()) {
    released.insert(stage.words("release").begin(), stage.words("release").end());
    Held held;
    if (const auto found = hold_positions(problem, released, held))
      supports->entries()[found->second].fail(parameter_of(problem, *found), explain(problem, *found));
    if (supports != nullptr) check_directors(problem, released, *supports);
  }
}

}  // namespace toile::solve
