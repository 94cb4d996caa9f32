#pragma once

#include <vector>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// A part of a pattern's plane, drawn as a polygon that may go beyond the panel.
struct Area {
  std::string name;
  std::vector<Vec2> border;  ///< corners one after another, either way round, mm
};

/// The whole of a panel between two heights y of its pattern, mm.
Area band(const Panel& panel, const std::string& name, double low, double high);

/// The borders of areas inside of a panel, as lines from edge to edge, or from line to line: sides that areas share are
/// there once, and what lies along an edge, or along a line that the panel has already, is left out. The lines are
/// called "<area> border", and "<area> border 2", ... where there are several. Throws InputError, with the area's name
/// and the place, if a border crosses itself, if no fabric lies within it, and if two areas overlap.
std::vector<InternalLine> borders(const Panel& panel, const std::vector<Area>& areas);

}  // namespace toile::pattern
