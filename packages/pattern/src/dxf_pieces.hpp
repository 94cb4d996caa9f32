#pragma once

#include <string>
#include <vector>

#include "toile/pattern/curve.hpp"

namespace toile::pattern::dxf {

struct Vertex {
  Vec2 at;
  double bulge = 0.0;  ///< tangent of a quarter of the arc's angle to the next vertex; 0: a line
};

struct Line {
  std::string layer;
  std::vector<Vertex> vertices;
  bool closed = false;
};

struct Point {
  std::string layer;
  Vec2 at;
};

struct Text {
  std::string words;
  Vec2 at;
};

/// What one block of the file holds, in the file's units.
struct Piece {
  std::string name;
  std::vector<Line> lines;
  std::vector<Point> points;
  std::vector<Text> texts;
};

struct File {
  std::vector<Piece> blocks;
  Piece outside;    ///< of all blocks
  double mm = 0.0;  ///< of the file's unit; 0: it does not tell
};

/// Throws InputError that begins with the path.
File read_pieces(const std::string& path);

/// Text after a keyword, which counts in upper and lower case; empty if the text does not begin with it.
std::string after(const std::string& text, const std::string& keyword);

}  // namespace toile::pattern::dxf
