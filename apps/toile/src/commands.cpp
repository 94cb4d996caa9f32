#include "commands.hpp"

namespace toile::app {

// Every command: each is a function add_NAME() in a source of its own.
#define TOILE_COMMANDS(COMMAND) \
  COMMAND(run)                  \
  COMMAND(report)               \
  COMMAND(check)                \
  COMMAND(dress)                \
  COMMAND(material_check)       \
  COMMAND(material_build)       \
  COMMAND(identify)             \
  COMMAND(study)                \
  COMMAND(compare)              \
  COMMAND(body_measure)         \
  COMMAND(body_landmarks)       \
  COMMAND(body_make)            \
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

namespace {

/// The command `name` that has commands of its own; added if it is not there yet.
CLI::App* group(CLI::App& program, const std::string& name, const std::string& text) {
  for (CLI::App* known : program.get_subcommands(nullptr))
    if (known->get_name() == name) return known;
  CLI::App* added = program.add_subcommand(name, text);
  added->require_subcommand(1);
  return added;
}

}  // namespace

CLI::App* material_command(CLI::App& program) {
  return group(program, "material", "Work on fabrics");
}

CLI::App* body_command(CLI::App& program) {
  return group(program, "body", "Measure bodies, and make them from measurements");
}

void add_plugins_flag(CLI::App* command, bool& allow) {
  command->add_flag("--allow-plugins", allow,
                    "Load the plug-ins that the file names; they are programs that run with your rights");
}

void add_output_option(CLI::App* command, std::string& folder, const std::string& text) {
  command->add_option("--output", folder, text)->type_name("DIR");
}

}  // namespace toile::app
