#include "toile/garment/panel.hpp"

#include <algorithm>
#include <cmath>

#include "imperfection.hpp"
#include "mesher.hpp"
#include "placement.hpp"
#include "shape.hpp"
#include "toile/base/error.hpp"
#include "zones.hpp"

namespace toile::garment {
namespace {

base::Spec panel_spec() {
  base::Spec spec("panel", "One flat piece of fabric. Its pattern is the stress-free state.");
  spec.word("material", "Name of an entry of the list Materials.")
      .real("wale angle", "deg", "Angle from the pattern's x axis to the fabric's wale direction.", 90.0)
      .choice("elements", "Kind of elements.", {"quadrilateral", "triangle"}, std::string("quadrilateral"))
      .words("over",
             "Names of panels that this one lies over: a bandage's second layer, a band on a stocking. It lies on the "
             "body further out by what is beneath it, each panel as thick as it is at present on the mean, of panels "
             "beside each other the highest; what presses it goes through those beneath, which do not feel it. Panels "
             "that name none lie on the body itself.",
             base::Texts())
      .list(placement_spec())
      .list(imperfection_spec())
      .list(zones_spec())
      .list(shell_spec());
  std::vector<base::Spec> variants;
  for (const Shape& shape : shapes()) variants.push_back(shape.spec);
  spec.variant("shape", "How the outline is described.", variants);
  variants.clear();
  for (const Mesher& mesher : meshers()) variants.push_back(mesher.spec);
  spec.variant("mesher", "How the panel is divided into elements.", variants, std::string("structured"));
  return spec;
}

Cut read_cut(const base::List& entry) {
  const std::string& wanted = entry.word("shape");
  const auto& all = shapes();
  const auto shape =
      std::find_if(all.begin(), all.end(), [&wanted](const Shape& s) { return s.spec.name() == wanted; });
  Cut cut = shape->cut(entry);
  cut.panel.name = entry.name();
  try {
    if (shape->drawn) pattern::check(cut.along_outline());
  } catch (const base::InputError& error) {
    entry.fail("shape", error.what());
  }
  add_borders(entry, cut);
  return cut;
}

/// Edges of all panels, and what the seams join, for plan_seeds.
class Seeding {
 public:
  Seeding(const std::vector<base::List>& entries, const std::vector<Cut>& cuts) : cuts_(cuts) {
    for (std::size_t p = 0; p < entries.size(); ++p) {
      first_.push_back(edges_.size());
      for (SeededEdge& edge : mesher_of(entries[p]).edges(entries[p], cuts[p])) {
        names_.push_back(edge.name);
        edge.name = cuts[p].panel.name + "." + edge.name;
        edges_.push_back(std::move(edge));
      }
    }
    first_.push_back(edges_.size());
  }

  /// A seam whose edges do not exist is left to build_seams, which tells what is valid.
  void add_seam(const base::List& entry) {
    const auto first = side(entry.word("first")), second = side(entry.word("second"));
    if (first && second) seams_.push_back({entry.name(), *first, *second, entry.flag("reversed")});
  }

  /// [panel] By edge.
  std::vector<std::map<std::string, Fractions>> seeds() const {
    const std::vector<Fractions> all = plan_seeds(edges_, free_seams());
    std::vector<std::map<std::string, Fractions>> by_panel(cuts_.size());
    for (std::size_t p = 0; p < cuts_.size(); ++p)
      for (std::size_t e = first_[p]; e < first_[p + 1]; ++e) by_panel[p][names_[e]] = all[e];
    return by_panel;
  }

 private:
  std::optional<SeededSeam::Side> side(const std::string& name) const {
    for (std::size_t p = 0; p < cuts_.size(); ++p) {
      const std::string start = cuts_[p].panel.name + ".";
      if (name.compare(0, start.size(), start) != 0) continue;
      try {
        const pattern::EdgePart part = pattern::find_part(cuts_[p].panel, name.substr(start.size()));
        for (std::size_t e = first_[p]; e < first_[p + 1]; ++e)
          if (names_[e] == part.edge->name) return SeededSeam::Side{e, part.from, part.to};
      } catch (const base::InputError&) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }
  /// Where both meshers leave no choice, build_seams compares what they made.
  std::vector<SeededSeam> free_seams() const {
    std::vector<SeededSeam> all;
    for (const SeededSeam& seam : seams_)
      if (edges_[seam.first.edge].dictated.empty() || edges_[seam.second.edge].dictated.empty()) all.push_back(seam);
    return all;
  }

  const std::vector<Cut>& cuts_;
  std::vector<SeededEdge> edges_;
  std::vector<std::string> names_;  ///< [edge] without its panel
  std::vector<std::size_t> first_;  ///< [panel] its first edge
  std::vector<SeededSeam> seams_;
};

}  // namespace

base::Spec panels_spec() {
  base::Spec spec(
      "Panels",
      "The pieces of fabric; the name of each entry is the name of the panel. Needed unless the list Pattern makes "
      "them all.");
  spec.entries(panel_spec(), 1);
  return spec;
}

std::vector<Panel> build_panels(const base::List& panels, const base::List* seams) {
  const std::vector<base::List> entries = panels.entries();
  std::vector<Cut> cuts;
  for (const base::List& entry : entries) cuts.push_back(read_cut(entry));
  Seeding seeding(entries, cuts);
  if (seams != nullptr)
    for (const base::List& seam : seams->entries()) seeding.add_seam(seam);
  const std::vector<std::map<std::string, Fractions>> seeds = seeding.seeds();
  std::vector<Panel> all;
  for (std::size_t p = 0; p < entries.size(); ++p) {
    Panel panel{entries[p].name(), read_fabrics(entries[p]), mesher_of(entries[p]).mesh(entries[p], cuts[p], seeds[p]),
                read_shell(entries[p]), cuts[p].panel.placement};
    divide_into_zones(entries[p], cuts[p], panel.mesh);
    all.push_back(std::move(panel));
  }
  return all;
}

}  // namespace toile::garment
