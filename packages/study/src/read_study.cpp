#include <algorithm>
#include <filesystem>
#include <set>

#include "toile/base/error.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/scene/scene.hpp"
#include "toile/study/spec.hpp"
#include "toile/study/study.hpp"

namespace toile::study {

namespace {

namespace fs = std::filesystem;
using base::List;
using base::Texts;

constexpr std::size_t most_cases = 100000;
const std::string include_path = "include", threads_path = "run/threads", ranks_path = "run/ranks";

Axis::Change read_change(const List& list) {
  Axis::Change change{list.name(), list.words("paths"), list.words("values"), list.words("labels")};
  if (change.paths.empty()) list.fail("paths", "names nothing");
  if (change.values.empty()) list.fail("values", "holds no value");
  if (change.labels.empty()) change.labels = change.values;
  if (change.labels.size() != change.values.size()) list.fail("labels", "must be as many as the values");
  const std::set<std::string> different(change.labels.begin(), change.labels.end());
  if (different.size() != change.labels.size() && list.word("with").empty())
    list.fail(list.given("labels") ? "labels" : "values", "holds an entry twice");
  return change;
}

std::vector<Axis> read_axes(const List& vary) {
  std::vector<Axis> axes;
  Texts names;
  for (const List& entry : vary.entries()) {
    if (!entry.word("with").empty()) continue;
    Axis axis{{read_change(entry)}, entry.flag("problem"), entry.reals("sizes")};
    if (!axis.sizes.empty() && axis.sizes.size() != axis.size()) entry.fail("sizes", "must be as many as the values");
    axes.push_back(axis);
    names.push_back(axis.name());
  }
  for (const List& entry : vary.entries()) {
    const std::string& with = entry.word("with");
    if (with.empty()) continue;
    const auto axis = std::find_if(axes.begin(), axes.end(), [&with](const Axis& a) { return a.name() == with; });
    if (axis == axes.end())
      entry.fail("with", "names no change that is combined with all others" + base::hint(with, names));
    const Axis::Change change = read_change(entry);
    if (change.values.size() != axis->size())
      entry.fail("values", "must be " + std::to_string(axis->size()) + ", as many as those of \"" + with + "\"");
    axis->changes.push_back(change);
  }
  return axes;
}

std::vector<Quantity> read_quantities(const List& list, const fs::path& folder, const std::vector<Axis>& axes) {
  std::vector<Quantity> quantities;
  const auto problem = std::find_if(axes.begin(), axes.end(), [](const Axis& a) { return a.problem; });
  const std::size_t problems = problem == axes.end() ? 1 : problem->size();
  for (const List& entry : list.entries()) {
    Quantity q;
    q.name = entry.name();
    q.type = entry.word("type");
    if (q.type != "body force") q.of = entry.word("of");
    if (q.type == "displacement" || q.type == "reaction" || q.type == "body force")
      q.component = entry.word("component");
    q.reference = entry.reals("reference");
    if (q.reference.size() > 1 && q.reference.size() != problems)
      entry.fail("reference", "must hold one value, or " + std::to_string(problems) +
                                  ": one for each value of the first change that is a problem");
    if (std::find(q.reference.begin(), q.reference.end(), 0.0) != q.reference.end())
      entry.fail("reference", "must not be 0: errors are told in % of it");
    if (const std::string& file = entry.word("reference file"); !file.empty())
      q.reference_file = (folder / file).lexically_normal().string();
    q.reference_column = entry.word("reference column");
    quantities.push_back(q);
  }
  return quantities;
}

/// What may stand in the name of a folder.
std::string clean(const std::string& label) {
  std::string name;
  for (const char c : fs::path(label).filename().string())
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+' ? c : '_';
  return name;
}

std::string folder_name(const Study& study, const std::vector<std::size_t>& place) {
  std::string name = "case";
  for (std::size_t a = 0; a < place.size(); ++a) name += "-" + clean(study.axes[a].changes[0].labels[place[a]]);
  return name.substr(0, 150);
}

int whole_number(const std::string& path, const std::string& text) {
  std::size_t end = 0;
  int value = 0;
  try {
    value = std::stoi(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end != text.size() || value < 1 || value > 1024)
    throw base::InputError("path \"" + path + "\": the value is \"" + text + "\", expected a whole number, 1 to 1024");
  return value;
}

class CaseMaker {
 public:
  CaseMaker(const Study& study, std::string scene, fs::path folder, bool allow_plugins)
      : study_(study), scene_(std::move(scene)), folder_(std::move(folder)), allow_plugins_(allow_plugins) {}

  Case make(const std::vector<std::size_t>& place) {
    Texts files = {scene_};
    each_change(place, [&](const std::string& path, const std::string& value) {
      if (path == include_path && value != "-") files.push_back((folder_ / value).lexically_normal().string());
    });
    Case one{place, folder_name(study_, place), base::Variant(files, "scene"), 1, 1, {}};
    const material::Laws laws = material::read_laws({one.scene.content(), ""}, "scene", allow_plugins_);
    const base::Spec spec = scene::scene_spec(laws);
    each_change(place, [&](const std::string& path, const std::string& value) {
      if (path == threads_path)
        one.threads = whole_number(path, value);
      else if (path == ranks_path)
        one.ranks = whole_number(path, value);
      else if (path != include_path)
        one.scene.set(spec, path, value);
    });
    one.identity = one.scene.identity(spec) + "threads " + std::to_string(one.threads) + " ranks " +
                   std::to_string(one.ranks) + "\n";
    return one;
  }

 private:
  template <class Use>
  void each_change(const std::vector<std::size_t>& place, const Use& use) const {
    for (std::size_t a = 0; a < place.size(); ++a)
      for (const Axis::Change& change : study_.axes[a].changes)
        for (const std::string& path : change.paths) use(path, change.values[place[a]]);
  }

  const Study& study_;
  std::string scene_;
  fs::path folder_;
  bool allow_plugins_;
};

/// The next place, the last axis first; false: there is none.
bool advance(std::vector<std::size_t>& place, const std::vector<Axis>& axes) {
  for (std::size_t a = place.size(); a-- > 0;) {
    if (++place[a] < axes[a].size()) return true;
    place[a] = 0;
  }
  return false;
}

}  // namespace

base::Texts study_files(const std::string& file) {
  const List list = base::read_xml(file, study_spec());
  Texts files;
  for (const std::string& one : list.words("studies"))
    files.push_back((fs::path(list.file("studies")).parent_path() / one).lexically_normal().string());
  if (!files.empty() && (list.given("scene") || list.has_list("Vary")))
    list.fail("studies", "stands beside a study of this file itself; give either");
  if (files.empty()) files = {file};
  return files;
}

Study read_study(const std::string& file, bool allow_plugins) {
  const List list = base::read_xml(file, study_spec());
  if (list.word("scene").empty()) list.fail("scene", "must name a file");
  for (const char* needed : {"Vary", "Quantities"})
    if (!list.has_list(needed)) throw base::InputError(file + ": study: missing list \"" + needed + "\"");
  const fs::path folder = fs::path(list.file("scene")).parent_path();
  Study study;
  study.name = fs::path(file).stem().string();
  study.title = list.word("title").empty() ? study.name : list.word("title");
  study.axes = read_axes(list.list("Vary"));
  study.quantities = read_quantities(list.list("Quantities"), folder, study.axes);
  Texts names;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    names.push_back(study.axes[a].name());
    if (study.axes[a].name() == list.word("refine")) study.refine = static_cast<int>(a);
  }
  if (study.refine < 0 && !list.word("refine").empty())
    list.fail("refine", "names no change that is combined with all others" + base::hint(list.word("refine"), names));
  study.jobs = list.integer("jobs");
  study.most_seconds = list.real("time limit");
  study.processor_time = list.word("time") == "processor";
  for (const double target : list.reals("targets")) study.targets.push_back(0.01 * target);
  study.tolerance = 0.01 * list.real("tolerance");

  std::size_t count = 1;
  for (const Axis& axis : study.axes) count = std::min(count * axis.size(), most_cases + 1);
  if (count > most_cases) throw base::InputError(file + ": more than " + std::to_string(most_cases) + " cases");
  CaseMaker maker(study, (folder / list.word("scene")).lexically_normal().string(), folder, allow_plugins);
  std::set<std::string> folders;
  std::vector<std::size_t> place(study.axes.size(), 0);
  do {
    try {
      study.cases.push_back(maker.make(place));
    } catch (const base::InputError& error) {
      throw base::InputError(file + ": " + error.what());
    }
    std::string& name = study.cases.back().name;
    if (!folders.insert(name).second) {
      name += "-" + std::to_string(study.cases.size());
      folders.insert(name);
    }
  } while (advance(place, study.axes));
  return study;
}

}  // namespace toile::study
