#pragma once

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Layers of ASTM D6673 (AAMA) that are read and written.
namespace dxf_layer {
constexpr const char* boundary = "1";
constexpr const char* turn_points = "2";
constexpr const char* curve_points = "3";
constexpr const char* notches = "4";
constexpr const char* grain = "7";
constexpr const char* lines = "8";
constexpr const char* cutouts = "11";
constexpr const char* sew_lines = "14";
constexpr const char* notes = "15";
}  // namespace dxf_layer

/// Texts of the standard, and of our notes that carry names; each stands on what it names.
namespace dxf_text {
constexpr const char* units = "UNITS:";
constexpr const char* piece = "PIECE NAME:";
constexpr const char* edge = "EDGE:";
constexpr const char* notch = "NOTCH:";
constexpr const char* line = "LINE:";
}  // namespace dxf_text

Pattern read_dxf(const std::string& path);

}  // namespace toile::pattern
