#include "start_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "read_output.hpp"
#include "start_text.hpp"
#include "toile/base/units.hpp"
#include "toile/crossing/crossings.hpp"
#include "toile/mesh/find_nodes.hpp"
#include "toile/solve/fields.hpp"

namespace toile::scene {

namespace {

using Texts = std::vector<std::string>;

constexpr double most_stretch = 3.0, least_stretch = 0.5;

std::string quoted(const std::string& name) {
  return "\"" + name + "\"";
}

bool is_usual(double stretch) {
  return stretch > least_stretch && stretch < most_stretch;
}

/// The unit in which wale and course would both be stretched as fabrics are; empty: none.
std::string unit_cause(double wale, double course) {
  struct Unit {
    const char* name;
    double mm;
  };
  for (const Unit& unit : {Unit{"centimetres", 10.0}, Unit{"inches", 25.4}, Unit{"metres", 1000.0}}) {
    if (is_usual(wale / unit.mm) && is_usual(course / unit.mm))
      return std::string("as if the pattern were in ") + unit.name +
             " (all lengths are in mm: " + short_number(unit.mm) + " times larger, it would be stretched to " +
             short_number(wale / unit.mm) + " and " + short_number(course / unit.mm) + ")";
    if (is_usual(wale * unit.mm) && is_usual(course * unit.mm))
      return std::string("as if the place or the body were in ") + unit.name + " (all lengths are in mm)";
  }
  return "compare the pattern's width and height with the place that its \"Placement\" gives it (\"coverage\" of the "
         "girth, \"from\", \"to\")";
}

Texts crossing_text(const garment::Seam& seam, const SeamStart& start) {
  return {"the way from " + seam.first + " to " + seam.second + " leads through the body (" +
          short_number(start.depth) + " mm deep, gap " + short_number(start.mean_gap) + " mm)"};
}

/// Whether the other order of the edges is the one that is meant.
bool is_against(const SeamStart& start) {
  constexpr double clear = 1.2;  // of at most 2
  return start.crosses_corner || start.other_gap < 0.5 * start.mean_gap ||
         (start.likeness < start.other_likeness - clear && start.other_gap < start.mean_gap);
}

std::string against_text(const garment::Seam& seam, const SeamStart& start, bool reversed) {
  return "the seam " + quoted(seam.name) + " runs against itself: sewn like this the nodes of " + seam.first + " and " +
         seam.second + " lie " + short_number(start.mean_gap) + " mm apart on average (at most " +
         short_number(start.largest_gap) + "), from the other end " + short_number(start.other_gap) +
         " mm, and the fabric would be twisted (a Moebius band). " +
         (reversed ? "Leave \"reversed\" out" : "Give the seam \"reversed\" = true");
}

/// Between which heights along a unit direction from a point the garment starts, mm.
std::array<double, 2> start_heights(const Scene& scene, const solve::Vec3& point, const solve::Vec3& direction) {
  std::array<double, 2> heights = {HUGE_VAL, -HUGE_VAL};
  for (const solve::Vec3& at : scene.start().position) {
    const double height = (at - point).dot(direction);
    heights = {std::min(heights[0], height), std::max(heights[1], height)};
  }
  return heights;
}

}  // namespace

Texts stretch_warnings(const PanelStart& panel) {
  if (panel.placed_is_stress_free) return {};
  const bool much = panel.major.largest > most_stretch, little = panel.minor.smallest < least_stretch;
  if (!much && !little) return {};
  const bool all = !is_usual(panel.wale.mean) || !is_usual(panel.course.mean);
  std::string text = "panel " + quoted(panel.name) + " starts ";
  if (all)
    text += "stretched to " + short_number(panel.wale.mean) + " along the wale and " + short_number(panel.course.mean) +
            " along the course (means), where knits stand " + short_number(least_stretch) + " to " +
            short_number(most_stretch) + ": " + unit_cause(panel.wale.mean, panel.course.mean);
  else if (much)
    text += "stretched to " + short_number(panel.major.largest) + " at " + place_text(panel.major.at_largest) +
            ", more than knits stand: look at the panel there, at its seams and at its place";
  else
    text += "pressed together to " + short_number(panel.minor.smallest) + " at " + place_text(panel.minor.at_smallest) +
            ": look at the panel there, and at its place";
  return {text};
}

Texts scale_warnings(const body::BodyFindings& body, const std::vector<PanelStart>& panels) {
  if (!body.person) return {};
  std::string text = "the list \"Body\" has \"scale\" = " + short_number(body.scale) + ", which makes the body " +
                     short_number(body.height) + " mm high; in " + body.person->name +
                     " (\"scale\" = " + short_number(body.person->scale) + ") it would be " +
                     short_number(body.person->height) + " mm high, as a person is";
  const auto round = std::find_if(panels.begin(), panels.end(), [](const auto& panel) { return panel.round; });
  if (round != panels.end())
    text += ", and panel " + quoted(round->name) + " would be stretched round it to " +
            short_number(round->round->mean * body.person->scale / body.scale) + " instead of " +
            short_number(round->round->mean);
  return {text +
          ". A wrong unit makes all pressures wrong. If the file holds only a part of a body, give its "
          "\"height range\", which ends this warning"};
}

Texts beyond_warnings(const Scene& scene) {
  constexpr double little = 1.0;  // mm
  const auto& known = scene.body().known_heights;
  if (!known) return {};
  const auto [lower, upper] = start_heights(scene, solve::Vec3::Zero(), solve::Vec3::UnitZ());
  if (lower >= (*known)[0] - little && upper <= (*known)[1] + little) return {};
  return {"the body is given from z = " + short_number((*known)[0]) + " to " + short_number((*known)[1]) +
          " mm, and the garment starts between " + short_number(lower) + " and " + short_number(upper) +
          " mm: beyond its levels the body goes on straight, which nobody measured"};
}

Texts girth_warnings(const std::vector<PanelStart>& panels) {
  constexpr double wider = 0.9999;
  double largest = 0.0;
  std::string names;
  for (const PanelStart& panel : panels) {
    if (!panel.round) continue;
    largest = std::max(largest, panel.round->largest);
    names += (names.empty() ? "" : ", ") + quoted(panel.name);
  }
  if (names.empty() || largest >= wider) return {};
  return {"the garment is wider than its body: round the body " + names + " is stretched to " + short_number(largest) +
          " at most, so it hangs loose and presses nowhere, unless a stretch along the limb draws it in. Make the "
          "pattern narrower, or look for a unit or a "
          "\"scale\" that is wrong"};
}

Texts pressure_warnings(const std::vector<PanelStart>& panels) {
  constexpr double most = 200.0, least_usual = 0.5;  // mmHg
  const PanelStart* worst = nullptr;
  for (const PanelStart& panel : panels)
    if (panel.high_pressure && (worst == nullptr || *panel.high_pressure > *worst->high_pressure)) worst = &panel;
  if (worst == nullptr) return {};
  const double mmhg = base::kpa_to_mmhg(base::mpa_to_kpa(*worst->high_pressure));
  if (mmhg <= most) return {};
  const bool is_kpa = mmhg / 1000.0 > least_usual && mmhg / 1000.0 < most && worst->major.largest < most_stretch;
  return {"panel " + quoted(worst->name) + " would press with about " + short_number(mmhg) +
          " mmHg where it starts; no garment reaches " + short_number(most) + " mmHg" +
          (is_kpa ? ": a modulus in kPa? Moduli and stresses are in MPa, 1000 times less (it would be " +
                        short_number(mmhg / 1000.0) + " mmHg)"
                  : ": look at the stretches of the start, at the moduli (MPa) and at the thickness (mm)")};
}

Texts depth_warnings(const PanelStart& panel) {
  if (panel.depth <= panel.size) return {};
  return {"panel " + quoted(panel.name) + " starts " + short_number(panel.depth) + " mm inside the body, deepest at " +
          place_text(panel.deepest) + " (" + std::to_string(panel.inside) +
          " nodes): contact brings each node out on the side that is nearest to it. Place the panel outside"};
}

Texts size_warnings(const base::List& list, const std::vector<PanelStart>& panels) {
  constexpr double much = 3.0;
  Texts texts;
  for (const base::List& entry : list.list("Panels").entries()) {
    const auto panel =
        std::find_if(panels.begin(), panels.end(), [&](const auto& p) { return p.name == entry.name(); });
    if (panel == panels.end() || !entry.given("element size")) continue;
    const double wanted = entry.real("element size");
    if (wanted > much * panel->size)
      texts.push_back("panel " + quoted(panel->name) + ": \"element size\" = " + short_number(wanted) +
                      " mm is wider than the panel allows; its elements are " + short_number(panel->size) +
                      " mm wide, the fewest that its outline takes. Such a mesh is too coarse for a pressure: take "
                      "elements of a tenth of the panel's width or less");
  }
  return texts;
}

Texts level_warnings(const Scene& scene) {
  constexpr double around = 0.25;  // of the garment's height, by which it may move
  const Output& output = scene.output();
  if (output.bent_axis) return {};
  const auto [lower, upper] = start_heights(scene, output.axis_point, output.axis_direction.normalized());
  const double margin = around * (upper - lower);
  Texts texts;
  for (const Level& level : output.levels)
    if (level.height < lower - margin || level.height > upper + margin)
      texts.push_back("level " + quoted(level.name) + " is at a height of " + short_number(level.height) +
                      " mm, and the garment starts between " + short_number(lower) + " and " + short_number(upper) +
                      " mm: nothing will be found there");
  return texts;
}

Texts place_warnings(const base::List& list, const mesh::Mesh& mesh) {
  constexpr double of_part = 0.01, of_place = 0.1;  // of its length; mm
  Texts texts;
  const auto look = [&](const base::List& entry, const char* what, const std::string& name) {
    const mesh::FoundNodes found = mesh::find_nodes(mesh, name);
    if (found.nodes.empty() || found.off == 0.0) return;
    const bool is_part = found.nodes.size() > 1;
    if (found.off <= (is_part ? of_part * mesh::arc_lengths(mesh, found.nodes).back() : of_place)) return;
    texts.push_back(std::string(what) + " " + quoted(entry.name()) + ": " + name +
                    (is_part ? " ends between nodes, " : " lies between nodes, ") + short_number(found.off) +
                    " mm from the nearest, which is taken. Smaller elements make that less; on a panel that is meshed "
                    "freely, a notch in its pattern makes a node");
  };
  for (const base::List& support : entries_of(list, "Supports"))
    for (const std::string& name : support.words("on")) look(support, "support", name);
  for (const base::List& load : entries_of(list, "Loads"))
    if (load.word("type") == "point") look(load, "load", load.word("on"));
  for (const base::List& seam : entries_of(list, "Seams"))
    for (const char* side : {"first", "second"}) look(seam, "seam", seam.word(side));
  return texts;
}

Texts fit_warnings(const Scene& scene) {
  Texts texts;
  for (const solve::BlockModel& model : scene.problem().models) {
    std::string names;
    for (const std::string& name : model.material->fit_limits().undetermined)
      names += (names.empty() ? "" : ", ") + name;
    const std::string text = "fabric " + quoted(model.material->name()) + ": the data of its fit did not determine " +
                             names + ": pressures that depend on " + (names.find(',') < names.size() ? "them" : "it") +
                             " are not to be trusted";
    if (!names.empty() && std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
  }
  return texts;
}

Texts weight_warnings(const base::List& list) {
  constexpr double least = 5.0, most = 2000.0;  // g/m^2: a stocking of 8 den has 10, a winter coat 800
  Texts texts;
  if (!list.has_list("Loads")) return texts;
  for (const base::List& load : list.list("Loads").entries()) {
    if (load.word("type") != "weight") continue;
    const double density = load.real("area density");
    if (density < least || density > most)
      texts.push_back("load " + quoted(load.name()) + ": \"area density\" = " + short_number(density) +
                      " g/m^2 is no fabric's; knits have 10 to 500. Is it in another unit (1 kg/m^2 is 1000 g/m^2)?");
  }
  return texts;
}

Texts loose_warnings(const std::vector<LoosePart>& parts, bool sewn) {
  Texts texts;
  for (const LoosePart& part : parts)
    if (std::isinf(part.gap))
      texts.push_back("nothing holds " + part.panels + ": no support and no body");
    else if (sewn)
      texts.push_back("nothing holds " + part.panels + ": no support, and it starts " + short_number(part.gap) +
                      " mm or more from the body");
  return texts;
}

Texts seam_warnings(const garment::Seam& seam, const SeamStart& start) {
  constexpr double nearer = 0.8;
  if (start.through_body)
    return {"seam " + quoted(seam.name) + ": " + crossing_text(seam, start).front() +
            "; give the panels more \"coverage\", or sew the edges that face each other"};
  if (start.other_gap < nearer * start.mean_gap)
    return {"seam " + quoted(seam.name) + ": sewn from its other end its nodes would be nearer to each other (" +
            short_number(start.other_gap) + " instead of " + short_number(start.mean_gap) +
            " mm on average); is \"reversed\" right?"};
  return {};
}

Texts forgotten_seam_warnings(const Scene& scene) {
  Texts texts;
  for (const FacingEdges& edges : unsewn_facing_edges(scene))
    texts.push_back(edges.first + " and " + edges.second + " face each other on the body, " + short_number(edges.gap) +
                    " mm apart, and are not sewn: is a seam forgotten?");
  return texts;
}

Texts crossing_warnings(const Scene& scene, const solve::Fields& fields) {
  if (fields.crossings.panels.empty()) return {};
  return {"the fabric starts passed through fabric: " + text_of(fields.crossings, *scene.problem().mesh) +
          ". Nothing will bring it out: fabric is in contact with the body only. Place the panels so that none is in "
          "the way of another"};
}

Texts seam_errors(const Scene& scene, const base::List& list, const std::vector<SeamStart>& seams) {
  Texts errors;
  if (seams.empty()) return errors;
  const std::vector<base::List> entries = list.list("Seams").entries();
  const std::vector<garment::Seam>& all = scene.garment().seams;
  for (size_t s = 0; s < seams.size(); ++s) {
    if (!seams[s].nearest_edge.empty())
      errors.push_back(
          message_of(entries[s], "second",
                     crossing_text(all[s], seams[s]).front() + ", and " + seams[s].nearest_edge +
                         " is much nearer to " + all[s].first + " (" + short_number(seams[s].nearest_gap) +
                         " mm): sew the edges that face each other, or turn a panel round the body (\"angle\" of "
                         "its placement)"));
    else if (is_against(seams[s]))
      errors.push_back(message_of(entries[s], "reversed", against_text(all[s], seams[s], entries[s].flag("reversed"))));
  }
  const int moebius = errors.empty() ? moebius_seam(scene) : -1;
  if (moebius >= 0)
    errors.push_back(
        message_of(entries[moebius], "reversed",
                   "with the seams before it, the seam " + quoted(all[moebius].name) +
                       " makes a Moebius band: it sews the right side of the fabric to its wrong side. One "
                       "of these seams must be sewn from its other end"));
  return errors;
}

}  // namespace toile::scene
