#include "toile/dress/dress.hpp"

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "body_input.hpp"
#include "commands.hpp"
#include "run.hpp"
#include "toile/base/error.hpp"
#include "toile/body/import.hpp"
#include "toile/pattern/file.hpp"
#include "toile/result/replace_file.hpp"
#include "toile/run/outputs.hpp"

namespace toile::app {

namespace {

/// What the command line says of a garment and who wears it.
struct DressArguments {
  std::string pattern, body;  ///< files
  dress::Options options;
  double body_scale = 1.0;  ///< mm per unit of its file
  std::string fabric = "t-shirt";
  std::string output = "";  ///< folder; empty: results/<name of the pattern>
  int threads = 1;
  bool only_scene = false;
};

dress::Dressed dress_body(const DressArguments& arguments) {
  const pattern::Pattern pattern = pattern::read_pattern(arguments.pattern);
  body::ImportOptions import;
  import.scale = arguments.body_scale;
  const body::Import body = body::import_body(arguments.body, import);
  if (!body.notes.empty()) std::cerr << "toile: " << arguments.body << ": " << body.notes << std::endl;
  try {
    return dress::dress(pattern, body.mesh, arguments.options);
  } catch (const base::InputError& error) {
    throw base::InputError(arguments.pattern + " on " + arguments.body + ": " + error.what());
  }
}

/// The scene and its pattern, for the user to edit. Returns the path of the scene.
std::string write_scene(const dress::Dressed& dressed, const DressArguments& arguments, const std::string& folder) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  const std::string pattern = "pattern.json", scene = folder + "/scene.xml";
  pattern::write_pattern(dressed.pattern, folder + "/" + pattern);
  dress::SceneFiles files;
  files.title = fs::path(arguments.pattern).stem().string() + " on " + fs::path(arguments.body).stem().string();
  files.body = fs::proximate(arguments.body, folder).string();
  files.body_scale = arguments.body_scale;
  files.pattern = pattern;
  files.fabric = arguments.fabric;
  files.element_size = arguments.options.element_size;
  result::replace_file(scene, dress::scene_text(dressed, files), "cannot write the scene '" + scene + "': ");
  return scene;
}

/// How much of each panel presses on the body, and where it is loose.
void tell_fit(const run::Session& session, base::Log& log) {
  const solve::Fields& fields = session.record().fields();
  const mesh::Mesh& mesh = session.scene().garment().mesh;
  std::vector<std::string> lines;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const std::vector<int>& nodes = mesh.blocks[b].connectivity;
    std::vector<int> own(nodes.begin(), nodes.end());
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    double area = 0.0, pressed = 0.0, force = 0.0, largest = 0.0;
    for (const int n : own) {
      area += fields.area[n];
      if (fields.pressure[n] <= 0.0) continue;
      pressed += fields.area[n];
      force += fields.area[n] * fields.pressure[n];
      largest = std::max(largest, fields.pressure[n]);
    }
    constexpr double kpa = 1e3;  // per MPa
    std::string line = "\n  " + mesh.blocks[b].name + ": " + decimals(100.0 * (1.0 - pressed / area), 0) + " % loose";
    if (pressed > 0.0)
      line += ", elsewhere " + decimals(kpa * force / pressed, 3) + " kPa on average, at most " +
              decimals(kpa * largest, 3) + " kPa";
    lines.push_back(line);
  }
  std::string text = "Fit";
  for (const std::string& line : lines) text += line;
  log.info(text);
}

bool drapes(const scene::Scene& scene) {
  try {
    scene.check_drape();
    return true;
  } catch (const base::InputError&) {
    return false;
  }
}

int dress(const DressArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError(
        "dress runs on one rank; write the scene by --only-scene without mpirun, then run it by mpirun toile run");
  const std::string folder = arguments.output.empty()
                                 ? "results/" + std::filesystem::path(arguments.pattern).stem().string()
                                 : arguments.output;
  const dress::Dressed dressed = dress_body(arguments);
  RunArguments run;
  run.scene = write_scene(dressed, arguments, folder);
  run.output = folder;
  run.threads = arguments.threads;
  base::Log log(std::cout, std::cerr);
  std::string text = "Pattern on the body";
  for (const std::string& line : dressed.lines) text += "\n  " + line;
  log.info(text + "\n  scene: " + run.scene);
  if (arguments.only_scene) return static_cast<int>(base::ExitCode::success);
  run::Session session(run.scene, options_of(run));
  try {
    run_session(session, run);
  } catch (const base::InputError& error) {
    if (drapes(session.scene())) throw;
    run::write_start(session, folder);
    throw base::InputError(std::string(error.what()) + " (" + folder + "/start.exo shows it)." +
                           (dressed.fitting_scale > 0.0 ? " Where the pattern is tightest it has the width of the body "
                                                          "with --scale " +
                                                              decimals(dressed.fitting_scale, 2)
                                                        : std::string()));
  }
  tell_fit(session, session.log());
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_dress(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<DressArguments>();
  CLI::App* dress = program.add_subcommand("dress", "Put a sewing pattern on a body: make a scene, and run it");
  dress->add_option("pattern", arguments->pattern, "File of the pattern, its panels placed in space (JSON)")
      ->required();
  dress->add_option("body", arguments->body, "OBJ, STL, PLY or OFF file; mm, z up, front towards -y")->required();
  dress->add_option("--fabric", arguments->fabric, "Published set of the rebar fabric (default: t-shirt)");
  dress->add_option("--size", arguments->options.element_size, "Length of the sides of elements, mm (default: 12)")
      ->check(CLI::Range(0.5, 1e3));
  dress->add_option("--scale", arguments->options.scale, "Factor of the pattern's size (default: 1)")
      ->check(CLI::Range(1e-3, 1e3));
  dress->add_option("--hem", arguments->options.hem,
                    "Height of the lowest point, mm (default: shoulder seams lie on the shoulders)");
  dress->add_option("--body-scale", arguments->body_scale, "Factor that turns the coordinates of the body into mm")
      ->check(CLI::PositiveNumber);
  dress->add_option("--threads", arguments->threads, "Threads in the element loops (default: 1)")
      ->check(CLI::Range(1, 1024));
  dress->add_flag("--only-scene", arguments->only_scene, "Write the scene and do not run it");
  add_output_option(dress, arguments->output, "Folder of the scene and its results (default: results/<pattern>)");
  dress->callback([arguments, &chosen] { chosen = [arguments] { return app::dress(*arguments); }; });
}

}  // namespace toile::app
