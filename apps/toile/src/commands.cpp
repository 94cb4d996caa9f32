#include "commands.hpp"

namespace toile::app {

// Every command: each is a function add_NAME() in a source of its own.
#define TOILE_COMMANDS(COMMAND) \
  COMMAND(run)                  \
  COMMAND(check)                \
  COMMAND(material_check)       \
  COMMAND(material_build)       \
  COMMAND(identify)             \
  COMMAND(describe)

#define TOILE_DECLARE(name) void add_##name(CLI::App& program, Chosen& chosen);
TOILE_COMMANDS(TOILE_DECLARE)
#undef TOILE_DECLARE

const std::vector<AddCommand>& commands() {
#define TOILE_NAME(name) add_##name,
  static const std::vector<AddCommand> all{TOILE_COMMANDS(TOILE_NAME)};
#undef TOILE_NAME
  return all;
}

CLI::App* material_command(CLI::App& program) {
  for (CLI::App* known : program.get_subcommands(nullptr))
    if (known->get_name() == "material") return known;
  CLI::App* material = program.add_subcommand("material", "Work on fabrics");
  material->require_subcommand(1);
  return material;
}

void add_plugins_flag(CLI::App* command, bool& allow) {
  command->add_flag("--allow-plugins", allow,
                    "Load the plug-ins that the file names; they are programs that run with your rights");
}

void add_output_option(CLI::App* command, std::string& folder, const std::string& text) {
  command->add_option("--output", folder, text)->type_name("DIR");
}

}  // namespace toile::app
