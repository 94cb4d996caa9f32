#include "body_input.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>

namespace toile::app {

void add_body_file(CLI::App* command, BodyFileArguments& arguments) {
  command->add_option("body", arguments.file, "OBJ, STL, PLY or OFF file")->required();
  command->add_option("--scale", arguments.scale, "Factor that turns the coordinates of the file into mm")
      ->check(CLI::PositiveNumber);
  command->add_option("--up", arguments.up, "Axis of the file that is the height")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command->add_flag("--any-size", arguments.any_size, "Not 300 to 3000 mm high: a part of a body, a doll");
  command->add_flag("--open", arguments.open, "The surface may have borders");
}

body::Import read_body(const BodyFileArguments& arguments) {
  body::ImportOptions options;
  options.scale = arguments.scale;
  options.up = arguments.up == "x" ? body::Axis::x : arguments.up == "y" ? body::Axis::y : body::Axis::z;
  options.closed = !arguments.open;
  if (arguments.any_size) {
    options.least_height = 0.0;
    options.greatest_height = std::numeric_limits<double>::max();
    options.up_is_known = true;
  }
  body::Import import = body::import_body(arguments.file, options);
  if (!import.notes.empty()) std::cerr << "toile: " << arguments.file << ": " << import.notes << std::endl;
  return import;
}

void tell_warnings(const body::Landmarks& landmarks) {
  for (const std::string& text : landmarks.warnings) std::cerr << "toile: warning: " << text << std::endl;
}

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::ostringstream out;
  for (const auto& row : rows) {
    std::ostringstream line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line << (i == 0 ? "" : "  ") << (i == 0 ? std::left : std::right) << std::setw(static_cast<int>(widths[i]))
           << row[i];
    std::string text = line.str();
    text.erase(text.find_last_not_of(' ') + 1);
    out << text << '\n';
  }
  return out.str();
}

std::string decimals(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  const double unit = std::pow(10.0, digits);
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << std::round(value * unit) / unit + 0.0;  // no "-0.0"
  return text.str();
}

}  // namespace toile::app
