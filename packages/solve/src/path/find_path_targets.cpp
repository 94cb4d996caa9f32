#include "input/read.hpp"
#include "toile/solve/spec.hpp"

namespace toile::solve {

namespace {

int find_support(const base::List& until, const Problem& problem) {
  base::Texts names;
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    if (problem.supports[s].name == until.word("on")) return static_cast<int>(s);
    names.push_back(problem.supports[s].name);
  }
  until.fail("on", "no support is named \"" + until.word("on") + "\"" + base::hint(until.word("on"), names));
}

int find_node(const base::List& until, const Problem& problem) {
  const std::string& name = until.word("on");
  const std::vector<int> nodes = read_nodes(until, *problem.mesh, name);
  if (nodes.size() != 1)
    until.fail("on", "\"" + name + "\" has " + std::to_string(nodes.size()) +
                         " nodes; name one by a corner or a place, for instance \"" + name + "@0.5\"");
  return nodes.front();
}

}  // namespace

void find_path_targets(const base::List& list, const Problem& problem, std::vector<StageOptions>& stages) {
  const std::vector<base::List> entries = list.entries();
  for (size_t k = 0; k < stages.size(); ++k) {
    if (!stages[k].until) continue;
    const base::List until = entries[k].list("Until");
    PathTarget& target = *stages[k].until;
    if (target.volume && problem.pressures.empty())
      until.fail("quantity", "\"volume\" is swept by panels under pressure, and the list \"Loads\" has no pressure");
    if (target.volume) continue;
    if (target.support >= 0)
      target.support = find_support(until, problem);
    else
      target.node = find_node(until, problem);
  }
}

}  // namespace toile::solve
