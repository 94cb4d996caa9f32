#include <Tpetra_Core.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::app {

namespace {

/// What the command line says of a plug-in.
struct BuildArguments {
  std::string source;   ///< C++ file
  std::string library;  ///< empty: the source's name with .so, beside it
  bool verbose = false;
};

int build_material(const BuildArguments& arguments) {
  if (Tpetra::getDefaultComm()->getRank() != 0) return static_cast<int>(base::ExitCode::success);
  const std::string& source = arguments.source;
  const std::string library =
      arguments.library.empty() ? std::filesystem::path(source).replace_extension(".so").string() : arguments.library;
  const material::PlugInBuild build = material::build_plugin(source, library, arguments.verbose);
  if (arguments.verbose) std::cout << build.command << "\n";
  if (!build.good) throw base::InputError(source + " does not compile:\n" + build.messages);
  const material::Laws::Law law = material::load_plugin(library);
  std::cout << library << ": law \"" << law->name << "\", parameters";
  for (int i = 0; i < law->n_params; ++i) std::cout << (i == 0 ? " " : ", ") << law->info[i].name;
  std::cout << "\nA scene names it in its list \"Plug-ins\" and is run with --allow-plugins:\n"
            << "  <ParameterList name=\"Plug-ins\">\n    <ParameterList name=\"" << law->name
            << "\">\n      <Parameter name=\"file\" type=\"string\" value=\""
            << std::filesystem::path(library).filename().string() << "\"/>\n    </ParameterList>\n  </ParameterList>"
            << std::endl;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_material_build(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<BuildArguments>();
  CLI::App* build =
      material_command(program)->add_subcommand("build", "Compile a fabric to a plug-in that scenes can load");
  build->add_option("source", arguments->source, "C++ file of the fabric")->required();
  build->add_option("-o,--output", arguments->library, "The plug-in (default: the name of the source with .so)")
      ->type_name("FILE");
  build->add_flag("--verbose", arguments->verbose, "Print the compiler's command and all that it says");
  build->callback([arguments, &chosen] { chosen = [arguments] { return build_material(*arguments); }; });
}

}  // namespace toile::app
