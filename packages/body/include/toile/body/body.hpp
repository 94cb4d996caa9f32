#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/analytic.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Where a garment can touch the body: triangles outside are left out of trees and fits. Bodies given by a formula do
/// not need it.
struct Region {
  Vec3 lower = Vec3::Constant(-std::numeric_limits<double>::infinity());  ///< mm
  Vec3 upper = Vec3::Constant(std::numeric_limits<double>::infinity());   ///< mm
  Vec3 direction = Vec3::UnitZ();                                         ///< unit
  double bottom = -std::numeric_limits<double>::infinity();               ///< of points x . direction, mm
  double top = std::numeric_limits<double>::infinity();
  /// Of the pieces that the bounds cut out of the body (two legs), only the one nearest to this point is kept, mm.
  std::optional<Vec3> seed;
  /// What continues that piece beyond the bounds by up to this much is kept as well, mm. The other pieces are not
  /// reached through it: a thigh is continued on the hip, not down the other leg.
  double margin = 0.0;
};

/// Another unit that makes a person of a body from a file.
struct OtherUnit {
  const char* name = "";
  double scale = 1.0;   ///< mm
  double height = 0.0;  ///< mm, of the body in it
};

/// What is said of a body before it is worn.
struct BodyFindings {
  std::vector<std::string> warnings;
  double scale = 1.0;   ///< of the list, mm
  double height = 0.0;  ///< mm, in it
  /// If the scale is given, makes no person of the body, and nothing says that it is a part of one.
  std::optional<OtherUnit> person;
  /// z between which the list gives the body's shape, mm; beyond, it goes on straight. Empty: everywhere.
  std::optional<std::array<double, 2>> known_heights;
};

/// Description of the scene's list "Body".
base::Spec body_spec();

/// The body that the validated list describes. `region` (may be null): where the garment can reach; what the list
/// itself says in "Reach" goes before it. Files are looked for in the folder of the scene file.
/// `findings` (may be null): what is suspicious. Throws InputError for a file that cannot be used, saying why.
SurfacePtr make_surface(const base::List& list, const Region* region, BodyFindings* findings = nullptr);

}  // namespace toile::body
