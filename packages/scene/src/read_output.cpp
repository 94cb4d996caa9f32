#include "read_output.hpp"

#include <algorithm>
#include <cmath>

#include "pressure_line.hpp"
#include "tester_kind.hpp"
#include "toile/base/error.hpp"
#include "toile/crossing/crossings.hpp"
#include "toile/garment/bent_axis.hpp"
#include "toile/mesh/find_nodes.hpp"

namespace toile::scene {

namespace {

constexpr const char* no_body = "the scene has no list \"Body\", so there is no pressure";

solve::Vec3 vector_of(const base::List& list, const std::string& name) {
  const base::Reals& v = list.reals(name);
  if (v.size() != 3) list.fail(name, "found " + std::to_string(v.size()) + " numbers, expected 3 (x, y, z)");
  return solve::Vec3(v[0], v[1], v[2]);
}

std::string unknown(const std::string& kind, const std::string& name, const base::Texts& valid) {
  return "no " + kind + " is named \"" + name + "\"" + base::hint(name, valid);
}

Point read_point(const base::List& entry, const mesh::Mesh& mesh) {
  const mesh::FoundNodes found = mesh::find_nodes(mesh, entry.word("on"));
  if (!found.problem.empty()) entry.fail("on", found.problem);
  if (found.nodes.size() != 1)
    entry.fail("on", "\"" + entry.word("on") + "\" has " + std::to_string(found.nodes.size()) +
                         " nodes; name one by a corner or a place, for instance \"" + entry.word("on") + "@0.5\"");
  return {entry.name(), found.nodes.front()};
}

const base::Texts drape_quantities = {"drape coefficient", "folds"};
const base::Texts plain_quantities = {"largest pressure",  "smallest principal stress", "force balance",
                                      "largest gap",       "dissipation ratio",         "extrapolated elements",
                                      drape_quantities[0], drape_quantities[1]};
const std::string at_level = "pressure at level ", ratio_of = "ratio of levels ", class_of_b = "compression class",
                  class_at = class_of_b + " at level ";

bool is_one_of(const base::Texts& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Whether a section's title names a level: "C" and "C (2)" do.
bool is_level(const std::string& title, const Output& output) {
  return std::any_of(output.levels.begin(), output.levels.end(),
                     [&](const Level& level) { return title == level.name || title.find(level.name + " (") == 0; });
}

/// The titles in "<title> to <title>", of levels if they can be.
std::vector<std::string> two_titles(const base::List& entry, const std::string& text, const Output& output) {
  const std::string word = " to ";
  std::vector<std::string> titles;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    titles = {text.substr(0, at), text.substr(at + word.size())};
    if (is_level(titles[0], output) && is_level(titles[1], output)) break;
  }
  if (titles.empty()) entry.fail("quantity", "names one level; allowed is \"" + ratio_of + "<level> to <level>\"");
  return titles;
}

/// Titles of the sections in a quantity of levels; none for another quantity.
std::vector<std::string> sections_of(const base::List& entry, const Output& output) {
  const std::string& quantity = entry.word("quantity");
  std::vector<std::string> titles;
  if (quantity.find(at_level) == 0) {
    titles = {quantity.substr(at_level.size())};
  } else if (quantity == class_of_b) {
    titles = {"B"};
  } else if (quantity.find(class_at) == 0) {
    titles = {quantity.substr(class_at.size())};
  } else if (quantity.find(ratio_of) == 0) {
    titles = two_titles(entry, quantity.substr(ratio_of.size()), output);
  } else if (!is_one_of(plain_quantities, quantity)) {
    base::Texts valid = plain_quantities;
    valid.insert(valid.end(),
                 {at_level + "<level>", ratio_of + "<level> to <level>", class_of_b, class_at + "<level>"});
    entry.fail("quantity", "is not a quantity that can be checked" + base::hint(quantity, valid));
  }
  base::Texts valid;
  for (const Level& level : output.levels) valid.push_back(level.name);
  for (const std::string& title : titles)
    if (!is_level(title, output)) entry.fail("quantity", unknown("level", title, valid));
  return titles;
}

/// The class that a check of one asks for; none for another quantity.
std::optional<CompressionClass> compression_of(const base::List& entry) {
  const bool of_class = entry.word("quantity").find(class_of_b) == 0;
  const std::vector<std::string> others =
      of_class ? std::vector<std::string>{"lower", "upper"} : std::vector<std::string>{"standard", "class"};
  for (const std::string& other : others)
    if (entry.given(other))
      entry.fail(other, "does not go with the quantity \"" + entry.word("quantity") + "\"" +
                            (of_class ? ", whose limits are those of its class" : ""));
  if (!of_class) return std::nullopt;
  base::Texts valid;
  for (const CompressionClass& c : compression_classes(entry.word("standard"))) {
    if (c.name == entry.word("class")) return c;
    valid.push_back(c.name);
  }
  entry.fail("class", unknown("class of " + entry.word("standard"), entry.word("class"), valid));
}

bool moves_as_one(const solve::Support& support) {
  constexpr double same = 1e-9;  // mm
  for (size_t n = 1; n < support.nodes.size(); ++n)
    if ((support.motion(n) - support.motion(0)).norm() > same) return false;
  return true;
}

ForceCurve read_force_curve(const base::List& entry, const base::Texts& supports) {
  const auto at = std::find(supports.begin(), supports.end(), existing(entry, "support", supports));
  return {entry.name(), static_cast<int>(at - supports.begin()), entry.real("length")};
}

void check_direction(const base::List& entry, const solve::Support& support) {
  if (support.turn)
    entry.fail("support",
               "this support turns, and its torque is in torques.csv; force curves are of supports that \"move by\" "
               "only");
  if (!moves_as_one(support))
    entry.fail("support",
               "its nodes move in different directions, along the limb; a force curve has one direction. Give the "
               "support \"hold\" = \"direction\"");
}

bool has_drapemeter(const base::List& scene) {
  return scene.has_list("Output") && scene.list("Output").has_list("Drapemeter");
}

}  // namespace

std::vector<base::List> entries_of(const base::List& list, const std::string& name) {
  return list.has_list(name) ? list.list(name).entries() : std::vector<base::List>();
}

base::Texts names_of(const base::List& list, const std::string& name) {
  base::Texts names;
  for (const base::List& entry : entries_of(list, name)) names.push_back(entry.name());
  return names;
}

mesh::EdgePlace place_on_edge(const base::List& list, const mesh::Mesh& mesh, const std::string& parameter) {
  const std::string& name = list.word(parameter);
  const auto edge = mesh.edges.find(name);
  if (edge == mesh.edges.end()) {
    base::Texts valid;
    for (const auto& [key, nodes] : mesh.edges) valid.push_back(key);
    list.fail(parameter, unknown("edge", name, valid));
  }
  return mesh::edge_place(mesh, edge->second, list.real(parameter + " at"));
}

Output read_output(const base::List& scene) {
  const base::List list = scene.list("Output");
  const bool with_body = scene.has_list("Body");
  Output out;
  out.axis_point = vector_of(list, "axis point");
  out.axis_direction = vector_of(list, "axis direction");
  if (out.axis_direction.norm() == 0.0) list.fail("axis direction", "must not be zero");
  if (list.given("axis")) {
    for (const char* other : {"axis point", "axis direction"})
      if (list.given(other)) list.fail(other, "goes with a straight axis; give it or \"axis\", not both");
    if (list.has_list("Drapemeter"))
      list.fail("axis", "does not go with the list \"Drapemeter\", whose light falls along a straight one");
    out.bent_axis = garment::read_bent_axis(list);
  } else if (list.given("smoothing")) {
    list.fail("smoothing", "rounds the corners of \"axis\", which is not given");
  }
  out.stations = list.integer("stations");
  if (out.stations == 1) list.fail("stations", "a curve needs at least 2 points; 0: no curve");
  if (!with_body && out.stations > 0) list.fail("stations", no_body);
  if (list.given("body size")) out.body_size = list.real("body size");
  out.crossings = list.flag("crossings");
  if (out.crossings && list.given("crossings") && !crossing::available())
    list.fail("crossings", "needs CGAL, and this program was built without it (configured with TOILE_ENABLE_BODY=OFF)");
  for (const base::List& entry : entries_of(list, "Levels")) {
    if (!with_body) entry.fail("height", no_body);
    out.levels.push_back({entry.name(), entry.real("height")});
  }
  const TesterPlaces places = {names_of(scene, "Supports"), names_of(list, "Levels")};
  for (const base::List& entry : entries_of(list, "Force curves"))
    out.force_curves.push_back(read_force_curve(entry, places.supports));
  for (const base::List& entry : entries_of(list, "Testers")) out.testers.push_back(read_tester(entry, places));
  return out;
}

void find_places(const base::List& list, const solve::Problem& problem, Output& output) {
  try {
    if (problem.surface != nullptr) problem.surface->triangles(output.body_size.value_or(formula_body_size));
  } catch (const base::InputError& error) {
    list.fail("body size", error.what());
  }
  for (size_t c = 0; c < output.force_curves.size(); ++c)
    check_direction(list.list("Force curves").entries()[c],
                    problem.supports[static_cast<size_t>(output.force_curves[c].support)]);
  for (const base::List& entry : entries_of(list, "Distances"))
    output.distances.push_back(
        {entry.name(), place_on_edge(entry, *problem.mesh, "first"), place_on_edge(entry, *problem.mesh, "second")});
  for (const base::List& entry : entries_of(list, "Points")) output.points.push_back(read_point(entry, *problem.mesh));
  for (const base::List& entry : entries_of(list, "Body points"))
    output.body_points.push_back(place_on_body(entry, "at", vector_of(entry, "at"), problem.surface));
  if (list.has_list("Lines")) output.lines = read_lines(list.list("Lines"), problem.surface, output);
  if (list.has_list("Drapemeter"))
    output.drapemeter =
        read_drapemeter(list.list("Drapemeter"), *problem.mesh, {output.axis_point, output.axis_direction});
}

std::vector<Check> read_checks(const base::List& scene, const Output& output) {
  std::vector<Check> checks;
  for (const base::List& entry : entries_of(scene, "Checks")) {
    Check check{entry.name(), entry.word("quantity"), entry.real("lower"), entry.real("upper")};
    if (check.lower > check.upper) entry.fail("lower", "must not be above \"upper\"");
    check.sections = sections_of(entry, output);
    check.compression = compression_of(entry);
    if (!check.compression && !entry.given("lower") && !entry.given("upper"))
      entry.fail("lower", "is missing, and \"upper\" too: a check without a bound always holds");
    const bool of_contact = check.quantity == "largest pressure" || check.quantity == "largest gap";
    if (!scene.has_list("Body") && (of_contact || !check.sections.empty())) entry.fail("quantity", no_body);
    if (is_one_of(drape_quantities, check.quantity) && !has_drapemeter(scene))
      entry.fail("quantity", "needs the list \"Output > Drapemeter\"");
    checks.push_back(check);
  }
  return checks;
}

Accuracy read_accuracy(const base::List& scene) {
  const base::List list = scene.list("Accuracy");
  if (!scene.has_list("Body")) list.fail("error", no_body);
  base::Texts levels, all;
  if (scene.has_list("Output")) {
    const base::List output = scene.list("Output");
    all = levels = names_of(output, "Levels");
    for (const char* points : {"Points", "Body points"})
      for (const std::string& name : names_of(output, points)) all.push_back(name);
  }
  if (all.empty())
    list.fail("at",
              "the list \"Output\" names no level, point or body point, so there is no pressure whose error counts");
  Accuracy accuracy{0.01 * list.real("error"), list.words("at"), list.integer("most runs"), list.integer("most nodes")};
  for (const std::string& name : accuracy.at)
    if (!is_one_of(all, name)) list.fail("at", unknown("level, point or body point", name, all));
  if (accuracy.at.empty()) accuracy.at = levels.empty() ? all : levels;
  return accuracy;
}

}  // namespace toile::scene
