#include "toile/garment/seam.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "toile/mesh/find_nodes.hpp"

namespace toile::garment {
namespace {

/// Nodes of one edge in the order of sewing, with their arc length in the pattern (mm).
struct Edge {
  std::string name;
  std::vector<int> nodes;
  std::vector<double> arc;

  double length() const { return arc.back(); }
  std::string text() const {
    std::ostringstream out;
    out << '"' << name << "\" (" << nodes.size() << " nodes, " << length() << " mm)";
    return out.str();
  }
};

[[noreturn]] void fail_edge(const base::List& entry, const std::string& parameter, const mesh::Mesh& mesh) {
  const std::string& name = entry.word(parameter);
  base::Texts valid;
  for (const auto& [edge, nodes] : mesh.edges) valid.push_back(edge);
  const mesh::FoundNodes found = mesh::find_nodes(mesh, name);
  if (found.nodes.size() == 1)
    entry.fail(parameter, "a seam joins edges, and this is a single node" + base::hint("", valid));
  if (name.find('[') != std::string::npos) entry.fail(parameter, found.problem);
  entry.fail(parameter, "there is no edge \"" + name + "\"" + base::hint(name, valid));
}

Edge read_edge(const base::List& entry, const std::string& parameter, const mesh::Mesh& mesh, bool backwards) {
  const std::string& name = entry.word(parameter);
  const bool is_part = name.find('[') != std::string::npos;
  if (!is_part && mesh.edges.count(name) == 0) fail_edge(entry, parameter, mesh);
  Edge edge{name, mesh::find_nodes(mesh, name).nodes, {}};
  if (edge.nodes.size() < 2) fail_edge(entry, parameter, mesh);
  if (backwards) std::reverse(edge.nodes.begin(), edge.nodes.end());
  edge.arc = mesh::arc_lengths(mesh, edge.nodes);
  return edge;
}

void check_match(const base::List& entry, const Edge& first, const Edge& second) {
  const std::string both = first.text() + " and " + second.text();
  if (first.name == second.name) entry.fail("second", "the edge \"" + first.name + "\" cannot be sewn to itself");
  if (first.nodes.size() != second.nodes.size()) {
    entry.fail("second", "a seam whose edges cannot match: " + both +
                             " have different numbers of nodes; give both panels the same number of elements there");
  }
  const double ease = entry.real("ease");
  std::ostringstream allowed;
  const double difference = std::abs(first.length() - second.length()) / std::max(first.length(), second.length());
  if (difference > ease) {
    allowed << "a seam whose edges cannot match: the lengths of " << both << " differ by more than " << 100.0 * ease
            << " % (parameter \"ease\"): by " << std::setprecision(3) << 100.0 * difference
            << " %. Is it the other edge that is sewn here, or are edges of a stitch missing in the pattern? If the "
               "longer one is to be gathered, give the seam a larger \"ease\"";
    entry.fail("second", allowed.str());
  }
  for (std::size_t k = 0; k < first.nodes.size(); ++k) {
    const double a = first.arc[k] / first.length();
    const double b = second.arc[k] / second.length();
    if (std::abs(a - b) <= ease) continue;
    allowed << "a seam whose edges cannot match: the nodes of " << both << " do not face each other (node " << k + 1
            << " lies at " << a << " and " << b << " of the length); give both panels the same grading";
    entry.fail("second", allowed.str());
  }
}

Seam build_seam(const base::List& entry, const mesh::Mesh& mesh) {
  const Edge first = read_edge(entry, "first", mesh, false);
  const Edge second = read_edge(entry, "second", mesh, entry.flag("reversed"));
  check_match(entry, first, second);
  Seam seam{entry.name(), first.name, second.name, {}, first.nodes, second.nodes};
  for (std::size_t k = 0; k < first.nodes.size(); ++k) {
    // Two edges of one panel may share a corner, which then needs no tie.
    if (first.nodes[k] != second.nodes[k]) seam.pairs.emplace_back(first.nodes[k], second.nodes[k]);
  }
  return seam;
}

}  // namespace

base::Spec seams_spec() {
  base::Spec entry("seam", "Two edges that are sewn together, node by node. A panel may be sewn to itself.");
  entry
      .word(
          "first",
          "Name of an edge (panel.bottom, panel.right, panel.top, panel.left, or that of an outline), or of a part of "
          "it: panel.left[0.25:end], panel.armhole[notch1:notch2], panel.left[30mm:90mm].")
      .word("second", "Name of the other edge.")
      .flag("reversed",
            "The second edge is sewn from its far end. Edges run from left to right and from bottom to top.", false)
      .real("ease", "",
            "Largest allowed difference of the two lengths in the pattern, as a fraction of the longer one.", 0.05,
            base::Range::between(0.0, 1.0));
  base::Spec spec("Seams", "The seams of the garment.");
  spec.entries(entry);
  return spec;
}

std::vector<Seam> build_seams(const base::List& seams, const mesh::Mesh& mesh) {
  std::vector<Seam> all;
  for (const base::List& entry : seams.entries()) all.push_back(build_seam(entry, mesh));
  return all;
}

}  // namespace toile::garment
