#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace toile::app {

/// What the command line asks for: returns the exit status of the program (base::ExitCode); errors are thrown as
/// base::Error.
using Chosen = std::function<int()>;

/// A command: adds itself and its options to the program, and is chosen when the command line has it. Each is a
/// function add_NAME() in a source of its own.
using AddCommand = void (*)(CLI::App& program, Chosen& chosen);
/// All of them, in the order of the help; a new one is a line in commands.cpp.
const std::vector<AddCommand>& commands();

// What several have.
/// The command `material`, under which those on fabrics are.
CLI::App* material_command(CLI::App& program);
/// The command `body`, under which those on bodies are.
CLI::App* body_command(CLI::App& program);
void add_plugins_flag(CLI::App* command, bool& allow);
void add_output_option(CLI::App* command, std::string& folder, const std::string& text);

/// Prints the fields that a run writes.
int describe_fields(bool markdown);

}  // namespace toile::app
