#include "toile/pattern/file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "format.hpp"
#include "toile/base/error.hpp"
#include "toile/base/file.hpp"
#include "toile/base/parameters.hpp"

namespace toile::pattern {
namespace {

/// A new format is its own file and one line here.
const std::vector<Format>& registry() {
  static const std::vector<Format> all = {json_format(), svg_format(), dxf_format()};
  return all;
}

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.rfind('.'), slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = path.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

const Format& format_of(const std::string& path) {
  const std::string ending = ending_of(path);
  base::Texts endings;
  for (const Format& format : registry()) {
    if (format.ending == ending) return format;
    endings.push_back(format.ending);
  }
  throw base::InputError(
      path + ": " +
      (ending.empty() ? "the name has no ending that tells the format" : "unknown ending \"" + ending + "\"") +
      base::hint(ending, endings));
}

}  // namespace

std::vector<std::string> formats() {
  std::vector<std::string> lines;
  for (const Format& format : registry()) lines.push_back(format.ending + " (" + format.name + ")");
  return lines;
}

Pattern read_pattern(const std::string& path) {
  const Format& format = format_of(path);
  base::require_file(path, "a file of patterns");
  Pattern pattern = format.read(path);
  try {
    if (pattern.panels.empty()) throw base::InputError("there is no panel in this file");
    for (Panel& panel : pattern.panels) orient(panel);
    check(pattern);
  } catch (const base::InputError& error) {
    throw base::InputError(path + ": " + error.what());
  }
  return pattern;
}

void write_pattern(const Pattern& pattern, const std::string& path) {
  const Format& format = format_of(path);
  check(pattern);
  format.write(pattern, path);
}

std::string temporary_name(const std::string& path) {
  return path + "." + std::to_string(getpid()) + ".part";
}

void put_in_place(const std::string& temporary, const std::string& path, bool whole) {
  if (whole && std::rename(temporary.c_str(), path.c_str()) == 0) return;
  const std::string reason = std::strerror(errno);
  std::remove(temporary.c_str());
  throw base::InputError(path + ": cannot write this file: " + reason);
}

void replace_content(const std::string& path, const std::string& content) {
  const std::string temporary = temporary_name(path);
  std::ofstream file(temporary, std::ios::binary);
  file << content;
  file.close();
  put_in_place(temporary, path, !file.fail());
}

std::string number_text(double value) {
  const double rounded = std::round(value * 1e6) / 1e6 + 0.0;  // no "-0"
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, rounded).ptr};
}

}  // namespace toile::pattern
