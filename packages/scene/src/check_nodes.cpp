#include "check_nodes.hpp"

#include "read_output.hpp"
#include "toile/mesh/find_nodes.hpp"

namespace toile::scene {

namespace {

void check(const base::List& entry, const std::string& on, const mesh::Mesh& mesh) {
  const mesh::FoundNodes found = mesh::find_nodes(mesh, on);
  if (!found.problem.empty()) entry.fail("on", found.problem);
}

}  // namespace

void check_nodes(const base::List& scene, const mesh::Mesh& mesh) {
  for (const base::List& support : entries_of(scene, "Supports"))
    for (const std::string& name : support.words("on")) check(support, name, mesh);
  if (!scene.has_list("Output")) return;
  for (const base::List& point : entries_of(scene.list("Output"), "Points")) {
    const std::string& on = point.word("on");
    check(point, on.substr(0, on.rfind('@')), mesh);
  }
  for (const base::List& distance : entries_of(scene.list("Output"), "Distances"))
    for (const char* end : {"first", "second"}) place_on_edge(distance, mesh, end);
}

}  // namespace toile::scene
