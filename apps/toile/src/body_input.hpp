#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "toile/body/import.hpp"
#include "toile/body/landmarks.hpp"

namespace toile::app {

/// What the command line says of a body's file.
struct BodyFileArguments {
  std::string file;
  double scale = 1.0;     ///< mm per unit of the file
  std::string up = "z";   ///< axis of the file that is the height
  bool any_size = false;  ///< a part of a body, or a doll
  bool open = false;      ///< borders are allowed
};

void add_body_file(CLI::App* command, BodyFileArguments& arguments);
/// Reads it; what was repaired is told on the standard error. Throws InputError.
body::Import read_body(const BodyFileArguments& arguments);

/// What the search for landmarks had to take for granted, on the standard error.
void tell_warnings(const body::Landmarks& landmarks);

/// Rows of cells, the first of them the head; the first column is set to the left, all others to the right.
std::string text_table(const std::vector<std::vector<std::string>>& rows);
/// A number with so many decimals.
std::string decimals(double value, int digits);

}  // namespace toile::app
