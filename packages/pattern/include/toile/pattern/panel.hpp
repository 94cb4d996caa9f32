#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "toile/pattern/curve.hpp"

namespace toile::pattern {

/// One named side of a loop.
struct Edge {
  std::string name;  ///< unique in its panel
  Curve curve;
};

/// Edges that follow each other to a closed line.
using Loop = std::vector<Edge>;

/// A mark on an edge that is matched when the garment is sewn, and by which parts of edges are named.
struct Notch {
  std::string name;  ///< unique in its panel
  std::string edge;  ///< name
  double at = 0.0;   ///< relative arc length along it
};

/// A line inside a panel: a fold, the border of a zone of another fabric, a pocket's place.
struct InternalLine {
  std::string name;
  Curve curve;
};

/// Where the panel's wale direction lies, drawn as a line in its pattern.
struct Grain {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

/// How a panel is turned and moved from the pattern's plane into space.
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< mm
};

/// A flat piece of fabric as it is cut, mm. Its outline runs counter-clockwise seen from the right side of the fabric.
struct Panel {
  std::string name;
  Loop outline;
  std::vector<Loop> holes;  ///< clockwise
  std::vector<InternalLine> lines;
  std::vector<Notch> notches;
  std::optional<Grain> grain;
  std::optional<Placement> placement;

  /// The edge of this name, of the outline or a hole; null if there is none.
  const Edge* edge(const std::string& name) const;
};

/// Two parts of edges that are sewn together.
struct Stitch {
  std::string name;
  std::string first, second;  ///< "panel.edge", see EdgePart
  bool reversed = false;      ///< the start of the first meets the end of the second
};

/// What a file of patterns holds.
struct Pattern {
  std::vector<Panel> panels;
  std::vector<Stitch> stitches;
};

/// A part of an edge, between two relative arc lengths.
struct EdgePart {
  const Edge* edge = nullptr;
  double from = 0.0, to = 1.0;
};

/// The edge or part of an edge that a name stands for: "armhole", "armhole[notch1:end]", "armhole[0.25:0.5]",
/// "armhole[start:30mm]": bounds are "start", "end", a notch on this edge, a relative arc length, or an arc length with
/// the unit mm. Throws InputError with what is valid.
EdgePart find_part(const Panel& panel, const std::string& name);

/// One side of a stitch.
struct Side {
  const Panel* panel = nullptr;
  EdgePart part;
};

/// The part of an edge that "panel.edge" or "panel.edge[from:to]" stands for. Throws InputError with what is valid.
Side find_side(const Pattern& pattern, const std::string& name);

/// Makes the outline counter-clockwise and the holes clockwise; edges that turn keep their names and notches their
/// places.
void orient(Panel& panel);

/// A piece that is cut on a fold: the other half is the mirror image in its edge `fold`, which is straight, and which
/// becomes the internal line of that name. Edges of the other half are called "<edge>.mirrored", its notches alike; an
/// edge that meets the fold at a right angle goes on as one edge. Throws InputError if there is no such edge, or if it
/// is bent.
Panel unfolded(const Panel& panel, const std::string& fold);

/// Throws InputError that names the panel and the place: for a loop that is open or crosses or touches itself or
/// another one, a hole outside of the outline, an edge without length, equal names, a notch on no edge. Gaps of up to
/// 1e-6 of the outline's length count as closed.
void check(const Panel& panel);

/// check() of all panels; panels and stitches of equal names, a stitch to an edge that does not exist.
void check(const Pattern& pattern);

}  // namespace toile::pattern
