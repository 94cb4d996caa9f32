#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::dress {

/// How a pattern is put on a body.
struct Options {
  double scale = 1.0;          ///< of the pattern, its places in space included
  std::optional<double> hem;   ///< height of its lowest point, mm; none: its shoulder seams tell it
  double element_size = 12.0;  ///< mm
};

/// How wide the closed garment is in its pattern, and how wide the body is there; mm.
struct Girth {
  std::string of;   ///< "trunk", "left sleeve", "right sleeve"
  double at = 0.0;  ///< height of a trunk, distance from the shoulder along the arm of a sleeve
  double garment = 0.0;
  double body = 0.0;  ///< as a tape measures it

  double stretch() const { return body / garment; }
};

/// A sleeve of one panel round the arm, in the body's coordinates, mm (placement "free wrap").
struct Wrap {
  std::string panel;
  body::Vec3 bottom, top;       ///< of the arm's axis, towards the hand and at the shoulder
  body::Vec3 zero;              ///< where the panel's middle lies, seen from the axis
  double from = 0.0, to = 0.0;  ///< heights along the axis
  double radius = 0.0;
};

/// A pattern beside its body, to be draped onto it.
struct Dressed {
  pattern::Pattern pattern;       ///< scaled; placed with y up, z to the front, in the body's coordinates otherwise
  std::vector<Wrap> wraps;        ///< of the panels that do not start where the pattern places them
  std::vector<std::string> hems;  ///< lowest edges of the trunk that nothing is sewn to: "front.edge4"
  std::vector<Girth> girths;      ///< of the trunk from the hem up to the armholes, then of the sleeves
  Girth tightest;                 ///< of them, the one with the largest stretch
  double fitting_scale =
      1.0;  ///< of the pattern as it is in its file, at which the tightest place is as the body; 0: none
  double lowest = 0.0, armholes = 0.0, highest = 0.0;  ///< heights of the trunk's parts, mm
  std::vector<std::string> lines;                      ///< what was found, for the user
};

/// Places the panels of a garment for the upper body beside a standing body (z up, front towards -y, mm): those of the
/// trunk flat in front of it and behind it at the height at which their shoulder seams lie on the shoulders, halves of
/// sleeves in front of the arms and behind them, whole sleeves round the arms.
/// Throws InputError for panels that are not placed in space, a body without what is needed, a pattern or a sleeve that
/// is far too narrow or too wide (with the scale that would fit), elements that are too long.
Dressed dress(const pattern::Pattern& pattern, const body::TriangleMesh& body, const Options& options);

/// What the scene of a dressed body names.
struct SceneFiles {
  std::string title;
  std::string body;          ///< file, seen from the scene's folder
  double body_scale = 1.0;   ///< mm per unit of it
  std::string pattern;       ///< file, likewise
  std::string fabric;        ///< set of parameters of the rebar fabric, for instance "t-shirt"
  double element_size = 12;  ///< mm
};

/// The scene that drapes and settles what dress() has placed, as XML.
std::string scene_text(const Dressed& dressed, const SceneFiles& files);

}  // namespace toile::dress
