#pragma once

#include <string>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// A format of files of patterns. Readers give panels as the file has them; read_pattern() orients and checks.
struct Format {
  std::string ending;  ///< lower case, with its dot
  std::string name;
  Pattern (*read)(const std::string& path);
  void (*write)(const Pattern& pattern, const std::string& path);
};

Format json_format();
Format svg_format();
Format dxf_format();

/// Coordinates beyond this are no garment's but a fault of the file, mm.
constexpr double largest_coordinate = 1e6;
/// Size of a file of patterns at most, bytes.
constexpr std::size_t largest_file = 64U << 20U;

/// Puts `content` in the place of the file. Throws InputError.
void replace_content(const std::string& path, const std::string& content);

/// Name of the file beside `path` that is written first.
std::string temporary_name(const std::string& path);

/// Throws InputError unless `temporary` was written whole; moves it to `path`.
void put_in_place(const std::string& temporary, const std::string& path, bool whole);

/// Shortest text of a length that is rounded to 1e-6 mm.
std::string number_text(double value);

}  // namespace toile::pattern
