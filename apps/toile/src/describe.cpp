#include <Tpetra_Core.hpp>
#include <iostream>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/criteria/check.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/scene/scene.hpp"

namespace toile::app {

namespace {

const std::string markdown_title =
    "# Input reference\n\n"
    "A scene is a Teuchos XML parameter list: `<ParameterList name=\"scene\">` with the lists below, and parameters "
    "`<Parameter name=\"...\" type=\"...\" value=\"...\"/>`. Names in angle brackets are yours to choose. "
    "An empty unit means a number without one, an empty \"allowed\" any value. "
    "This page is what `toile describe --markdown` prints.\n\n";

/// The other file that Toile reads; its list Material is described with the scene's materials.
base::Spec fabric_file() {
  base::Spec spec("fabric",
                  "File of `toile material check`: list Material (required; holds what scene > Materials > <material> "
                  "does), lists Plug-ins and Formulas as in a scene, and list Check.");
  return spec.add(base::include_parameter()).list(criteria::check_spec());
}

}  // namespace

int check(const std::string& file, bool allow_plugins) {
  base::Timer timer;
  const material::Laws laws = material::read_laws(file, "scene", allow_plugins);
  const base::List list = base::read_xml(file, scene::scene_spec(laws));
  const scene::Scene scene(list, 1, timer, laws);
  if (Tpetra::getDefaultComm()->getRank() == 0)
    std::cout << file << ": valid. " << scene.garment().mesh.nodes() << " nodes, " << scene.garment().mesh.elements()
              << " elements, " << scene.garment().seams.size() << " seams, " << scene.stages().size() << " stages"
              << (scene.surface() != nullptr ? "; " + scene.surface()->summary() : std::string()) << std::endl;
  return static_cast<int>(base::ExitCode::success);
}

int describe(bool markdown, const std::string& name, const std::string& scene, bool allow_plugins) {
  if (name == "fields") return describe_fields(markdown);
  const material::Laws laws = scene.empty() ? material::Laws() : material::read_laws(scene, "scene", allow_plugins);
  std::vector<base::Spec> specs = {scene::scene_spec(laws), fabric_file()};
  if (!name.empty()) {
    base::Texts valid;
    const base::Spec* found = nullptr;
    for (const base::Spec& spec : specs)
      for (const auto& [inner, is_required] : spec.lists()) {
        valid.push_back(inner.name());
        if (inner.name() == name) found = &inner;
      }
    if (found == nullptr) {
      const std::string near = base::nearest_name(name, valid);
      std::string all;
      for (const std::string& v : valid) all += (all.empty() ? "" : ", ") + v;
      throw base::InputError("describe: the scene has no list \"" + name + "\"" +
                             (near.empty() ? "" : "; did you mean \"" + near + "\"?") + " Lists: " + all);
    }
    specs = std::vector<base::Spec>{*found};
  }
  if (Tpetra::getDefaultComm()->getRank() != 0) return static_cast<int>(base::ExitCode::success);
  if (markdown) std::cout << markdown_title;
  for (const base::Spec& spec : specs)
    std::cout << (&spec == &specs.front() ? "" : "\n")
              << (markdown ? base::describe_markdown(spec) : base::describe_text(spec)) << std::flush;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace toile::app
