#include "toile/garment/pattern.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "pattern_file.hpp"
#include "placement.hpp"
#include "toile/base/error.hpp"
#include "toile/garment/shell.hpp"

namespace toile::garment {
namespace {

using Teuchos::ParameterList;

/// Fills what entries of "Panels" and "Seams" leave open.
class Filling {
 public:
  Filling(ParameterList& scene, base::Origins& origins, const base::List& options)
      : scene_(scene), origins_(origins), options_(options), file_(path_of_pattern(options)) {}

  void add(const pattern::Panel& panel) {
    if (!is_open("Panels", panel.name)) return;
    const Entry entry = open("Panels", panel.name);
    ParameterList& list = entry.list;
    // An entry with a shape of its own, or another file, describes itself.
    if (list.isParameter("file") || (list.isParameter("shape") && !says(list, "shape", "pattern file"))) return;
    fill(entry, "shape", std::string("pattern file"), file_);
    fill(entry, "file", std::filesystem::path(file_).filename().string(), file_);
    fill(entry, "panel", panel.name, file_);
    fill(entry, "material", options_.word("material"), options_.file("material"));
    fill(entry, "elements", options_.word("elements"), options_.file("elements"));
    fill(entry, "wale angle", wale_angle(panel), options_.file("wale angle"));
    fill(entry, "mesher", std::string("free"), options_.file());
    if (says(list, "mesher", "free")) {
      fill(entry, "element size", options_.real("element size"), options_.file("element size"));
      fill(entry, "smallest angle", options_.real("smallest angle"), options_.file("smallest angle"));
    }
    const ParameterList& given = scene_.sublist("Pattern");
    if (given.isSublist("Shell") && !list.isParameter("Shell")) list.sublist("Shell") = given.sublist("Shell");
    if (!panel.placement || list.isParameter("Placement")) return;
    if (given.isSublist("Placement")) list.sublist("Placement") = given.sublist("Placement");
    list.sublist("Placement").set("type", std::string("from pattern"));
  }

  void add(const pattern::Stitch& stitch) {
    if (!is_open("Seams", stitch.name)) return;
    const Entry entry = open("Seams", stitch.name);
    fill(entry, "ease", options_.real("ease"), options_.file("ease"));
    if (entry.list.isParameter("first") || entry.list.isParameter("second")) return;
    fill(entry, "first", stitch.first, file_);
    fill(entry, "second", stitch.second, file_);
    fill(entry, "reversed", stitch.reversed, file_);
  }

  /// An entry that is neither of the pattern nor whole by itself has a wrong name.
  void check_names(const pattern::Pattern& pattern) const {
    base::Texts panels, stitches;
    for (const pattern::Panel& panel : pattern.panels) panels.push_back(panel.name);
    for (const pattern::Stitch& stitch : pattern.stitches) stitches.push_back(stitch.name);
    check_names("Panels", "shape", "panel", panels);
    check_names("Seams", "first", "stitch", stitches);
  }

 private:
  struct Entry {
    ParameterList& list;
    std::string path;
  };

  void check_names(const std::string& list, const char* own, const char* kind, const base::Texts& names) const {
    if (!scene_.isSublist(list)) return;
    const ParameterList& entries = scene_.sublist(list);
    for (auto item = entries.begin(); item != entries.end(); ++item) {
      const std::string& name = entries.name(item);
      if (!entries.isSublist(name) || entries.sublist(name).isParameter(own)) continue;
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      const std::string path = "scene > " + list + " > " + name;
      throw base::InputError(origins_.of(path) + ": " + path + ": the pattern " + file_ + " has no " + kind +
                             " of this name, and the entry has no parameter \"" + own + "\" that would make it one" +
                             base::hint(name, names));
    }
  }
  /// False where a parameter stands in the place of a list, which the validation will tell.
  bool is_open(const std::string& list, const std::string& name) const {
    if (!scene_.isParameter(list)) return true;
    if (!scene_.isSublist(list)) return false;
    const ParameterList& entries = scene_.sublist(list);
    return !entries.isParameter(name) || entries.isSublist(name);
  }
  Entry open(const std::string& list, const std::string& name) {
    const std::string path = "scene > " + list + " > " + name;
    ParameterList& entries = scene_.sublist(list);
    if (!entries.isParameter(name)) origins_.note(path, file_);
    return {entries.sublist(name), path};
  }
  template <class T>
  void fill(const Entry& entry, const std::string& name, const T& value, const std::string& file) {
    if (entry.list.isParameter(name)) return;
    entry.list.set(name, value);
    origins_.note(entry.path + " > " + name, file);
  }
  static bool says(const ParameterList& list, const std::string& name, const std::string& word) {
    return list.isType<std::string>(name) && list.get<std::string>(name) == word;
  }
  double wale_angle(const pattern::Panel& panel) const {
    if (!panel.grain || options_.word("wale") == "angle") return options_.real("wale angle");
    const pattern::Vec2 along = panel.grain->to - panel.grain->from;
    return std::atan2(along.y(), along.x()) * 180.0 / M_PI;
  }

  ParameterList& scene_;
  base::Origins& origins_;
  const base::List& options_;
  std::string file_;  ///< path of the pattern
};

}  // namespace

base::Spec pattern_spec() {
  return base::Spec("Pattern",
                    "A whole garment from one file of patterns: each panel of the file becomes an entry of the list "
                    "Panels, meshed freely, and each stitch an entry of the list Seams. Entries of these names in the "
                    "scene go before, each with the parameters that it gives; what it leaves out is filled in.")
      .word("file", pattern_file_text())
      .word("material", "Name of an entry of the list Materials, for all panels.")
      .choice("elements", "Kind of elements.", {"quadrilateral", "triangle"}, std::string("quadrilateral"))
      .real("element size", "mm", "Length of the sides of elements.", base::required, base::Range::positive())
      .real("smallest angle", "deg", "A mesh with a smaller angle in an element is refused.", 10.0,
            base::Range::between(0.0, 60.0))
      .choice("wale",
              "grain line: the fabric's wale direction is the panel's grain line, where the file draws one; angle: it "
              "is 'wale angle' in all panels.",
              {"grain line", "angle"}, std::string("grain line"))
      .real("wale angle", "deg",
            "Angle from the pattern's x axis to the fabric's wale direction, where no grain line gives it.", 90.0)
      .real("ease", "",
            "Largest allowed difference of the two lengths of a seam in the pattern, as a fraction of the longer one.",
            0.05, base::Range::between(0.0, 1.0))
      .list(pattern_placement_spec("Placement",
                                   "Where the garment starts in space, if the file places its panels (placement of "
                                   "type 'from pattern')."))
      .list(shell_spec());
}

void add_pattern(ParameterList& scene, base::Origins& origins) {
  if (!scene.isSublist("Pattern")) return;
  ParameterList only("scene");
  only.sublist("Pattern") = scene.sublist("Pattern");
  const base::List options =
      base::validate(only, base::Spec("scene", "").list(pattern_spec()), origins).list("Pattern");
  const pattern::Pattern pattern = read_pattern_file(options);
  if (options.has_list("Placement"))
    for (const pattern::Panel& panel : pattern.panels)
      if (!panel.placement)
        options.fail("file", "the file does not place panel \"" + panel.name +
                                 "\" in space; leave out the list \"Placement\", and place the panels by entries of "
                                 "the list \"Panels\"");
  Filling filling(scene, origins, options);
  for (const pattern::Panel& panel : pattern.panels) filling.add(panel);
  for (const pattern::Stitch& stitch : pattern.stitches) filling.add(stitch);
  filling.check_names(pattern);
}

}  // namespace toile::garment
