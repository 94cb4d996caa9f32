#include "diagnosis/place.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace toile::solve {

namespace {

/// What is next to nothing beside the rest is printed as nothing.
double clean(double x, double scale) {
  return std::abs(x) < 1e-3 * scale ? 0.0 : x;
}

}  // namespace

std::string number_text(double x) {
  std::ostringstream out;
  out.precision(4);
  out << x;
  return out.str();
}

std::string place_text(const Vec3& position, const mesh::Vec2& pattern) {
  std::ostringstream out;
  out.precision(4);
  const auto rounded = [](double x) { return clean(x, 1.0); };  // mm
  out << "at (" << rounded(position[0]) << ", " << rounded(position[1]) << ", " << rounded(position[2])
      << ") mm, in the pattern at (" << rounded(pattern[0]) << ", " << rounded(pattern[1]) << ") mm";
  return out.str();
}

std::string panel_of(const Problem& problem, int node) {
  for (const mesh::MeshedPanel& panel : problem.mesh->panels)
    if (node >= panel.first && node < panel.first + panel.nodes) return panel.name;
  return {};
}

std::string node_text(const Problem& problem, const State& state, size_t cluster) {
  const std::vector<int>& members = problem.clusters[cluster];
  const int node = members.front();
  std::string text =
      "node " + std::to_string(node + 1) + " of panel \"" + panel_of(problem, node) + "\", " +
      place_text(node_position(problem, state, static_cast<int>(cluster), node), problem.mesh->pattern[node]);
  if (members.size() < 2) return text;
  if (!problem.seam.empty() && !problem.seam[cluster].empty())
    return text + ", on the seam \"" + problem.seam[cluster] + "\"";
  text += ", sewn to";
  for (size_t k = 1; k < members.size(); ++k)
    text += (k > 1 ? " and node " : " node ") + std::to_string(members[k] + 1) + " of panel \"" +
            panel_of(problem, members[k]) + "\"";
  return text;
}

std::string direction_text(const Vec3& direction) {
  std::ostringstream out;
  out.precision(3);
  out << "(" << clean(direction[0], 1.0) << ", " << clean(direction[1], 1.0) << ", " << clean(direction[2], 1.0) << ")";
  return out.str();
}

}  // namespace toile::solve
