#include "input/read.hpp"

#include <utility>

#include "toile/mesh/find_nodes.hpp"

namespace toile::solve {

std::vector<int> read_nodes(const base::List& list, const mesh::Mesh& mesh, const std::string& name) {
  mesh::FoundNodes found = mesh::find_nodes(mesh, name);
  if (!found.problem.empty()) list.fail("on", found.problem);
  return std::move(found.nodes);
}

Vec3 read_vector(const base::List& list, const std::string& name) {
  const base::Reals& v = list.reals(name);
  if (v.size() != 3) list.fail(name, "found " + std::to_string(v.size()) + " numbers, expected 3 (x, y, z)");
  return Vec3(v[0], v[1], v[2]);
}

}  // namespace toile::solve
