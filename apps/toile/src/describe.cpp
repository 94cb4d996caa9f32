#include <Tpetra_Core.hpp>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/base/reference.hpp"
#include "toile/criteria/check.hpp"
#include "toile/identify/spec.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/scene/scene.hpp"

namespace toile::app {

namespace {

/// What the command line says of a description.
struct DescribeArguments {
  std::string what;   ///< a list or parameter by its path, or a line of an error message that holds one; empty: all
  std::string scene;  ///< empty, or a file whose plug-ins are described too
  bool markdown = false, allow_plugins = false;
};

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

/// The file that a path begins in: by its name in front, or by its first list; else a scene, which knows most.
const base::Spec& file_of(const std::vector<base::Spec>& files, const std::string& path) {
  const auto begins = [&path](const std::string& name) { return path == name || path.rfind(name + " >", 0) == 0; };
  for (const base::Spec& file : files)
    if (begins(file.name())) return file;
  for (const base::Spec& file : files)
    for (const auto& [list, is_required] : file.lists())
      if (begins(list.name())) return file;
  return files.front();
}

int describe(const DescribeArguments& arguments) {
  const auto& [what, scene, markdown, allow_plugins] = arguments;
  if (what == "fields") return describe_fields(markdown);
  const material::Laws laws = scene.empty() ? material::Laws() : material::read_laws(scene, "scene", allow_plugins);
  const std::vector<base::Spec> files = {scene::scene_spec(laws), fabric_file(), identify::fit_spec(laws)};
  // A whole fit file has a command of its own.
  std::vector<base::TitledSpec> specs = {{files[0].name(), files[0]}, {files[1].name(), files[1]}};
  if (!what.empty()) specs = base::find_specs(file_of(files, base::path_in(what)), base::path_in(what));
  if (Tpetra::getDefaultComm()->getRank() != 0) return static_cast<int>(base::ExitCode::success);
  if (markdown) std::cout << markdown_title;
  for (const base::TitledSpec& one : specs)
    std::cout << (&one == &specs.front() ? "" : "\n")
              << (markdown ? base::describe_markdown(one) : base::describe_text(one)) << std::flush;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_describe(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<DescribeArguments>();
  CLI::App* describe = program.add_subcommand("describe", "Print every list and parameter of a scene file");
  describe->add_option(
      "list", arguments->what,
      "Only this list or parameter: its name or path, \"Panels > front > width\", or an error message; "
      "fields: what is written");
  describe->add_flag("--markdown", arguments->markdown, "As Markdown");
  describe->add_option("--scene", arguments->scene, "Also the plug-ins and formulas of this scene");
  add_plugins_flag(describe, arguments->allow_plugins);
  describe->callback([arguments, &chosen] { chosen = [arguments] { return app::describe(*arguments); }; });
}

}  // namespace toile::app
