#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parts.hpp"
#include "toile/body/landmarks.hpp"
#include "toile/body/section.hpp"

namespace toile::dress {

/// An arm from the shoulder on.
struct Arm {
  Vec3 shoulder, direction;  ///< mm; unit, towards the hand
};

/// A standing body in the axes of patterns: x to its left, y up, z to the front; mm.
class Wearer {
 public:
  explicit Wearer(const body::TriangleMesh& mesh);

  /// From the axes of patterns to those of the body's file: z up, the front towards -y.
  static Vec3 in_space(const Vec3& at) { return {at.x(), -at.z(), at.y()}; }

  /// What the search for its landmarks had to take for granted.
  const std::vector<std::string>& warnings() const { return landmarks_.warnings; }
  double middle() const { return middle_; }  ///< x of its plane of symmetry
  double lower() const { return lower_; }    ///< of y
  double upper() const { return upper_; }
  /// What a tape round trunk or legs measures at a height below the armpits; 0: there is no body.
  double girth(double height) const;
  /// What a tape round an arm measures across it, so far from the shoulder; 0: there is none.
  double girth(const Arm& arm, double along) const;
  /// Height of the body's surface at this x; none beside the body.
  std::optional<double> top(double x) const;
  /// How much longer the way from its highest point at this x down to a height is than the height, over the front or
  /// the back, taut.
  double detour(double x, double height, bool front) const;
  /// The largest z, or the smallest, of the body within a rectangle of x and y; none if it is not there.
  std::optional<double> depth(const Vec3& lower, const Vec3& upper, bool front) const;
  /// Throws InputError if the body does not show it, with the reason.
  Arm arm(int side) const;
  /// How far from the middle its shoulder is; none: it shows none.
  std::optional<double> shoulder() const;

 private:
  std::vector<body::SectionPiece> cut(const Vec3& point, const Vec3& normal) const;

  std::vector<Vec3> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  body::Sections sections_;
  body::Landmarks landmarks_;
  std::string no_landmarks_;  ///< why there are none
  double middle_ = 0.0, lower_ = 0.0, upper_ = 0.0;
  double armpits_ = infinite;             ///< height of the lower one; above it arms and trunk are one section
  mutable std::map<int, double> girths_;  ///< by height in steps
};

}  // namespace toile::dress
