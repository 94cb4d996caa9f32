#include <algorithm>
#include <cmath>

#include "mesher.hpp"
#include "toile/base/error.hpp"
#include "toile/mesh/four_sided.hpp"

namespace toile::garment {
namespace {

/// More would take the memory of a large machine before the first step.
constexpr int most_elements_a_side = 10000;

base::Spec structured_spec() {
  return base::Spec("structured", "Rows of elements between four sides, which are called bottom, right, top and left.")
      .integer("elements across", "Number of elements from left to right.", base::required,
               base::Range::between(1, most_elements_a_side))
      .integer("elements along", "Number of elements from bottom to top.", base::required,
               base::Range::between(1, most_elements_a_side))
      .real("grading across", "",
            "Exponent g of the node spacing towards the left and right side: nodes at 1/2 (2t)^g from either end; "
            "1: uniform.",
            1.0, base::Range::at_least(1.0))
      .real("grading along", "", "The same towards the bottom and the top.", 1.0, base::Range::at_least(1.0));
}

mesh::GridOptions options_of(const base::List& panel) {
  mesh::GridOptions options;
  options.across = panel.integer("elements across");
  options.along = panel.integer("elements along");
  options.triangles = panel.word("elements") == "triangle";
  options.grading_across = panel.real("grading across");
  options.grading_along = panel.real("grading along");
  if (options.along > most_elements / options.across)
    panel.fail("elements along", "with \"elements across\" = " + std::to_string(options.across) +
                                     " the panel has more than " + std::to_string(most_elements) + " elements");
  return options;
}

/// The four sides, each in the direction in which places on it are counted.
mesh::FourSides sides_of(const base::List& panel, const Cut& cut) {
  const auto side = [&](const char* name) {
    const pattern::Edge* edge = cut.panel.edge(name);
    if (edge == nullptr || cut.panel.outline.size() != 4)
      panel.fail("mesher",
                 "\"structured\" needs an outline of four edges that are called bottom, right, top and left; "
                 "\"free\" takes any outline");
    return edge->curve;
  };
  if (!cut.panel.holes.empty() || !cut.panel.lines.empty())
    panel.fail("mesher", "\"structured\" knows no holes and no internal lines; \"free\" does");
  return {side("bottom"), side("right"), side("top"), side("left")};
}

std::vector<SeededEdge> structured_edges(const base::List& panel, const Cut& cut) {
  const mesh::GridOptions options = options_of(panel);
  std::vector<SeededEdge> all;
  for (const pattern::Edge& edge : cut.panel.outline) {
    const bool is_across = edge.name == "bottom" || edge.name == "top";
    const int count = is_across ? options.across : options.along;
    const double grading = is_across ? options.grading_across : options.grading_along;
    SeededEdge seeded{edge.name, edge.curve.length(), 0.0, {}, {}};
    seeded.size = seeded.length / count;
    for (int k = 0; k <= count; ++k) seeded.dictated.push_back(mesh::graded(static_cast<double>(k) / count, grading));
    all.push_back(std::move(seeded));
  }
  return all;
}

mesh::PanelMesh mesh_rows(const base::List& panel, const Cut& cut, const std::map<std::string, Fractions>&) {
  try {
    return mesh::panel_mesh(mesh::mesh_four_sided(panel.name(), sides_of(panel, cut), options_of(panel)));
  } catch (const base::InputError& error) {
    panel.fail("shape", error.what());
  }
}

}  // namespace

Mesher structured_mesher() {
  return {structured_spec(), structured_edges, mesh_rows};
}

}  // namespace toile::garment
