#include <Tpetra_Core.hpp>
#include <filesystem>
#include <iostream>

#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::app {

int build_material(const std::string& source, const std::string& output, bool verbose) {
  if (Tpetra::getDefaultComm()->getRank() != 0) return static_cast<int>(base::ExitCode::success);
  const std::string library = output.empty() ? std::filesystem::path(source).replace_extension(".so").string() : output;
  const material::PlugInBuild build = material::build_plugin(source, library, verbose);
  if (verbose) std::cout << build.command << "\n";
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

}  // namespace toile::app
