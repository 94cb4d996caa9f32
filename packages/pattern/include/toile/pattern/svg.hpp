#pragma once

#include <string>
#include <vector>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

struct SvgOptions {
  bool grid = false;  ///< lines every 10 mm, stronger every 100 mm
};

/// One drawing in true scale: outlines as exact paths, seams coloured alike on both sides, grain, notches, internal
/// lines, names. Panels stand side by side. Throws InputError if the file cannot be written.
void write_svg(const Pattern& pattern, const std::string& path, const SvgOptions& options = {});

/// The same drawing in pages of A4 to print (in true size) and glue: one file a page, `<path>-<row>-<column>.svg`, of
/// the pages on which something lies. What is in the frame of a page, 190 mm by 277 mm, continues at the frame of the
/// next. Returns the files. Throws InputError if one cannot be written.
std::vector<std::string> write_svg_pages(const Pattern& pattern, const std::string& path,
                                         const SvgOptions& options = {});

}  // namespace toile::pattern
