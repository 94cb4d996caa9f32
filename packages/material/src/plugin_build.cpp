
#include <array>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/base/process.hpp"
#include "toile/material/plugin_files.hpp"
#include "toolchain.hpp"

namespace toile::material {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words command_of(const std::string& source, const std::string& library) {
  const Toolchain& own = toolchain();
  Words command = {own.compiler};
  command.insert(command.end(), own.flags.begin(), own.flags.end());
  // The linker refuses a library without the symbol of TOILE_MATERIAL, so that none is left behind.
  for (const char* flag : {"-fPIC", "-shared", "-fvisibility=hidden", "-fvisibility-inlines-hidden", "-w",
                           "-fmax-errors=5", "-fdiagnostics-color=never", "-Wl,--require-defined=toile_material"})
    command.emplace_back(flag);
  for (const std::string& folder : own.include_folders) command.insert(command.end(), {"-isystem", folder});
  command.push_back("-DTOILE_MATERIAL_VERSION=\"" + own.version + "\"");
  command.insert(command.end(), {"-o", library, source});
  return command;
}

/// The words as one line for a shell.
std::string shell_text(const Words& command) {
  std::string line;
  for (const std::string& word : command) {
    const bool plain = word.find_first_of(" \"'\\$&;()<>|*?`") == std::string::npos;
    line += (line.empty() ? "" : " ") + (plain ? word : "'" + word + "'");
  }
  return line;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// `line` with the type `name`<...> named `plain`, however long its arguments are.
void shorten(std::string& line, const std::string& name, const std::string& plain) {
  for (auto at = line.find(name + "<"); at != std::string::npos; at = line.find(name + "<", at + 1)) {
    auto end = at + name.size();
    int depth = 0;
    do {
      depth += (line[end] == '<') - (line[end] == '>');
      ++end;
    } while (depth > 0 && end < line.size());
    line.replace(at, end - at, plain);
  }
}

/// Types as the author wrote them.
void shorten_types(std::string& line) {
  shorten(line, "toile::material::PlaneC", "PlaneC<T>");
  shorten(line, "toile::material::Params", "Params<P>");
  shorten(line, "Sacado::mpl::enable_if_c", "expression");
  shorten(line, "Sacado::mpl::disable_if_c", "expression");
  const std::regex operation("(Sacado::Fad::Exp::\\w+Op)<");
  for (std::smatch found; std::regex_search(line, found, operation);) shorten(line, found.str(1), "expression");
  shorten(line, "Sacado::Fad::Exp::GeneralFad", "T");
  shorten(line, "toile::material::SecondOrder", "T");
  line = std::regex_replace(line, std::regex("expression::type( \\{aka [^}]*\\})?"), "expression");
  line = std::regex_replace(line, std::regex("toile::material::Lane"), "P");
}

/// What to write instead of what this error of the compiler complains of; empty: nobody knows.
std::string hint_on(const std::string& error) {
  const auto says = [&](const std::string& pattern) { return std::regex_search(error, std::regex(pattern)); };
  if (says("no match for .*operator(<|>|==|!=)"))
    return "an energy has no `if` on a variable: use where(less(a, b), yes, no)";
  const std::string call = "no matching function for call to \\W*";
  if (says(call + "(power|exp|log|sqrt|sin|cos|reciprocal|less|where)\\(.*\\bexpression\\b"))
    return "functions take variables, not expressions: write const T x = ...; first";
  if (says(call + "(a?(sin|cos|tan)h?|pow|exp(2|m1)?|log(2|10|1p)?|sqrt|cbrt|hypot|f?(abs|min|max))\\(") ||
      says("cannot convert .*\\bT\\b.* to \\W*double\\W*$"))
    return "the functions of an energy are power, exp, log, sqrt, sin, cos, reciprocal, and where(less(a, b), yes, no) "
           "for a choice; write them without std::";
  return "";
}

/// Line of "file:line:column:"; 0: there is none.
int line_number(const std::string& place, const std::string& source) {
  return starts_with(place, source + ":") ? std::atoi(place.c_str() + source.size() + 1) : 0;
}

/// The errors alone, each place once, with the lines of code that the compiler shows, then hints. Where an error lies
/// in a header, the innermost place in the author's file that led to it goes before it, and the header's name is
/// dropped; it is dropped if there is an error of that line already.
std::string first_errors(const std::string& said, const std::string& source) {
  std::istringstream lines(said);
  std::string text, place;
  std::set<std::string> shown, hints;
  std::set<int> shown_lines;
  bool shows_code = false;
  for (std::string line; std::getline(lines, line);) {
    const bool own = starts_with(line, source + ":");
    const auto error = std::min(line.find(" error: "), line.find(" fatal error: "));
    if (error != std::string::npos) {
      const std::string where = own ? line.substr(0, error) : place.empty() ? source + ":" : place;
      const bool line_is_new = shown_lines.insert(line_number(where, source)).second;
      const bool is_new = shown.insert(where).second && (own || line_is_new);
      line = where + line.substr(error);
      shorten_types(line);
      if (is_new) {
        text += line + "\n";
        hints.insert(hint_on(line));
      }
      shows_code = own && is_new;
    } else if (!line.empty() && line.front() == ' ' && shows_code && line.find('|') != std::string::npos) {
      shorten_types(line);
      text += line + "\n";
    } else {
      shows_code = false;
      // The compiler tells how it got to an error from the innermost place outwards.
      if (line.find(": In ") != std::string::npos) place.clear();
      if (place.empty() && line_number(line, source) != 0) place = line.substr(0, line.find(' '));
    }
  }
  hints.erase("");
  for (const std::string& hint : hints) text += "Hint: " + hint + "\n";
  return text.empty() ? said : text;
}

}  // namespace

PlugInBuild build_plugin(const std::string& source, const std::string& library, bool verbose) {
  if (!fs::is_regular_file(source)) throw base::InputError(source + ": there is no such file");
  const std::string ending = fs::path(source).extension();
  if (ending != ".cpp" && ending != ".cc" && ending != ".cxx")
    throw base::InputError(source + ": a plug-in is made from a C++ file; the name ends with \"" + ending +
                           "\", allowed: .cpp, .cc, .cxx");
  for (const std::string& folder : toolchain().include_folders)
    if (!fs::is_directory(folder))
      throw base::InputError("the headers of Toile that a plug-in is compiled with are not there: no folder " + folder);
  const Words command = command_of(source, library);
  const base::ProcessEnd end = base::run_process(command);
  if (!end.found)
    throw base::InputError("the compiler that Toile was built with, " + command.front() + ", cannot be run");
  const std::string said = end.output + end.errors;
  PlugInBuild build{end.status == 0, shell_text(command), ""};
  if (verbose || build.good) {
    build.messages = said;
  } else if (said.find("required symbol `toile_material' not defined") != std::string::npos) {
    build.messages = source +
                     ": error: TOILE_MATERIAL(YourLaw) is missing: end the file with it, YourLaw being the fabric's "
                     "struct\n";
  } else {
    build.messages = first_errors(said, source);
  }
  return build;
}

}  // namespace toile::material
