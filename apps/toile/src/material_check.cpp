#include <Tpetra_Core.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "material_map.hpp"
#include "toile/base/error.hpp"
#include "toile/material/read_laws.hpp"
#include "toile/scene/scene.hpp"

namespace toile::app {
namespace {

/// What the command line says of a check of fabrics.
struct MaterialCheckArguments {
  std::string file;            ///< a fabric's XML file, or a scene if `material` is given
  std::string material;        ///< one of the scene's
  std::string output = "";     ///< folder of maps; empty: results/<name of the file>-check
  bool all = false;            ///< every published set instead of a file
  bool allow_plugins = false;  ///< the file may load programs
};

struct Task {
  material::Laws laws;  ///< of the fabrics
  std::vector<criteria::Fabric> fabrics;
  criteria::Request request;
};

/// One material of a scene; nothing else of it is read.
Task task_of_scene(const MaterialCheckArguments& arguments) {
  const material::Laws laws = material::read_laws(arguments.file, "scene", arguments.allow_plugins);
  const auto materials = base::read_part(arguments.file, "scene", scene::materials_spec(laws));
  if (!materials) throw base::InputError(arguments.file + ": scene: missing list \"Materials\"");
  base::Texts names;
  for (const base::List& entry : materials->entries()) {
    if (entry.name() == arguments.material)
      return {laws, criteria::fabrics_of(material::Material(entry, laws), arguments.material), {}};
    names.push_back(entry.name());
  }
  throw base::InputError(arguments.file + ": scene > Materials: unknown material \"" + arguments.material + "\"" +
                         base::hint(arguments.material, names));
}

/// A scene that is given without the name of a material has many lists that a fabric's file does not know.
base::List read_fabric(const std::string& file, const material::Laws& laws) {
  try {
    return base::read_xml(file, criteria::file_spec(laws));
  } catch (const base::InputError& error) {
    const std::string text = error.what();
    if (text.find("\"Materials\"") == std::string::npos) throw;
    throw base::InputError(text + "\nIf this is a scene, name one of its materials too: toile material check " + file +
                           " MATERIAL");
  }
}

Task task_of_fabric(const MaterialCheckArguments& arguments) {
  const material::Laws laws = material::read_laws(arguments.file, "fabric", arguments.allow_plugins);
  const base::List list = read_fabric(arguments.file, laws);
  const std::string name = std::filesystem::path(arguments.file).stem().string();
  Task task{laws, criteria::fabrics_of(material::Material(list.list("Material"), laws), name), {}};
  if (list.has_list("Check")) task.request = criteria::read_request(list.list("Check"));
  return task;
}

Task task_of(const MaterialCheckArguments& arguments) {
  if (arguments.all != arguments.file.empty())
    throw base::InputError(arguments.all ? "material check: --all takes no file"
                                         : "material check: name a fabric's XML file, a scene and one of its "
                                           "materials, or --all for every published set");
  if (arguments.all) return {{}, criteria::published_fabrics(), {}};
  return arguments.material.empty() ? task_of_fabric(arguments) : task_of_scene(arguments);
}

std::string folder_of(const MaterialCheckArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return "results/" + (arguments.all ? "materials" : std::filesystem::path(arguments.file).stem().string()) + "-check";
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw base::InputError("cannot make the folder '" + folder + "': " + error.message());
}

/// Prints and writes `report`; tells the criteria that fail.
void tell(const criteria::Report& report, const std::string& folder) {
  std::cout << criteria::table(report);
  const std::string warnings = write_map(report, folder);
  std::cout << "  map: " << folder << '/' << file_stem(report) << ".csv, -stretches.svg, -shear.svg\n" << std::endl;
  if (!warnings.empty()) std::cerr << "toile: warning: " << warnings << std::flush;
}

int check_material(const MaterialCheckArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError("material check runs on one rank; start it without mpirun");
  const Task task = task_of(arguments);
  const std::string folder = folder_of(arguments);
  make_folder(folder);
  std::string failed;
  for (const criteria::Fabric& fabric : task.fabrics) {
    const criteria::Report report = criteria::check(fabric, task.request);
    tell(report, folder);
    for (const std::string& criterion : report.failed)
      failed += (failed.empty() ? "" : "; ") + fabric.name + ": " + criterion;
    // The literal form of a continued law is there to be compared with it, and not what a scene uses.
    if (arguments.all)
      for (const criteria::Fabric& literal : criteria::literal_form(fabric))
        tell(criteria::check(literal, task.request), folder);
  }
  if (failed.empty()) return static_cast<int>(base::ExitCode::success);
  throw base::Error(base::ExitCode::check_failed, "criteria that do not hold: " + failed);
}

}  // namespace

void add_material_check(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<MaterialCheckArguments>();
  CLI::App* check =
      material_command(program)->add_subcommand("check", "Check a fabric's energy and map where it loses what");
  check->add_option("file", arguments->file, "XML file with lists Material and Check, or a scene");
  check->add_option("material", arguments->material, "Which of the scene's materials");
  add_output_option(check, arguments->output, "Folder of the maps (default: results/<name of the file>-check)");
  add_plugins_flag(check, arguments->allow_plugins);
  check->add_flag("--all", arguments->all, "Every published set, in its literal form too");
  check->callback([arguments, &chosen] { chosen = [arguments] { return check_material(*arguments); }; });
}

}  // namespace toile::app
